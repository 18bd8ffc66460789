#include "tangent_solver.hpp"

#include <new>

namespace creepcontact::ode {

namespace {

int solve(SUNLinearSolver solver, SUNMatrix, N_Vector z, N_Vector r, realtype) {
  const int failed = static_cast<SundialsCallbacks*>(solver->content)->solve_tangent(r, z);
  if (failed == 0) return SUNLS_SUCCESS;
  return failed > 0 ? SUNLS_PACKAGE_FAIL_REC : SUNLS_PACKAGE_FAIL_UNREC;
}

int free_solver(SUNLinearSolver solver) {
  SUNLinSolFreeEmpty(solver);
  return SUNLS_SUCCESS;
}

}  // namespace

TangentSolver::TangentSolver(SundialsCallbacks& callbacks, SUNContext context)
    : solver(SUNLinSolNewEmpty(context)), matrix(SUNMatNewEmpty(context)) {
  if (!solver || !matrix) throw std::bad_alloc();
  solver->content = &callbacks;
  solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
  solver->ops->getid = [](SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; };
  // The factorisation belongs to the linear-system function, which knows the point and gamma.
  solver->ops->setup = [](SUNLinearSolver, SUNMatrix) -> int { return SUNLS_SUCCESS; };
  solver->ops->solve = solve;
  solver->ops->free = free_solver;
  matrix->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
  matrix->ops->destroy = SUNMatFreeEmpty;
}

}  // namespace creepcontact::ode
