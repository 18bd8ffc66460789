#pragma once
/// Cholesky factor of a stiffness matrix whose elements are spread over the processes of MPI (MUMPS).
/// Source: Amestoy, Duff, L'Excellent and Koster (2001); the two halves of a solve around the Schur complement are
/// described in the MUMPS users' guide, "Reduced/condensed right-hand side".

#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::mpi {

/// A solver shared by all processes; every call is collective. Differences to one of a single process:
/// - analysis and factorize() take the part of the matrix that the elements of this process add; the matrix is the sum;
/// - forward() takes such a part of the right-hand side: only entries of unknowns in the pattern of this process count;
/// - only process 0 has a trailing factor, and the trailing part of y. The rest of y stays inside MUMPS, which keeps
///   one right-hand side: each backward() must follow its own forward();
/// - backward() gives the whole solution to all processes.
/// @throws SolverError on all processes if memory runs out on one
std::unique_ptr<linalg::StiffnessSolver> mumps_cholesky(const linalg::StiffnessToAnalyze& matrix);

}  // namespace creepcontact::mpi
