#pragma once
/// Ownership of a linear solver of SUNDIALS.

#include <sundials/sundials_linearsolver.h>

#include <memory>

namespace creepcontact::ode {

struct LinearSolverDeleter {
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
};
using LinearSolverHandle = std::unique_ptr<_generic_SUNLinearSolver, LinearSolverDeleter>;

}  // namespace creepcontact::ode
