#include "creepcontact/contact/condensed_interface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/contact/load_balance.hpp"
#include "creepcontact/linalg/factorizations.hpp"
#include "factored_flexibility.hpp"

namespace creepcontact::contact {
namespace {

constexpr double overlap_of_rounding = 1e-9;    // of the size of a multiplier's area
constexpr double round_off_of_motions = 1e-12;  // of the largest gap that a motion opens
constexpr double no_component = 1e-14;          // of the largest entry of the contact rows

}  // namespace

std::vector<std::int64_t> contact_unknowns(const RowMatrix& reduced) {
  std::vector<char> used(reduced.cols(), 0);
  for (int r = 0; r < reduced.outerSize(); ++r)
    for (RowMatrix::InnerIterator it(reduced, r); it; ++it)
      if (it.value() != 0) used[it.col()] = 1;
  std::vector<std::int64_t> unknowns;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) unknowns.push_back(i);
  return unknowns;
}

CondensedInterface::CondensedInterface(std::span<const mechanics::Body> bodies, std::span<const Pair> pairs,
                                       const RigidBodyModes& rigid_body_modes, Conditions at, double dense_bytes,
                                       const Admission& admit, const linalg::StiffnessSolverFactory& make_solver,
                                       const Team& team)
    : bodies_(bodies), pairs_(pairs), rigid_body_modes_(rigid_body_modes), team_(team), sides_(bodies.size()) {
  rigid_body_modes_.require_contact(pairs_);
  make_problem();
  make_rows();
  const auto refuse_operator = [&] {
    if (team_.size() == 1) return;
    throw ConfigError(fmt::format(
        "contact: its matrices would take {:.0f} MB, more than contact_solver.dense_limit_mb allows; without "
        "them contact cannot be solved on several processes: raise the limit, or use one process",
        dense_bytes_ / 1e6));
  };
  if (dense_bytes_ - condensed_bytes_ > dense_bytes) refuse_operator();  // before bodies are analysed
  is_condensed_ = dense_bytes_ <= dense_bytes;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    factored_.emplace_back(bodies[b], at[b], is_condensed_ ? sides_[b].trailing : std::vector<std::int64_t>(),
                           make_solver);
  if (error_bound() > 0) {
    is_condensed_ = false;
    dense_bytes_ -= condensed_bytes_;
  }
  const bool dense = dense_bytes_ <= dense_bytes;
  if (!dense) refuse_operator();
  if (admit) together(team_, [&] { admit(*this, dense ? dense_bytes_ : 0.0); });
  std::vector<std::size_t> all(bodies.size());
  std::iota(all.begin(), all.end(), 0);
  factorize(all, at);
  if (dense)
    condense(all);
  else
    make_operator(at);
  std::vector<double> marks(n_rows(), 0.0);
  if (is_here())
    for (const int row : immovable_rows(problem_)) marks[row] = 1;
  team_.broadcast(marks, 0);
  for (int row = 0; row < n_rows(); ++row)
    if (marks[row] != 0) immovable_.push_back(row);
}

void CondensedInterface::factorize(std::span<const std::size_t> bodies, Conditions at) {
  std::vector<double> entries;
  for (const std::size_t b : bodies) entries.push_back(static_cast<double>(factored_[b].solver().factor_bytes()) / 8);
  const auto factorize_one = [&](std::size_t i) { factored_[bodies[i]].factorize(at[bodies[i]]); };
  if (team_.size() == 1) return linalg::for_each_factorization(entries, factorize_one);
  for (std::size_t i = 0; i < bodies.size(); ++i) factorize_one(i);  // all processes the same one
}

double CondensedInterface::error_bound() const {
  double result = 0;
  for (const mechanics::FactoredBody& body : factored_) result = std::max(result, body.solver().error_bound());
  return result;
}

void CondensedInterface::make_operator(Conditions at) {
  large_ = std::make_unique<FactoredFlexibility>(factored_, at, rows_, n_rows());
  problem_.large = large_.get();
}

