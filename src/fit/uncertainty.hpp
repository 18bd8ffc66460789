#pragma once
/// How well a minimum is determined, and what the residuals say of the law.

#include "creepcontact/fit/fit.hpp"
#include "least_squares.hpp"
#include "parameter_space.hpp"

namespace creepcontact::fit {

/// Fills parameters, correlation, deviation and warnings of a result whose residuals are known.
/// @param minimum  its unknowns are those of the space, and perhaps others after them
/// @returns the covariance of all unknowns @throws ConfigError if the data cannot tell parameters apart
Eigen::MatrixXd add_uncertainty(const TestData& data, const ParameterSpace& space, const LeastSquares& problem,
                                const Minimum& minimum, FitResult& result);

}  // namespace creepcontact::fit
