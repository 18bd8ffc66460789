#pragma once
/// Solvers of the stiffness in the place of CHOLMOD's, for small models.

#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::run::test {

/// Dense Cholesky factors; the trailing unknowns come last in the order.
std::unique_ptr<linalg::StiffnessSolver> dense_cholesky(const linalg::StiffnessToAnalyze& matrix);

/// Makes solvers without a factor that are wrong by exactly this error bound, up or down, in every component of the
/// solution in terms of the Cholesky factor.
linalg::StiffnessSolverFactory inexact_solvers(double error);

/// A solver that asks for more memory than there is, and must not be used.
std::unique_ptr<linalg::StiffnessSolver> without_memory(const linalg::StiffnessToAnalyze& matrix);

}  // namespace creepcontact::run::test
