#include "creepcontact/contact/interface_flexibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/factorizations.hpp"
#include "factored_flexibility.hpp"

namespace creepcontact::contact {

InterfaceFlexibility::InterfaceFlexibility(std::span<const mechanics::Body> bodies, const InterfaceRows& rows,
                                           Conditions at, double dense_bytes,
                                           const linalg::StiffnessSolverFactory& make_solver, const Team& team)
    : rows_(rows), team_(team), condensed_(bodies.size()), problem_(rows.problem()) {
  double condensed_bytes = 0;  // of G and L22 of all bodies, among dense_bytes_
  const auto n_all = static_cast<double>(rows_.n_rows());
  constexpr double factors_of_friction = 2;  // FrictionSystem keeps so many
  dense_bytes_ = 8 * n_all * n_all * (1 + (problem_.has_friction() ? factors_of_friction : 0));
  for (const BodyRows& own : rows_.of_bodies()) {
    const auto n = static_cast<double>(own.rows.size()), n_trailing = static_cast<double>(own.trailing.size());
    condensed_bytes += 8 * n_trailing * (n + 1.5 * n_trailing);  // G, L22 in the factor and copied
    dense_bytes_ += 8 * n * n;                                   // F_b
  }
  dense_bytes_ += condensed_bytes;
  const auto refuse_operator = [&] {
    if (team_.size() == 1) return;
    throw ConfigError(fmt::format(
        "contact: its matrices would take {:.0f} MB, more than contact_solver.dense_limit_mb allows; without "
        "them contact cannot be solved on several processes: raise the limit, or use one process",
        dense_bytes_ / 1e6));
  };
  if (dense_bytes_ - condensed_bytes > dense_bytes) refuse_operator();  // before bodies are analysed
  is_condensed_ = dense_bytes_ <= dense_bytes;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    factored_.emplace_back(bodies[b], at[b], is_condensed_ ? rows_[b].trailing : std::vector<std::int64_t>(),
                           make_solver);
  if (error_bound() > 0) {
    is_condensed_ = false;
    dense_bytes_ -= condensed_bytes;
  }
  is_dense_ = dense_bytes_ <= dense_bytes;
  if (!is_dense_) refuse_operator();
}

InterfaceFlexibility::~InterfaceFlexibility() = default;

void InterfaceFlexibility::factorize(Conditions at) {
  std::vector<std::size_t> all(factored_.size());
  std::iota(all.begin(), all.end(), 0);
  refactorize(all, at);
  std::vector<double> marks(rows_.n_rows(), 0.0);
  if (is_here())
    for (const int row : immovable_rows(problem_)) marks[row] = 1;
  team_.broadcast(marks, 0);
  for (int row = 0; row < rows_.n_rows(); ++row)
    if (marks[row] != 0) immovable_.push_back(row);
}

double InterfaceFlexibility::error_bound() const {
  double result = 0;
  for (const mechanics::FactoredBody& body : factored_) result = std::max(result, body.solver().error_bound());
  return result;
}

void InterfaceFlexibility::factorize_bodies(std::span<const std::size_t> bodies, Conditions at) {
  std::vector<double> entries;
  for (const std::size_t b : bodies) entries.push_back(static_cast<double>(factored_[b].solver().factor_bytes()) / 8);
  const auto factorize_one = [&](std::size_t i) { factored_[bodies[i]].factorize(at[bodies[i]]); };
  if (team_.size() == 1) return linalg::for_each_factorization(entries, factorize_one);
  for (std::size_t i = 0; i < bodies.size(); ++i) factorize_one(i);  // all processes the same one
}

void InterfaceFlexibility::make_operator(Conditions at) {
  earlier_products_ = n_products();
  large_ = std::make_unique<FactoredFlexibility>(factored_, at, rows_.of_bodies(), rows_.n_rows());
  problem_.large = large_.get();
}

void InterfaceFlexibility::condense(std::span<const std::size_t> bodies) {
  if (!is_condensed_) {
    for (const std::size_t b : bodies) solve_for_flexibility(b);
    if (is_here()) sum_flexibilities();
    return;
  }
  together(team_, [&] {
    if (!is_here()) return;
    for (const std::size_t b : bodies) {
      const BodyRows& rows = rows_[b];
      const bool has_many_rows = 2 * rows.reduced.rows() > std::ssize(rows.trailing);
      condensed_[b] =
          CondensedRows(rows.reduced, rows.trailing, factored_[b].solver(), problem_.has_friction() || has_many_rows);
      problem_.bodies[b].matrix = condensed_[b].take_flexibility();
    }
    sum_flexibilities();
  });
}

void InterfaceFlexibility::solve_for_flexibility(std::size_t body) {
  const RowMatrix& rows = rows_[body].reduced;
  Eigen::MatrixXd& flexibility = problem_.bodies[body].matrix;
  if (is_here()) flexibility.resize(rows.rows(), rows.rows());
  if (rows.cols() == 0) {
    flexibility.setZero();
    return;
  }
  std::vector<double> u(rows.cols());
  for (int r = 0; r < rows.rows(); ++r) {
    std::ranges::fill(u, 0.0);
    if (is_here())  // the parts of all processes are summed
      for (RowMatrix::InnerIterator entry(rows, r); entry; ++entry) u[entry.col()] = entry.value();
    factored_[body].solver().forward(u, u);
    factored_[body].solver().backward(u, u);
    if (is_here()) flexibility.col(r) = rows * Eigen::Map<const Eigen::VectorXd>(u.data(), rows.cols());
  }
  flexibility = ((flexibility + flexibility.transpose()) / 2).eval();
}

void InterfaceFlexibility::sum_flexibilities() {
  problem_.total.setZero(rows_.n_rows(), rows_.n_rows());
  for (std::size_t b = 0; b < factored_.size(); ++b)
    problem_.total(rows_[b].rows, rows_[b].rows) += problem_.bodies[b].matrix;
}

void InterfaceFlexibility::refactorize(std::span<const std::size_t> bodies, Conditions at) {
  factorize_bodies(bodies, at);
  if (is_dense_)
    condense(bodies);
  else
    make_operator(at);
}

std::int64_t InterfaceFlexibility::n_products() const {
  return earlier_products_ + (large_ ? large_->n_products() : 0);
}

void InterfaceFlexibility::add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap) {
  const BodyRows& rows = rows_[body];
  if (rows.rows.empty() || y.empty()) return;
  if (is_condensed_) {
    if (is_here()) gap(rows.rows) += condensed_[body].gaps(y);
    return;
  }
  std::vector<double> u(y.size());
  factored_[body].solver().backward(y, u);
  rows_.add_gaps(body, u, gap);
}

void InterfaceFlexibility::add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y) {
  const BodyRows& rows = rows_[body];
  if (rows.rows.empty() || y.empty() || !is_here()) return;
  const Eigen::VectorXd own = multiplier(rows.rows);
  if (!is_condensed_) {
    Eigen::VectorXd forces = rows.reduced.transpose() * own;
    const std::span<double> in_place(forces.data(), y.size());
    factored_[body].solver().forward(in_place, in_place);
    Eigen::Map<Eigen::VectorXd>(y.data(), y.size()) += forces;
    return;
  }
  condensed_[body].add_forces(own, y);
}

}  // namespace creepcontact::contact
