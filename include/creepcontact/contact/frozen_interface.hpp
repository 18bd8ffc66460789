#pragma once
/// A frozen contact set condensed with factors of other stiffnesses of the same bodies than the elastic ones, such as
/// those of a Newton iteration: its gaps are closed, no other row matters.

#include <span>
#include <vector>

#include "creepcontact/contact/condensed_interface.hpp"
#include "creepcontact/contact/condensed_rows.hpp"
#include "creepcontact/contact/frozen_system.hpp"

namespace creepcontact::contact {

class FrozenInterface {
 public:
  /// @param interface  must be dense
  /// @param active     rows, ascending
  /// @param factors    one a body, with the pattern and the trailing unknowns of the body's own
  /// Cost: n_trailing^2 x n_active operations a body.
  FrozenInterface(const CondensedInterface& interface, const std::vector<int>& active,
                  std::span<const linalg::SupernodalCholesky* const> factors);
  FrozenInterface(const FrozenInterface&) = delete;
  FrozenInterface& operator=(const FrozenInterface&) = delete;

  int n_rows() const { return problem_.n_rows(); }
  /// gap (n_rows) += G^T y2. @param y  L^-1 P f of the body, all free unknowns
  void add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap) const;
  /// Multipliers (n_rows) that close these gaps, and amplitudes of the contact problem's rigid motions. The forces that
  /// opened the gaps have no resultants. @throws SolverError if the rows contradict each other
  ContactState close(const Eigen::VectorXd& gap);
  /// y2 += G lambda
  void add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y) const;

 private:
  struct Side {
    std::vector<int> rows;  // in the set
    CondensedRows condensed;
  };
  std::vector<Side> sides_;
  ContactProblem problem_;  // of the set alone
  std::vector<int> all_;    // its rows: 0, 1, 2 ...
  FrozenSystem frozen_;
};

}  // namespace creepcontact::contact
