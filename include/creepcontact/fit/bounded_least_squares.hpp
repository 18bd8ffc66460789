#pragma once
/// What creepcontact-optimizer.so does: nonlinear least squares with bounds, by Ceres. Headers only: a program loads
/// the library when it needs it (fit/least_squares.cpp), and need not be linked to Ceres and the BLAS that Ceres
/// brings.

namespace creepcontact::fit {

/// Minimise the sum of squares of r(x), lower <= x <= upper.
struct BoundedLeastSquares {
  int n_unknowns = 0, n_residuals = 0;
  const double* lower = nullptr;  ///< n_unknowns
  const double* upper = nullptr;  ///< n_unknowns
  int max_iterations = 0;
  void* context = nullptr;
  /// Sets n_residuals residuals and, unless null, their derivatives, n_residuals x n_unknowns, row by row.
  /// @returns false where r is not defined: such steps are shortened
  bool (*evaluate)(void* context, const double* x, double* residuals, double* jacobian) = nullptr;
};

/// Levenberg-Marquardt with a projection onto the bounds.
/// @param x  n_unknowns: the start, and the minimum found @returns whether the iteration has converged
using Minimize = bool (*)(const BoundedLeastSquares& problem, double* x);

inline constexpr const char* optimizer_library = "creepcontact-optimizer.so";
inline constexpr const char* optimizer_function = "creepcontact_minimize";

}  // namespace creepcontact::fit
