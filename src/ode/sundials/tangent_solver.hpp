#pragma once
/// System's direct solver of Newton systems as the SUNLinearSolver of CVODE and ARKODE. It has no matrix that SUNDIALS
/// could see, but SUNDIALS decides by one when to factor again: it gets an empty one.

#include <sundials/sundials_matrix.h>

#include <memory>

#include "linear_solver_handle.hpp"
#include "sundials_callbacks.hpp"

namespace creepcontact::ode {

struct MatrixDeleter {
  void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
};

struct TangentSolver {
  /// @param callbacks  must outlive the object; the integrator's linear-system function is theirs too
  TangentSolver(SundialsCallbacks& callbacks, SUNContext context);

  LinearSolverHandle solver;
  std::unique_ptr<_generic_SUNMatrix, MatrixDeleter> matrix;
};

}  // namespace creepcontact::ode
