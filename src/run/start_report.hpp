#pragma once
/// What `check --start` says of the state at t = 0.

#include <string>

#include "creepcontact/config/config.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/run/run.hpp"

namespace creepcontact::run {

/// Solves t = 0 as the run would. One line per contact: normal force, peak pressure, slave elements across the contact
/// zone; with friction also the slip, and what twice as many substeps of the first load change. One line per body:
/// largest von Mises stress, times in which it relaxes.
/// @throws Error whatever the run would be refused or end with before its first step
/// Cost: the factorisations and some elastic solves; with friction also 3 initial_substeps contact problems.
std::string start_report(const config::Config& config, const model::Model& model, const Processes& processes);

}  // namespace creepcontact::run
