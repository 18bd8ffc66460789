#pragma once
/// The stress that a body has before it is loaded, from its table or file.

#include "creepcontact/config/config.hpp"
#include "creepcontact/mechanics/stress_field.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::model {

/// A warning tells nodes that are far outside the points of a file.
/// @param mesh  of the body @throws Error if a file cannot be read or lacks components
mechanics::StressField initial_stress(const config::InitialStress& given, const mesh::Mesh& mesh);

}  // namespace creepcontact::model
