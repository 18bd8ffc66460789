#pragma once
/// System's direct solver of Newton systems as the SUNLinearSolver of CVODE and ARKODE. It has no matrix that SUNDIALS
/// could see, but SUNDIALS decides by one when to factor anew: an empty one stands for it.

#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include <memory>

#include "sundials_callbacks.hpp"

namespace creepcontact::ode {

struct LinearSolverDeleter {
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
};
struct MatrixDeleter {
  void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
};

struct TangentSolver {
  /// @param callbacks  must outlive the object; the integrator's linear-system function is theirs too
  TangentSolver(SundialsCallbacks& callbacks, SUNContext context);

  std::unique_ptr<_generic_SUNLinearSolver, LinearSolverDeleter> solver;
  std::unique_ptr<_generic_SUNMatrix, MatrixDeleter> matrix;
};

}  // namespace creepcontact::ode