CondensedInterface::~CondensedInterface() = default;

void CondensedInterface::make_problem() {
  for (const Pair& pair : pairs_) add_nodes(pair, problem_);
  problem_.rigid.setZero(n_rows(), rigid_body_modes_.held().cols());
  problem_.bodies.resize(bodies_.size());
  problem_.rigid_of_body.resize(bodies_.size());
}

void CondensedInterface::make_rows() {
  const auto n_all = static_cast<double>(n_rows());
  constexpr double factors_of_friction = 2;  // FrictionSystem keeps so many
  dense_bytes_ = 8 * n_all * n_all * (1 + (problem_.has_friction() ? factors_of_friction : 0));
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const mechanics::Body& body = bodies_[b];
    BodyRows rows;
    sides_[b].full_rows = body_rows(pairs_, b, body.mesh().nodes.size(), rows.rows);
    rows.reduced = body.constraints().reduce_rows(sides_[b].full_rows);
    std::vector<char> is_pin(rows.reduced.cols(), 0);
    for (const std::int64_t pin : body.fixing_dofs()) is_pin[pin] = 1;
    // Components that are rounding would make unknowns of the whole surface's nodes trailing ones.
    const double least = rows.reduced.nonZeros() > 0 ? no_component * rows.reduced.coeffs().cwiseAbs().maxCoeff() : 0.0;
    rows.reduced.prune([&](auto, auto column, double value) { return std::abs(value) > least && !is_pin[column]; });
    for (const int row : rows.rows) rows.is_slaves.push_back(problem_.node(row).slave_body == static_cast<int>(b));
    sides_[b].trailing = contact_unknowns(rows.reduced);
    const auto n = static_cast<double>(rows.rows.size()), n_trailing = static_cast<double>(sides_[b].trailing.size());
    condensed_bytes_ += 8 * n_trailing * (n + 1.5 * n_trailing);  // G, L22 in the factor and copied
    dense_bytes_ += 8 * n * n;                                    // F_b

    const Index n_motions = body.free_motions().size();
    const auto held = rigid_body_modes_.held().middleRows(rigid_body_modes_.first_of_body(b), n_motions);
    problem_.rigid_of_body[b] = rigid_body_modes_.gaps(b, pairs_)(rows.rows, Eigen::all) * held;
    problem_.rigid(rows.rows, Eigen::all) += problem_.rigid_of_body[b];
    problem_.bodies[b].rows = rows.rows;
    rows_.push_back(std::move(rows));
  }
  dense_bytes_ += condensed_bytes_;
  if (std::ranges::all_of(pairs_, [](const Pair& pair) { return pair.acts_always(); })) return;
  // Rows that act for a time may be all that there is against a motion: round-off must not seem to hold it.
  for (Index j = 0; j < problem_.rigid.cols(); ++j) {
    const double least = round_off_of_motions * problem_.rigid.col(j).cwiseAbs().maxCoeff();
    problem_.rigid.col(j) = (problem_.rigid.col(j).array().abs() > least).select(problem_.rigid.col(j), 0.0);
  }
}

