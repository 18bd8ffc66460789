#include "creepcontact/contact/condensed_rows.hpp"

#include <vector>

#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/linalg/dense_products.hpp"

namespace creepcontact::contact {

CondensedRows::CondensedRows(const RowMatrix& rows, std::span<const std::int64_t> trailing,
                             const linalg::StiffnessSolver& factor, bool by_factor) {
  std::vector<int> position(rows.cols(), -1);
  for (std::size_t i = 0; i < trailing.size(); ++i) position[trailing[i]] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  traces_.setZero(trailing.size(), rows.rows());
  for (int r = 0; r < rows.outerSize(); ++r)
    for (RowMatrix::InnerIterator it(rows, r); it; ++it)
      if (const int i = position[it.col()]; i >= 0) {
        traces_(i, r) = it.value();
        entries.emplace_back(i, r, it.value());
      }
  if (traces_.size() > 0) {
    factor_ = factor.trailing_factor();
    linalg::substitute_forward_in_all(factor_, traces_);
  }
  flexibility_ = linalg::products_of_columns(traces_);
  if (by_factor && !trailing.empty()) {
    rows_.resize(traces_.rows(), traces_.cols());
    rows_.setFromTriplets(entries.begin(), entries.end());
    traces_.resize(0, 0);
  } else {
    factor_.resize(0, 0);
  }
}

Eigen::VectorXd CondensedRows::gaps(std::span<const double> y) const {
  const Eigen::Map<const Eigen::VectorXd> all(y.data(), y.size());
  if (factor_.size() == 0) return linalg::transposed_product(traces_, all.tail(traces_.rows()));
  Eigen::VectorXd displacement = all.tail(factor_.rows());
  linalg::substitute_backward(factor_, displacement);
  return rows_.transpose() * displacement;
}

void CondensedRows::add_forces(const Eigen::VectorXd& multiplier, std::span<double> y) const {
  Eigen::Map<Eigen::VectorXd> all(y.data(), y.size());
  if (factor_.size() == 0) {
    linalg::add_product(traces_, multiplier, all.tail(traces_.rows()));
    return;
  }
  Eigen::VectorXd forces = rows_ * multiplier;
  linalg::substitute_forward(factor_, forces);
  all.tail(factor_.rows()) += forces;
}

}  // namespace creepcontact::contact
