#pragma once
/// Batches of a steel, each with a factor of its own on one constant of the law.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "creepcontact/fit/fit.hpp"
#include "parameter_space.hpp"

namespace creepcontact::fit {

/// Unknowns after those of the parameters: the differences of all batches but the last, of the logarithm of the
/// constant from its mean. They add up to zero.
class Batches {
 public:
  /// @param data, space  must outlive the object @throws ConfigError if the law has no constant that is a rate or a
  /// stress, or if it is not fitted
  Batches(const TestData& data, const LawChoice& choice, const ParameterSpace& space);

  std::size_t n_unknowns() const { return n_ == 0 ? 0 : n_ - 1; }
  /// The values of the parameters, then those of the differences: `sign` times what is far apart.
  Eigen::VectorXd extended(const Eigen::VectorXd& parameters, double sign) const;
  /// One law, or one for each batch. @param x  of the parameters alone, or with the differences
  std::vector<std::shared_ptr<const material::CreepLaw>> laws(const Eigen::VectorXd& x) const;
  /// @param x  with the differences @param covariance  of all unknowns
  BatchScatter scatter(const Eigen::VectorXd& x, const Eigen::MatrixXd& covariance) const;

 private:
  Eigen::VectorXd differences(const Eigen::VectorXd& x) const;

  const TestData& data_;
  const ParameterSpace& space_;
  std::size_t n_;              // batches
  Eigen::Index constant_ = 0;  // number of the parameter
};

/// Warnings of what so few batches tell.
void warn_of_batches(FitResult& result);

}  // namespace creepcontact::fit
