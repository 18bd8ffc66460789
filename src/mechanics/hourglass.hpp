#pragma once
/// Weak stiffness against the motions that the reduced integration of hex20 and quad8 does not see (hourglass modes).

#include "creepcontact/linalg/stiffness_solver.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

bool has_hourglass_modes(mesh::CellType type);

/// Adds, for every element of such a type, 1e-6 of its own stiffness times the part of the nodal displacements that no
/// quadratic polynomial of the place represents. Quadratic displacements, and with them all patch tests, are left
/// alone; hourglass modes are not quadratic polynomials. Elements in a row one behind the other need it: neighbours on
/// two sides do not hold these modes as those in a block do.
/// @param diagonal  of the elastic stiffness, by which an element's own is measured
/// @param lower     over all 3 n_nodes unknowns, as Discretization::stiffness() makes it
void add_hourglass_stiffness(const mesh::Mesh& mesh, const Eigen::VectorXd& diagonal, linalg::SparseMatrix& lower);

}  // namespace creepcontact::mechanics
