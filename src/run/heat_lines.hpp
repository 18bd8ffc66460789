#pragma once
/// Heat in the words of `check` and `run`.

#include <string>

#include "creepcontact/config/config.hpp"
#include "creepcontact/heat/conduction.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/results/heat_flows.hpp"

namespace creepcontact::run {

/// @param scale  heat::Conduction::flow_scale(); where nothing but rounding flows, all is zero
io::Summary::Heat recorded(const heat::Definition& definition, const heat::Balance& balance, double scale);
/// The heat that flows in a state.
io::Summary::Heat recorded(results::HeatFlows& flows, results::Snapshot& snapshot);

/// A line for each flow, what is stored, and what is missing in the sum.
std::string balance_lines(const io::Summary::Heat& heat);

/// A loop gain (see io::Summary::Heat) above this deserves a warning.
constexpr double large_loop_gain = 0.5;
constexpr const char* loop_gain_warning =
    "; above 1 the joint loses its pressure, or takes it up, at the speed of heat";

/// What `check` says of films, and of the heat in the steady state of the end, if there is one. Empty without heat.
/// Cost: a few factorisations of the conduction
std::string heat_check(const config::Config& config, const model::Model& model);

}  // namespace creepcontact::run
