#pragma once
/// The Schwarz iteration as configured.

#include "creepcontact/config/config.hpp"
#include "creepcontact/model/model.hpp"

namespace creepcontact::model {

/// @param model  with its bodies
contact::SchwarzOptions schwarz_options(const config::ContactSolver& config,
                                        const std::vector<mechanics::Body>& bodies);

}  // namespace creepcontact::model
