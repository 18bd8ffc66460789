#pragma once
/// Where searches for the minimum begin.

#include <Eigen/Core>
#include <vector>

#include "least_squares.hpp"

namespace creepcontact::fit {

/// Points of a Latin hypercube between two corners: in each unknown one point per n-th part of its range. Equal
/// arguments give equal points.
std::vector<Eigen::VectorXd> latin_hypercube(int n, const Eigen::VectorXd& low, const Eigen::VectorXd& high);

/// The best `n` of many points, best first. @param amplitude  unknown that shifts all residuals alike, which is
/// set so that their mean is zero; the number of unknowns: there is none
std::vector<Eigen::VectorXd> best_starts(const LeastSquares& problem, int n, const Eigen::VectorXd& low,
                                         const Eigen::VectorXd& high, std::size_t amplitude);

}  // namespace creepcontact::fit
