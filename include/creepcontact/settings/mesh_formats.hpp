#pragma once
/// Kinds of mesh files, by their extensions.

#include <algorithm>
#include <array>
#include <string_view>

namespace creepcontact::settings {

/// Meshes of other programs, which the mesher reads: Salome and I-deas, Nastran.
constexpr std::array<std::string_view, 4> converted_meshes{".unv", ".bdf", ".nas", ".med"};

constexpr bool is_converted_mesh(std::string_view extension) {
  return std::ranges::find(converted_meshes, extension) != converted_meshes.end();
}
/// CAD models, which OpenCASCADE reads.
constexpr std::array<std::string_view, 5> cad_files{".step", ".stp", ".iges", ".igs", ".brep"};

/// Whatever the case: CAD programs write .STEP, too.
constexpr bool is_cad_file(std::string_view extension) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::any_of(cad_files,
                             [&](std::string_view known) { return std::ranges::equal(extension, known, {}, lower); });
}
constexpr bool is_mesh_file(std::string_view extension) {
  return extension == ".geo" || extension == ".msh" || extension == ".inp" || is_converted_mesh(extension) ||
         is_cad_file(extension);
}
constexpr std::string_view mesh_files_in_words =
    "a .geo, .step, .iges, .brep, .msh, .med, .inp, .unv, .bdf or .nas file";

}  // namespace creepcontact::settings
