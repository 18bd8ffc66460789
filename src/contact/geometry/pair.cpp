#include "creepcontact/contact/geometry/pair.hpp"

#include <algorithm>

#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {
namespace {

/// Appends the rows of one side of a pair as triplets.
void append(const RowMatrix& from, int first_target, std::vector<Eigen::Triplet<double>>& triplets) {
  for (int r = 0; r < from.outerSize(); ++r)
    for (RowMatrix::InnerIterator it(from, r); it; ++it)
      if (it.value() != 0) triplets.emplace_back(first_target + r, static_cast<int>(it.col()), it.value());
}

}  // namespace

Eigen::VectorXd Pair::initial_gap(double t) const {
  if (gap_per_value.size() > 0) return gap({.t = t}) * gap_per_value;
  Eigen::VectorXd gaps = geometric_gap ? coupling.geometric_gap : coupling.given_gap(gap, t);
  if (!gasket) return gaps;
  const std::vector<double> growth = gasket->growth(t);
  for (std::size_t i = 0; i < growth.size(); ++i) gaps[coupling.row(i)] -= coupling.area[i] * growth[i];
  return gaps;
}

Eigen::VectorXd Pair::interference_gap() const {
  const Index n_nodes = std::ssize(coupling.nodes), width = coupling.rows_per_node();
  const Eigen::Map<const Eigen::VectorXd> area(coupling.area.data(), n_nodes);
  Eigen::VectorXd change = Eigen::VectorXd::Zero(coupling.n_rows());
  if (coupling.type != ContactType::tied) {
    change(Eigen::seqN(0, n_nodes, width)) = -area;
    return change;
  }
  Vector3 normal = Vector3::Zero();
  for (Index i = 0; i < n_nodes; ++i) normal += area[i] * coupling.nodes[i].normal;
  normal.normalize();
  for (Index i = 0; i < n_nodes; ++i)
    change.segment<3>(width * i) =
        area[i] *
        (coupling.axes.empty() ? normal : Vector3(coupling.axes[static_cast<std::size_t>(i)].transpose() * normal));
  return change;
}

Index number_rows(std::vector<Pair>& pairs) {
  Index n_rows = 0, n_nodes = 0;
  for (Pair& pair : pairs) {
    pair.first_row = n_rows;
    pair.first_node = n_nodes;
    n_rows += pair.coupling.n_rows();
    n_nodes += std::ssize(pair.coupling.nodes);
  }
  return n_rows;
}

std::vector<char> idle_rows(std::span<const Pair> pairs, double t) {
  std::vector<char> idle;
  if (std::ranges::all_of(pairs, [](const Pair& pair) { return pair.acts_always(); })) return idle;
  for (const Pair& pair : pairs)
    idle.insert(idle.end(), static_cast<std::size_t>(pair.coupling.n_rows()), pair.acts(t) ? 0 : 1);
  return idle;
}

RowMatrix body_rows(std::span<const Pair> pairs, std::size_t body, std::size_t n_nodes, std::vector<int>& rows) {
  rows.clear();
  std::vector<Eigen::Triplet<double>> triplets;
  for (const Pair& pair : pairs) {
    if (pair.slave_body != body && pair.master_body != body) continue;
    const auto first = static_cast<int>(rows.size());
    if (pair.slave_body == body) append(pair.coupling.slave_rows, first, triplets);
    if (pair.master_body == body) append(pair.coupling.master_rows, first, triplets);
    for (int r = 0; r < pair.coupling.n_rows(); ++r) rows.push_back(static_cast<int>(pair.first_row) + r);
  }
  RowMatrix matrix(rows.size(), 3 * n_nodes);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

}  // namespace creepcontact::contact
