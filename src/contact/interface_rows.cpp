#include "creepcontact/contact/interface_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/contact/load_balance.hpp"

namespace creepcontact::contact {
namespace {

constexpr double motion_round_off = 1e-12;     // of the largest gap that a motion opens
constexpr double component_round_off = 1e-14;  // of the largest entry of the contact rows

/// Free dofs that contact rows touch, ascending.
std::vector<std::int64_t> touched_dofs(const RowMatrix& reduced) {
  std::vector<char> used(reduced.cols(), 0);
  for (int r = 0; r < reduced.outerSize(); ++r)
    for (RowMatrix::InnerIterator it(reduced, r); it; ++it)
      if (it.value() != 0) used[it.col()] = 1;
  std::vector<std::int64_t> dofs;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) dofs.push_back(i);
  return dofs;
}

}  // namespace

InterfaceRows::InterfaceRows(std::span<const mechanics::Body> bodies, std::span<const Pair> pairs,
                             const RigidBodyModes& rigid_body_modes)
    : bodies_(bodies), pairs_(pairs), rigid_body_modes_(rigid_body_modes) {
  rigid_body_modes_.require_contact(pairs_);
  for (const Pair& pair : pairs_) add_nodes(pair, problem_);
  problem_.rigid.setZero(n_rows(), rigid_body_modes_.held().cols());
  problem_.bodies.resize(bodies_.size());
  problem_.rigid_of_body.resize(bodies_.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) add_body(b);
  if (std::ranges::all_of(pairs_, [](const Pair& pair) { return pair.acts_always(); })) return;
  // Rows that act for a time may be all that there is against a motion: round-off must not seem to hold it.
  for (Index j = 0; j < problem_.rigid.cols(); ++j) {
    const double least = motion_round_off * problem_.rigid.col(j).cwiseAbs().maxCoeff();
    problem_.rigid.col(j) = (problem_.rigid.col(j).array().abs() > least).select(problem_.rigid.col(j), 0.0);
  }
}

void InterfaceRows::add_body(std::size_t b) {
  const mechanics::Body& body = bodies_[b];
  BodyRows rows;
  rows.full = body_rows(pairs_, b, body.mesh().nodes.size(), rows.rows);
  rows.reduced = body.constraints().reduce_rows(rows.full);
  std::vector<char> is_pin(rows.reduced.cols(), 0);
  for (const std::int64_t pin : body.fixing_dofs()) is_pin[pin] = 1;
  // Components that are rounding would make unknowns of the whole surface's nodes trailing ones.
  const double least =
      rows.reduced.nonZeros() > 0 ? component_round_off * rows.reduced.coeffs().cwiseAbs().maxCoeff() : 0.0;
  rows.reduced.prune([&](auto, auto column, double value) { return std::abs(value) > least && !is_pin[column]; });
  for (const int row : rows.rows) rows.is_slaves.push_back(problem_.node(row).slave_body == static_cast<int>(b));
  rows.trailing = touched_dofs(rows.reduced);

  const Index n_motions = body.free_motions().size();
  const auto held = rigid_body_modes_.held().middleRows(rigid_body_modes_.first_of_body(b), n_motions);
  problem_.rigid_of_body[b] = rigid_body_modes_.gaps(b, pairs_)(rows.rows, Eigen::all) * held;
  problem_.rigid(rows.rows, Eigen::all) += problem_.rigid_of_body[b];
  problem_.bodies[b].rows = rows.rows;
  of_body_.push_back(std::move(rows));
}

InterfaceLoad InterfaceRows::no_load() const {
  return {Eigen::VectorXd::Zero(n_rows()),
          Eigen::VectorXd::Zero(rigid_body_modes_.size()),
          Eigen::VectorXd::Zero(rigid_body_modes_.size()),
          {},
          0.0};
}

InterfaceLoad InterfaceRows::initial_load(double t, Conditions at) const {
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
  for (std::size_t b = 0; b < of_body_.size(); ++b) {
    const std::vector<double>& prescribed = at[b].prescribed;
    const std::vector<int>& rows = of_body_[b].rows;
    if (rows.empty() || !bodies_[b].constraints().has_nonzero_values()) continue;
    const Eigen::Map<const Eigen::VectorXd> u(prescribed.data(), prescribed.size());
    const Eigen::VectorXd moved = of_body_[b].full * u;
    load.gap(rows) += moved;
  }
  return load;
}

Friction InterfaceRows::friction(double t) const {
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

Eigen::VectorXd InterfaceRows::creep_gaps(std::span<const double> closures) const {
  Eigen::VectorXd gaps;
  if (closures.empty()) return gaps;
  gaps.setZero(n_rows());
  for (std::size_t i = 0; i < closures.size(); ++i)
    gaps[problem_.nodes[i].first_row] = problem_.nodes[i].gasket_area * closures[i];
  return gaps;
}

std::vector<ClosureCurve> InterfaceRows::gasket_curves(double t, const Eigen::VectorXd& largest) const {
  if (!problem_.has_gaskets()) return {};
  std::vector<ClosureCurve> result(problem_.nodes.size());
  for (const Pair& pair : pairs_) {
    if (!pair.gasket) continue;
    const std::vector<double> temperatures = pair.gasket->temperatures(t);
    for (std::size_t i = 0; i < temperatures.size(); ++i) {
      const auto node = static_cast<std::size_t>(pair.first_node) + i;
      result[node] = pair.gasket->kind().law.curve(largest[static_cast<Index>(node)], temperatures[i]);
    }
  }
  return result;
}

Eigen::VectorXd InterfaceRows::unloaded_gap() const {
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

void InterfaceRows::add_resultant(std::size_t body, const mechanics::BodyConditions& at, InterfaceLoad& load) const {
  const std::size_t n_motions = bodies_[body].free_motions().size();
  if (n_motions == 0) return;
  const std::size_t first = rigid_body_modes_.first_of_body(body);
  const double force = bodies_[body].external_resultant(at, {load.work.data() + first, n_motions});
  load.force.segment(first, n_motions).setConstant(force);
}

void InterfaceRows::add_gaps(std::size_t body, std::span<const double> u, Eigen::VectorXd& gap) const {
  const BodyRows& rows = of_body_[body];
  if (rows.rows.empty() || u.empty()) return;
  gap(rows.rows) += rows.reduced * Eigen::Map<const Eigen::VectorXd>(u.data(), rows.reduced.cols());
}

void InterfaceRows::add_rigid_motion(std::size_t body, const Eigen::VectorXd& rigid,
                                     std::span<double> displacement) const {
  const std::size_t n_motions = bodies_[body].free_motions().size();
  if (n_motions == 0 || rigid.size() == 0) return;
  const Eigen::VectorXd own =
      rigid_body_modes_.held().middleRows(rigid_body_modes_.first_of_body(body), n_motions) * rigid;
  bodies_[body].add_free_motions({own.data(), n_motions}, displacement);
}

void InterfaceRows::add_contact_forces(std::size_t body, const Eigen::VectorXd& multiplier,
                                       std::span<double> forces) const {
  const std::vector<int>& rows = of_body_[body].rows;
  if (rows.empty()) return;
  Eigen::Map<Eigen::VectorXd>(forces.data(), forces.size()) +=
      of_body_[body].full.transpose() * Eigen::VectorXd(multiplier(rows));
}

}  // namespace creepcontact::contact
