#pragma once
/// Plastic flow of all points as one vector, which a run extrapolates over cycles.

#include <span>
#include <vector>

#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"

namespace creepcontact::creep {

/// Numbers of a body: plastic strain, accumulated strain and alpha_i of its points; 0 if it may not yield.
std::size_t flow_size(const Assembly& assembly, std::size_t body);
/// Those of all bodies in turn; empty if nothing may yield.
std::vector<double> flow_vector(const Assembly& assembly, const PlasticHistory& history);
/// Inverse of flow_vector(). Nothing is known of rates then.
void set_flow_vector(const Assembly& assembly, std::span<const double> flow, PlasticHistory& history);

}  // namespace creepcontact::creep