void CondensedInterface::solve_for_flexibility(std::size_t body) {
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

void CondensedInterface::condense(std::span<const std::size_t> bodies) {
  if (!is_condensed_) {
    for (const std::size_t b : bodies) solve_for_flexibility(b);
    if (is_here()) sum_flexibilities();
    return;
  }
  together(team_, [&] {
    if (!is_here()) return;
    for (const std::size_t b : bodies) {
      Side& side = sides_[b];
      const bool has_many_rows = 2 * rows_[b].reduced.rows() > std::ssize(side.trailing);
      side.condensed = CondensedRows(rows_[b].reduced, side.trailing, factored_[b].solver(),
                                     problem_.has_friction() || has_many_rows);
      problem_.bodies[b].matrix = side.condensed.take_flexibility();
    }
    sum_flexibilities();
  });
}

void CondensedInterface::sum_flexibilities() {
  problem_.total.setZero(n_rows(), n_rows());
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    problem_.total(rows_[b].rows, rows_[b].rows) += problem_.bodies[b].matrix;
}

void CondensedInterface::refactorize(std::span<const std::size_t> bodies, Conditions at) {
  factorize(bodies, at);
  if (!large_) {
    condense(bodies);
    return;
  }
  earlier_products_ += large_->n_products();
  make_operator(at);
}

std::int64_t CondensedInterface::n_products() const {
  return earlier_products_ + (large_ ? large_->n_products() : 0);
}

InterfaceLoad CondensedInterface::no_load() const {
  return {Eigen::VectorXd::Zero(n_rows()),
          Eigen::VectorXd::Zero(rigid_body_modes_.size()),
          Eigen::VectorXd::Zero(rigid_body_modes_.size()),
          {},
          0.0};
}

InterfaceLoad CondensedInterface::initial_load(double t, Conditions at) const {
  InterfaceLoad load = no_load();
  load.time = t;
  load.friction = friction(t);
  for (const Pair& pair : pairs_) {
    auto gap = load.gap.segment(pair.first_row, pair.coupling.n_rows());
    gap = pair.initial_gap(t);
    if (!gap.allFinite())
      throw ModelError(
          fmt::format("contact '{}': the gap is not a finite number at t = {:.6g}; check its expression for divisions "
                      "by zero and for roots or logarithms of negative numbers",
                      pair.name, t));
  }
  for (std::size_t b = 0; b < sides_.size(); ++b) {
    const std::vector<double>& prescribed = at[b].prescribed;
    const std::vector<int>& rows = rows_[b].rows;
    if (rows.empty() || !bodies_[b].constraints().has_nonzero_values()) continue;
    const Eigen::Map<const Eigen::VectorXd> u(prescribed.data(), prescribed.size());
    const Eigen::VectorXd moved = sides_[b].full_rows * u;
    load.gap(rows) += moved;
  }
  return load;
}

Friction CondensedInterface::friction(double t) const {
  Friction result;
  if (!problem_.has_friction()) return result;
  result.coefficient.setZero(std::ssize(problem_.nodes));
  for (const Pair& pair : pairs_)
    if (pair.coupling.has_friction()) try {
        result.coefficient.segment(pair.first_node, std::ssize(pair.coupling.nodes)) = pair.friction.at(t);
      } catch (const ModelError& error) {
        throw ModelError(fmt::format("contact '{}': {}", pair.name, error.what()));
      }
  return result;
}

Eigen::VectorXd CondensedInterface::unloaded_gap() const {
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(n_rows());
  for (const Pair& pair : pairs_) {
    if (pair.coupling.type == ContactType::tied) continue;
    auto own = gap.segment(pair.first_row, pair.coupling.n_rows());
    own = pair.initial_gap(0);
    const Eigen::Map<const Eigen::VectorXd> area(pair.coupling.area.data(), std::ssize(pair.coupling.area));
    const double overlap = std::max(0.0, -pair.coupling.first_rows(own).cwiseQuotient(area).minCoeff());
    own(Eigen::seqN(0, area.size(), pair.coupling.rows_per_node())) += overlap * area;
  }
  return gap;
}

void CondensedInterface::add_resultant(std::size_t body, const mechanics::BodyConditions& at,
                                       InterfaceLoad& load) const {
  const std::size_t n_motions = bodies_[body].free_motions().size();
  if (n_motions == 0) return;
  const std::size_t first = rigid_body_modes_.first_of_body(body);
  const double force = bodies_[body].external_resultant(at, {load.work.data() + first, n_motions});
  load.force.segment(first, n_motions).setConstant(force);
}

void CondensedInterface::warn_of_held_overlaps(const InterfaceLoad& load) {
  if (overlap_warned_ || immovable_.empty()) return;
  for (const Pair& pair : pairs_) {
    if (pair.coupling.type == ContactType::tied) continue;
    double deepest = 0;
    for (const int row : immovable_)
      if (const Index r = row - pair.first_row;
          r >= 0 && r < pair.coupling.n_rows() && r % pair.coupling.rows_per_node() == 0)
        deepest = std::min(deepest, load.gap[row] / pair.coupling.area[r / pair.coupling.rows_per_node()]);
    if (-deepest <= overlap_of_rounding * std::sqrt(pair.coupling.area.front())) continue;
    overlap_warned_ = true;
    log::warning(
        "contact '{}': both surfaces are held by supports where they overlap by {:.4g} at t = {:.6g}; the overlap "
        "remains and causes no pressure",
        pair.name, -deepest, load.time);
  }
}

ContactLoad CondensedInterface::contact_load(const InterfaceLoad& load) {
  warn_of_held_overlaps(load);
  const std::string warning = require_free_motions_unloaded(rigid_body_modes_, load.work, load.force, load.time);
  if (!warning.empty() && !residual_warned_) log::warning("{}", warning);
  residual_warned_ = residual_warned_ || !warning.empty();
  return {load.gap, held_resultant(rigid_body_modes_, load.work, load.force), load.friction,
          idle_rows(pairs_, load.time), held_force(rigid_body_modes_, load.force)};
}

void CondensedInterface::report(const UnbalancedLoad& unbalanced, double t) const {
  if (!problem_.has_friction()) report_unbalanced(rigid_body_modes_, unbalanced, t);
  throw SlidingOff(
      fmt::format("{}: at t = {:.6g} the loads move the assembly along this motion, and neither contact nor friction "
                  "prevents it (generalised force that remains: {:.4g}); add a support, more friction, or a load that "
                  "presses the bodies together",
                  rigid_body_modes_.describe(rigid_body_modes_.held() * unbalanced.motion), t, unbalanced.force));
}

void CondensedInterface::add_gaps(std::size_t body, std::span<const double> u, Eigen::VectorXd& gap) const {
  const BodyRows& rows = rows_[body];
  if (rows.rows.empty() || u.empty()) return;
  gap(rows.rows) += rows.reduced * Eigen::Map<const Eigen::VectorXd>(u.data(), rows.reduced.cols());
}

void CondensedInterface::add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap) {
  const BodyRows& rows = rows_[body];
  if (rows.rows.empty() || y.empty()) return;
  if (is_condensed_) {
    if (is_here()) gap(rows.rows) += sides_[body].condensed.gaps(y);
    return;
  }
  std::vector<double> u(y.size());
  factored_[body].solver().backward(y, u);
  add_gaps(body, u, gap);
}

void CondensedInterface::add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y) {
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
  sides_[body].condensed.add_forces(own, y);
}

void CondensedInterface::add_rigid_motion(std::size_t body, const Eigen::VectorXd& rigid,
                                          std::span<double> displacement) const {
  const std::size_t n_motions = bodies_[body].free_motions().size();
  if (n_motions == 0 || rigid.size() == 0) return;
  const Eigen::VectorXd own =
      rigid_body_modes_.held().middleRows(rigid_body_modes_.first_of_body(body), n_motions) * rigid;
  bodies_[body].add_free_motions({own.data(), n_motions}, displacement);
}

void CondensedInterface::add_contact_forces(std::size_t body, const Eigen::VectorXd& multiplier,
                                            std::span<double> forces) const {
  const std::vector<int>& rows = rows_[body].rows;
  if (rows.empty()) return;
  Eigen::Map<Eigen::VectorXd>(forces.data(), forces.size()) +=
      sides_[body].full_rows.transpose() * Eigen::VectorXd(multiplier(rows));
}

}  // namespace creepcontact::contact
