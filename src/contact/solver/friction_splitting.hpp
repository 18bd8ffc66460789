#pragma once
/// Contact with friction by splitting: slow, and from anywhere.

#include <Eigen/Cholesky>
#include <functional>

#include "friction_newton.hpp"

namespace creepcontact::contact {

/// Douglas and Rachford's iteration (1956; Lions and Mercier 1979) on 0 in F lambda + gap + N(lambda), where N is the
/// normal cone of Coulomb's law with the limits mu lambda_n of the present pressures:
///   x = argmin 1/2 x . F x + gap . x + 1/2 |x - z + u|_R^2  with N^T x + resultant = 0,   z = P(x + u),   u += x - z
/// With given limits the problem is convex, and this converges from anywhere; so it does where the limits follow the
/// pressures and friction_kappa() is below 1. Slip has the direction of the traction. Needs the matrix F.
class FrictionSplitting {
 public:
  /// @param rows  must outlive the object @param scale  R = scale diag F: small ones take long steps of the multipliers
  /// Cost: a Cholesky factorisation of all rows.
  FrictionSplitting(const FrictionRows& rows, double scale);

  /// Iterates from state.multiplier to a change of `tolerance` of the largest multiplier in an iteration; without
  /// convergence too the state is that of the last one. Each iteration costs one solution of the linear equations.
  /// @param record  called with the iteration and its change
  void iterate(const ContactLoad& load, double tolerance, int max_iterations,
               const std::function<void(int, double)>& record, FrictionState& state) const;

 private:
  Eigen::VectorXd projected(const ContactLoad& load, Eigen::VectorXd multiplier) const;

  const FrictionRows& rows_;
  Eigen::VectorXd weight_;              // R
  double fixing_flexibility_ = 0;       // c
  Eigen::LLT<Eigen::MatrixXd> factor_;  // F + R + c N N^T
  Eigen::MatrixXd motions_;             // its inverse times N
  Eigen::MatrixXd coarse_inverse_;      // pseudo-inverse of N^T motions_
};

}  // namespace creepcontact::contact
