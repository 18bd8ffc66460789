#pragma once
/// Rigid-body modes: the motions of bodies that their own supports leave free, and which of them contact holds. Contact
/// holds the combinations that open or close gaps or, with friction, slide. Nothing holds the unconstrained ones, such
/// as a ring turning on its shaft without friction; they must not be loaded.

#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::contact {

/// Modes of all bodies of a model. Immutable.
class RigidBodyModes {
 public:
  using Bodies = std::span<const mechanics::Body>;

  /// @param bodies  must outlive the object @param pairs  with numbered rows
  /// Cost: sparse products with the contact rows, and the singular values of an n_rows x n_motions matrix.
  RigidBodyModes(Bodies bodies, std::span<const Pair> pairs);

  /// @throws ModelError naming the bodies that can move and have no contact
  void require_contact(std::span<const Pair> pairs) const;

  /// Number of rigid-body modes of all bodies; they are numbered body after body.
  Index size() const { return held_.rows(); }
  std::size_t first_of_body(std::size_t body) const { return first_[body]; }
  /// Orthonormal bases, size() rows: the combinations that contact holds, and the unconstrained ones.
  const Eigen::MatrixXd& held() const { return held_; }
  const Eigen::MatrixXd& unconstrained() const { return unconstrained_; }
  /// Gaps that unit motions of one body open: contact rows of all pairs x rigid-body modes of the body.
  Eigen::MatrixXd gaps(std::size_t body, std::span<const Pair> pairs) const;

  /// "body 'ring': rotation about the axis (0, 0, 1) through (0, 0, 0)"; bodies that move together are joined by "and".
  /// @param amplitudes  of all rigid-body modes, size()
  std::string describe(const Eigen::VectorXd& amplitudes) const;
  /// One description per unconstrained mode, without repetitions.
  std::vector<std::string> describe_unconstrained() const;

  /// Motions along which a pair would slide freely if it had neither facets (gap rates below 0.3 %) nor friction, as
  /// relative motions of the two bodies: one list per pair. If its coupling is built again with these
  /// (mortar_coupling), they become exactly unconstrained.
  std::vector<std::vector<mechanics::RigidMotion>> sliding(std::span<const Pair> pairs) const;

 private:
  static Eigen::MatrixXd combinations_below(const Eigen::MatrixXd& rates, double limit, Eigen::MatrixXd* others);

  Bodies bodies_;
  std::vector<std::size_t> first_;
  Eigen::MatrixXd rates_;          // triangular; singular values: root-mean-square gap rates of unit combinations
  Eigen::MatrixXd sliding_rates_;  // the same without the tangential rows of contacts with friction
  Eigen::MatrixXd held_, unconstrained_;
};

}  // namespace creepcontact::contact
