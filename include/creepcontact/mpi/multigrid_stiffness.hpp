#pragma once
/// Approximate inverse of a stiffness matrix whose elements are spread over the processes of MPI, by algebraic
/// multigrid (PETSc's GAMG) accelerated by a Chebyshev polynomial. Its memory and its work grow in proportion to the
/// unknowns, those of a factor faster: it is for models whose factor no memory holds.
///
/// The polynomial has a fixed degree, so that the inverse is a linear, symmetric operator: all that holds for solves
/// with the stiffness of an earlier time (creep/equilibrium_solver.hpp) holds for it, contact included. A Krylov method
/// would need fewer cycles, but each of its solves is another operator.
/// Source: smoothed aggregation, Vanek, Mandel and Brezina (1996); Chebyshev iteration, Golub and Varga (1961).

#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::mpi {

/// Makes solvers shared by all processes; every call of them but forward() is collective, and matrices and right-hand
/// sides are parts of sums as for mumps_cholesky(). All processes have the whole solution.
/// StiffnessSolver::factorize() chooses the degree, from the extreme eigenvalues that conjugate gradients find.
/// PETSC_OPTIONS may replace the multigrid, as in "-pc_type hypre".
/// @param error  StiffnessSolver::error_bound(), in (0, 1)
/// @throws SolverError from factorize() if the multigrid is too poor an approximation; linalg::SingularMatrix never
linalg::StiffnessSolverFactory multigrid_stiffness(double error);

}  // namespace creepcontact::mpi
