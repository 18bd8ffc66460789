#pragma once
/// Motions of the bodies that their own supports leave free, and what contact makes of them: combinations that open or
/// close gaps are held by contact; the idle ones (a ring turning on its shaft without friction) are held by nothing and
/// must not be loaded.

#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::contact {

class FloatingMotions {
 public:
  using Bodies = std::span<const mechanics::Body>;

  /// @param bodies  must outlive the object
  /// Cost: sparse products with the contact rows, and the singular values of n_rows x n_motions.
  FloatingMotions(Bodies bodies, std::span<const Pair> pairs);

  /// @throws ModelError naming the bodies that can move and are in no contact
  void require_contact(std::span<const Pair> pairs) const;

  /// Free motions of all bodies, body after body.
  Index size() const { return held_.rows(); }
  std::size_t first_of_body(std::size_t body) const { return first_[body]; }
  /// Orthonormal bases, size() rows: combinations that contact holds, and idle ones.
  const Eigen::MatrixXd& held() const { return held_; }
  const Eigen::MatrixXd& idle() const { return idle_; }
  /// Gaps that unit motions of one body open: contact rows of all pairs x motions of the body.
  Eigen::MatrixXd gaps(std::size_t body, std::span<const Pair> pairs) const;

  /// "body 'ring': rotation about the axis (0, 0, 1) through (0, 0, 0)", bodies that move together joined by "and".
  std::string describe(const Eigen::VectorXd& amplitudes) const;
  /// The same for every idle motion.
  std::vector<std::string> describe_idle() const;

  /// Motions along which a pair would slide but for the facets of its meshes (gap rates below 0.3 %): their relative
  /// motions, one list a pair. A coupling made anew with these normals leaves them idle exactly.
  std::vector<std::vector<mechanics::RigidMotion>> sliding(std::span<const Pair> pairs) const;

 private:
  Eigen::MatrixXd combinations_below(double limit, Eigen::MatrixXd* others) const;

  Bodies bodies_;
  std::vector<std::size_t> first_;
  Eigen::MatrixXd rates_;  // triangular: its singular values are root-mean-square gap rates of unit combinations
  Eigen::MatrixXd held_, idle_;
};

}  // namespace creepcontact::contact
