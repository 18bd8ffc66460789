#pragma once
/// The conditions n_i . u = g_i of one node: which are independent, what displacement they prescribe, and a frame of
/// held and free directions.

#include <optional>
#include <vector>

#include "creepcontact/base/tensor.hpp"

namespace creepcontact::mechanics {

class NodeConditions {
 public:
  /// A condition whose direction is a combination of earlier, independent ones.
  struct Dependent {
    std::vector<std::size_t> on;       ///< labels of the independent conditions it combines
    std::vector<double> coefficients;  ///< its direction = sum of coefficients * their directions
  };

  /// Gram-Schmidt step. @param label  the caller's number of the condition
  /// @returns what it depends on, or nullopt if it holds a new direction
  std::optional<Dependent> add(std::size_t label, const Vector3& direction);

  int n_held() const { return n_held_; }
  std::size_t label(int i) const { return labels_[i]; }
  /// Column i: displacement prescribed by the value 1 of independent condition i, all others 0. 3 x n_held.
  Eigen::Matrix3Xd displacements() const;
  /// Orthonormal; the held directions come first. Coordinate directions where the held space is spanned by them.
  Matrix3 frame() const;

 private:
  int n_held_ = 0;
  Matrix3 held_ = Matrix3::Zero();        // leading columns: orthonormal basis of the held space
  Matrix3 directions_ = Matrix3::Zero();  // leading columns: the independent conditions
  std::vector<std::size_t> labels_;
};

}  // namespace creepcontact::mechanics
