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

}  // namespace creepcontact::creep
