#pragma once
/// Arrays as vectors of linear algebra.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "creepcontact/base/index.hpp"

namespace creepcontact::creep {

inline Eigen::Map<Eigen::VectorXd> vector(std::vector<double>& values) {
  return {values.data(), static_cast<Index>(values.size())};
}
inline Eigen::Map<const Eigen::VectorXd> vector(const std::vector<double>& values) {
  return {values.data(), static_cast<Index>(values.size())};
}
inline Eigen::Map<Eigen::VectorXd> vector(std::span<double> values) {
  return {values.data(), std::ssize(values)};
}
inline Eigen::Map<const Eigen::VectorXd> vector(std::span<const double> values) {
  return {values.data(), std::ssize(values)};
}

}  // namespace creepcontact::creep
