#include "creepcontact/contact/condensed_interface.hpp"

#include <algorithm>

namespace creepcontact::contact {
namespace {

/// Appends the rows of one side of a pair as triplets.
void append(const RowMatrix& from, int first_target, std::vector<Eigen::Triplet<double>>& triplets) {
  for (int r = 0; r < from.outerSize(); ++r)
    for (RowMatrix::InnerIterator it(from, r); it; ++it)
      if (it.value() != 0) triplets.emplace_back(first_target + r, static_cast<int>(it.col()), it.value());
}

}  // namespace

RowMatrix body_rows(const std::vector<Pair>& pairs, std::size_t body, std::size_t n_nodes, std::vector<int>& rows) {
  rows.clear();
  std::vector<Eigen::Triplet<double>> triplets;
  for (const Pair& pair : pairs) {
    if (pair.slave_body != body && pair.master_body != body) continue;
    const auto first = static_cast<int>(rows.size());
    if (pair.slave_body == body) append(pair.coupling.slave_rows, first, triplets);
    if (pair.master_body == body) append(pair.coupling.master_rows, first, triplets);
    for (int r = 0; r < pair.coupling.n_rows(); ++r) rows.push_back(pair.first_row + r);
  }
  RowMatrix matrix(static_cast<int>(rows.size()), 3 * static_cast<int>(n_nodes));
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

std::vector<std::int64_t> contact_unknowns(const mechanics::Body& body, const RowMatrix& full_rows) {
  const RowMatrix reduced = body.constraints().reduce_rows(full_rows);
  std::vector<char> used(static_cast<std::size_t>(reduced.cols()), 0);
  for (int r = 0; r < reduced.outerSize(); ++r)
    for (RowMatrix::InnerIterator it(reduced, r); it; ++it)
      if (it.value() != 0) used[static_cast<std::size_t>(it.col())] = 1;
  std::vector<std::int64_t> unknowns;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) unknowns.push_back(static_cast<std::int64_t>(i));
  return unknowns;
}

CondensedInterface::CondensedInterface(std::span<const std::unique_ptr<mechanics::Body>> bodies,
                                       std::vector<Pair> pairs)
    : bodies_(bodies), pairs_(std::move(pairs)), sides_(bodies.size()) {
  int n_rows = 0;
  for (Pair& pair : pairs_) {
    pair.first_row = n_rows;
    n_rows += pair.coupling.n_rows();
  }
  problem_.bodies.resize(bodies.size());
  problem_.slave_body.reserve(static_cast<std::size_t>(n_rows));
  for (const Pair& pair : pairs_)
    for (int r = 0; r < pair.coupling.n_rows(); ++r) {
      problem_.slave_body.push_back(static_cast<int>(pair.slave_body));
      problem_.master_body.push_back(static_cast<int>(pair.master_body));
      problem_.bilateral.push_back(pair.coupling.type == ContactType::tied);
    }
  problem_.total.setZero(n_rows, n_rows);

  for (std::size_t b = 0; b < bodies.size(); ++b) {
    mechanics::Body& body = *bodies[b];
    Side& side = sides_[b];
    side.full_rows = body_rows(pairs_, b, body.mesh().nodes.size(), side.rows);
    const std::vector<std::int64_t> trailing = contact_unknowns(body, side.full_rows);
    body.factorize(trailing);

    std::vector<int> place(static_cast<std::size_t>(body.constraints().n_free()), -1);
    for (std::size_t i = 0; i < trailing.size(); ++i)
      place[static_cast<std::size_t>(trailing[i])] = static_cast<int>(i);
    const RowMatrix reduced = body.constraints().reduce_rows(side.full_rows);
    side.traces.setZero(static_cast<Eigen::Index>(trailing.size()), reduced.rows());
    for (int r = 0; r < reduced.outerSize(); ++r)
      for (RowMatrix::InnerIterator it(reduced, r); it; ++it)
        if (const int i = place[static_cast<std::size_t>(it.col())]; i >= 0) side.traces(i, r) = it.value();
    if (side.traces.size() > 0) {
      const Eigen::MatrixXd factor = body.factor().trailing_factor();
      factor.triangularView<Eigen::Lower>().solveInPlace(side.traces);
    }
    Flexibility& flexibility = problem_.bodies[b];
    flexibility.rows = side.rows;
    flexibility.matrix = side.traces.transpose() * side.traces;
    problem_.total(side.rows, side.rows) += flexibility.matrix;
  }
}

Eigen::VectorXd CondensedInterface::initial_gap(double t) const {
  Eigen::VectorXd gap(n_rows());
  for (const Pair& pair : pairs_)
    gap.segment(pair.first_row, pair.coupling.n_rows()) =
        pair.geometric_gap ? pair.coupling.geometric_gap : pair.coupling.given_gap(pair.gap, t);
  for (std::size_t b = 0; b < sides_.size(); ++b) {
    const std::span<const double> prescribed = bodies_[b]->prescribed();
    if (sides_[b].rows.empty() || !bodies_[b]->constraints().has_nonzero_values()) continue;
    const Eigen::Map<const Eigen::VectorXd> u(prescribed.data(), static_cast<Eigen::Index>(prescribed.size()));
    const Eigen::VectorXd moved = sides_[b].full_rows * u;
    for (std::size_t r = 0; r < sides_[b].rows.size(); ++r) gap[sides_[b].rows[r]] += moved[static_cast<int>(r)];
  }
  return gap;
}

void CondensedInterface::add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap) const {
  const Side& side = sides_[body];
  if (side.traces.size() == 0) return;
  const Eigen::Map<const Eigen::VectorXd> all(y.data(), static_cast<Eigen::Index>(y.size()));
  const Eigen::VectorXd trace = side.traces.transpose() * all.tail(side.traces.rows());
  for (std::size_t r = 0; r < side.rows.size(); ++r) gap[side.rows[r]] += trace[static_cast<int>(r)];
}

void CondensedInterface::add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier,
                                         std::span<double> y) const {
  const Side& side = sides_[body];
  if (side.traces.size() == 0) return;
  const Eigen::VectorXd own = multiplier(side.rows);
  Eigen::Map<Eigen::VectorXd> all(y.data(), static_cast<Eigen::Index>(y.size()));
  all.tail(side.traces.rows()).noalias() += side.traces * own;
}

void CondensedInterface::add_contact_forces(std::size_t body, const Eigen::VectorXd& multiplier,
                                            std::span<double> forces) const {
  const Side& side = sides_[body];
  if (side.rows.empty()) return;
  const Eigen::VectorXd own = multiplier(side.rows);
  Eigen::Map<Eigen::VectorXd>(forces.data(), static_cast<Eigen::Index>(forces.size())) +=
      side.full_rows.transpose() * own;
}

std::size_t CondensedInterface::bytes() const {
  std::size_t count = static_cast<std::size_t>(problem_.total.size());
  for (std::size_t b = 0; b < sides_.size(); ++b)
    count += static_cast<std::size_t>(sides_[b].traces.size() + problem_.bodies[b].matrix.size());
  return 8 * count;
}

}  // namespace creepcontact::contact
