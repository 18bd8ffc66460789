#pragma once
/// What the record and the picture of a model say of a load.

#include <string>

#include "creepcontact/model/model.hpp"

namespace creepcontact::run {

struct LoadWords {
  std::string place;                   ///< where it acts: a group, "body disc", "node 12"
  std::string text;                    ///< kind and value, with units: "pressure [MPa] = 100"
  std::string label = {};              ///< in the picture of the model; empty: not drawn, acts on all of a body
  Vector3 position = Vector3::Zero();  ///< of a load at a node
};

/// @param load  of this configuration
LoadWords load_words(const config::Load& load, const config::Config& config, const model::Model& model);

/// "(1, 0, 0)"
std::string vector_text(const std::array<double, 3>& v);
std::string vector_text(const std::array<Function, 3>& v);

}  // namespace creepcontact::run
