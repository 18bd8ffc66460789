#pragma once
/// The model as `check --fields` shows it: which groups have supports, loads and contacts, and what the bodies'
/// surfaces are.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/model/model.hpp"

namespace creepcontact::run {

/// Something of the configuration that acts on a group of the mesh, or at a node.
struct Mark {
  enum class Kind { support, load, contact };
  Kind kind = Kind::support;
  std::size_t number = 0;              ///< of the entry in [[supports]], [[loads]], [[contacts]]
  std::string name;                    ///< "support 'symmetry_x': x"
  std::string group;                   ///< empty: at the node next to `position`
  std::string body;                    ///< it is restricted to this body; empty: all
  Vector3 position = Vector3::Zero();  ///< without a group

  bool acts_on(const mechanics::Body& of) const {
    return (body.empty() || body == of.name()) && of.mesh().groups.contains(group);
  }
};

/// In the order supports, loads, contacts (slave, then master). Loads on whole bodies have no mark.
std::vector<Mark> marks(const config::Config& config, const model::Model& model);

/// The picture of the model as the job that draws it (plot::picture_job()), for reports; empty if the surface has too
/// many faces for one.
std::string model_picture_job(const config::Config& config, const model::Model& model);

/// Writes `model.pvd`, `groups.pvd` with their files, and the picture `plots/model.png` into a directory.
/// Without VTK there is a warning and no picture.
/// @returns the files for people to open @throws ConfigError if the directory cannot be made; Error if the disk is full
std::vector<std::filesystem::path> write_model_view(const config::Config& config, const model::Model& model,
                                                    const std::filesystem::path& directory);

}  // namespace creepcontact::run
