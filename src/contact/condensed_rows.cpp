#include "creepcontact/contact/condensed_rows.hpp"

namespace creepcontact::contact {

CondensedRows::CondensedRows(const RowMatrix& rows, std::span<const std::int64_t> trailing,
                             const linalg::StiffnessSolver& factor) {
  std::vector<int> position(rows.cols(), -1);
  for (std::size_t i = 0; i < trailing.size(); ++i) position[trailing[i]] = static_cast<int>(i);
  traces_.setZero(trailing.size(), rows.rows());
  for (int r = 0; r < rows.outerSize(); ++r)
    for (RowMatrix::InnerIterator it(rows, r); it; ++it)
      if (const int i = position[it.col()]; i >= 0) traces_(i, r) = it.value();
  if (traces_.size() == 0) return;
  const Eigen::MatrixXd trailing_factor = factor.trailing_factor();
  trailing_factor.triangularView<Eigen::Lower>().solveInPlace(traces_);
}

Eigen::VectorXd CondensedRows::gaps(std::span<const double> y) const {
  const Eigen::Map<const Eigen::VectorXd> all(y.data(), y.size());
  return traces_.transpose() * all.tail(traces_.rows());
}

void CondensedRows::add_forces(const Eigen::VectorXd& multiplier, std::span<double> y) const {
  Eigen::Map<Eigen::VectorXd> all(y.data(), y.size());
  all.tail(traces_.rows()).noalias() += traces_ * multiplier;
}

}  // namespace creepcontact::contact
