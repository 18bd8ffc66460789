#pragma once
/// Which process has which elements.

#include <cstdint>
#include <vector>

#include "creepcontact/base/team.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mpi {

/// Deals out the bulk cells of all bodies, each body in connected pieces of equal work (METIS); bodies of a few
/// elements per process stay whole, each in the process that has least. Processes may get none. All processes get
/// this result. Collective.
/// @param bodies  one mesh per body @returns per body the rank of every bulk cell
std::vector<std::vector<std::int32_t>> partition(const std::vector<const mesh::Mesh*>& bodies, const Team& team);

}  // namespace creepcontact::mpi
