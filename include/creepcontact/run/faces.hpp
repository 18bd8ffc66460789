#pragma once
/// What `creepcontact faces` says of a model: its faces, which of them are next to each other, and a configuration to
/// begin with.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/config/vocabulary.hpp"
#include "creepcontact/model/model_faces.hpp"

namespace creepcontact::run {

/// What a face is, in words.
struct FaceWords {
  std::string kind;                  ///< "cylinder, hollow"
  std::string measures;              ///< "radius 30, axis z through (0, 0, 5); area 942"
  std::vector<std::string> next_to;  ///< "gap 0.02: 8 of 'pin'"
};
/// Indexed like the patches.
std::vector<FaceWords> face_words(const model::ModelFaces& faces);

/// A table per body. @param most  faces that are listed; the rest is counted
std::string faces_text(const model::ModelFaces& faces, const std::string& file, std::size_t most);

/// One object: solids, faces, pairs, narrow faces.
std::string faces_json(const model::ModelFaces& faces, const std::string& file);

/// A consistent set of units with this unit of length: "mm, N, MPa, h, degC".
std::string units_with_length(const std::string& unit);

/// A configuration with all bodies, and a contact for each pair of bodies and shape; doubtful ones are comments, with
/// the reason. It reads without errors, and needs material data, supports and loads.
/// @param file  in which it will be written: the path of the mesh is relative to it
std::string proposed_configuration(const model::ModelFaces& faces, const std::filesystem::path& mesh_file,
                                   const std::filesystem::path& file, const config::Vocabulary& vocabulary);

}  // namespace creepcontact::run
