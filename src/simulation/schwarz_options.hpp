#pragma once
/// The Schwarz iteration as configured.

#include "creepcontact/config/config.hpp"
#include "creepcontact/simulation/model.hpp"

namespace creepcontact::simulation {

/// @param model  with its bodies
contact::SchwarzOptions schwarz_options(const config::ContactSolver& config, const Model& model);

}  // namespace creepcontact::simulation
