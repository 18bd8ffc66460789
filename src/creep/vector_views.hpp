#pragma once
/// Arrays as vectors of linear algebra.

#include <Eigen/Core>
#include <vector>

#include "creepcontact/base/index.hpp"

namespace creepcontact::creep {

inline Eigen::Map<Eigen::VectorXd> vector(std::vector<double>& values) {
  return {values.data(), static_cast<Index>(values.size())};
}
inline Eigen::Map<const Eigen::VectorXd> vector(const std::vector<double>& values) {
  return {values.data(), static_cast<Index>(values.size())};
}

}  // namespace creepcontact::creep
