#pragma once
/// Models whose temperature alone is computed: bodies that cannot move.

#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/mechanics/constraints.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::model {

/// The configuration without loads, supports and contact, of materials that do nothing.
config::Config without_mechanics(config::Config config);
/// Holds all nodes of a body.
std::vector<mechanics::Support> hold(const mesh::Mesh& body);

}  // namespace creepcontact::model
