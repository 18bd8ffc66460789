#pragma once
/// Values of the cross-section of a body in generalised plane strain.

#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::results {

double axial_strain(const Snapshot& snapshot, std::size_t body);
/// Collective.
double axial_force(const Snapshot& snapshot, std::size_t body);

}  // namespace creepcontact::results
