#pragma once
/// Solutions of contact, which one process finds, to all.

#include "creepcontact/base/team.hpp"
#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/creep/equilibrium.hpp"

namespace creepcontact::creep {

/// Sets the argument to what member 0 has. Collective.
void broadcast(const Team& team, contact::ContactState& state);
void broadcast(const Team& team, contact::ContactResult& result);
void broadcast(const Team& team, std::vector<PathPoint>& points);

/// Nodes as numbers and back.
std::vector<double> packed(const std::vector<contact::NodeLinearization>& nodes);
std::vector<contact::NodeLinearization> unpacked(const std::vector<double>& values);

}  // namespace creepcontact::creep
