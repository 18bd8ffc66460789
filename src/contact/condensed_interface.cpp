#include "creepcontact/contact/condensed_interface.hpp"

#include <fmt/format.h>

#include <cmath>

#include "creepcontact/base/error.hpp"

namespace creepcontact::contact {
namespace {

constexpr double rounding = 1e-13;  // of the forces on a body: what sums to zero but for it
constexpr double idle_work = 1e-8;  // of the forces on the body: rounding, or a load along an idle motion

std::vector<Pair> numbered(std::vector<Pair> pairs) {
  number_rows(pairs);
  return pairs;
}

}  // namespace

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
    : bodies_(bodies), pairs_(numbered(std::move(pairs))), floating_(bodies, pairs_), sides_(bodies.size()) {
  floating_.require_contact(pairs_);
  for (const Pair& pair : pairs_)
    for (int r = 0; r < pair.coupling.n_rows(); ++r) {
      problem_.slave_body.push_back(static_cast<int>(pair.slave_body));
      problem_.master_body.push_back(static_cast<int>(pair.master_body));
      problem_.bilateral.push_back(pair.coupling.type == ContactType::tied);
    }
  const auto n_rows = static_cast<Eigen::Index>(problem_.slave_body.size());
  problem_.total.setZero(n_rows, n_rows);
  problem_.rigid.setZero(n_rows, floating_.held().cols());
  problem_.bodies.resize(bodies.size());
  problem_.rigid_of_body.resize(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) condense(b);
}

void CondensedInterface::condense(std::size_t b) {
  mechanics::Body& body = *bodies_[b];
  Side& side = sides_[b];
  side.full_rows = body_rows(pairs_, b, body.mesh().nodes.size(), side.rows);
  const std::vector<std::int64_t> trailing = contact_unknowns(body, side.full_rows);
  body.factorize(trailing);

  std::vector<int> place(static_cast<std::size_t>(body.constraints().n_free()), -1);
  for (std::size_t i = 0; i < trailing.size(); ++i) place[static_cast<std::size_t>(trailing[i])] = static_cast<int>(i);
  for (const std::int64_t pin : body.pins()) place[static_cast<std::size_t>(pin)] = -1;
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

  const auto n_motions = static_cast<Eigen::Index>(body.free_motions().size());
  const auto held = floating_.held().middleRows(static_cast<Eigen::Index>(floating_.first_of_body(b)), n_motions);
  problem_.rigid_of_body[b] = floating_.gaps(b, pairs_)(side.rows, Eigen::all) * held;
  problem_.rigid(side.rows, Eigen::all) += problem_.rigid_of_body[b];
}

InterfaceLoad CondensedInterface::no_load() const {
  return {Eigen::VectorXd::Zero(n_rows()), Eigen::VectorXd::Zero(floating_.size()),
          Eigen::VectorXd::Zero(floating_.size())};
}

InterfaceLoad CondensedInterface::initial_load(double t) const {
  InterfaceLoad load = no_load();
  for (const Pair& pair : pairs_)
    load.gap.segment(pair.first_row, pair.coupling.n_rows()) =
        pair.geometric_gap ? pair.coupling.geometric_gap : pair.coupling.given_gap(pair.gap, t);
  for (std::size_t b = 0; b < sides_.size(); ++b) {
    const std::span<const double> prescribed = bodies_[b]->prescribed();
    if (sides_[b].rows.empty() || !bodies_[b]->constraints().has_nonzero_values()) continue;
    const Eigen::Map<const Eigen::VectorXd> u(prescribed.data(), static_cast<Eigen::Index>(prescribed.size()));
    const Eigen::VectorXd moved = sides_[b].full_rows * u;
    for (std::size_t r = 0; r < sides_[b].rows.size(); ++r) load.gap[sides_[b].rows[r]] += moved[static_cast<int>(r)];
  }
  return load;
}

void CondensedInterface::take_resultant(std::size_t body, std::span<double> right_hand_side,
                                        InterfaceLoad& load) const {
  const std::size_t n_motions = bodies_[body]->free_motions().size();
  if (n_motions == 0) return;
  const std::size_t first = floating_.first_of_body(body);
  const double force = bodies_[body]->take_resultant(right_hand_side, {load.work.data() + first, n_motions});
  load.force.segment(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(n_motions)).setConstant(force);
}

ContactLoad CondensedInterface::contact_load(const InterfaceLoad& load) const {
  const Eigen::VectorXd idle = floating_.idle().transpose() * load.work;
  const Eigen::VectorXd force = floating_.idle().cwiseAbs().transpose() * load.force;
  for (Eigen::Index j = 0; j < idle.size(); ++j)
    if (std::abs(idle[j]) > idle_work * force[j])
      throw ModelError(fmt::format(
          "{}: the loads drive this motion (generalised force {:.4g}), and neither supports nor contact hold "
          "it; add a support, or balance the loads",
          floating_.describe(floating_.idle().col(j)), idle[j]));
  Eigen::VectorXd resultant = floating_.held().transpose() * load.work;
  const Eigen::VectorXd sum = floating_.held().cwiseAbs().transpose() * load.force;
  resultant = (resultant.array().abs() > rounding * sum.array()).select(resultant, 0.0);
  return {load.gap, resultant};
}

void CondensedInterface::report(const UnbalancedLoad& unbalanced) const {
  throw ModelError(fmt::format(
      "{}: the loads drive the assembly along this motion and no contact stands in its way; add a support, or "
      "a load that presses the bodies together",
      floating_.describe(floating_.held() * unbalanced.motion)));
}

void CondensedInterface::add_trace(std::size_t body, std::span<const double> y, InterfaceLoad& load) const {
  const Side& side = sides_[body];
  if (side.traces.size() == 0) return;
  const Eigen::Map<const Eigen::VectorXd> all(y.data(), static_cast<Eigen::Index>(y.size()));
  const Eigen::VectorXd trace = side.traces.transpose() * all.tail(side.traces.rows());
  for (std::size_t r = 0; r < side.rows.size(); ++r) load.gap[side.rows[r]] += trace[static_cast<int>(r)];
}

void CondensedInterface::add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier,
                                         std::span<double> y) const {
  const Side& side = sides_[body];
  if (side.traces.size() == 0) return;
  const Eigen::VectorXd own = multiplier(side.rows);
  Eigen::Map<Eigen::VectorXd> all(y.data(), static_cast<Eigen::Index>(y.size()));
  all.tail(side.traces.rows()).noalias() += side.traces * own;
}

void CondensedInterface::add_rigid_motion(std::size_t body, const Eigen::VectorXd& rigid,
                                          std::span<double> displacement) const {
  const std::size_t n_motions = bodies_[body]->free_motions().size();
  if (n_motions == 0 || rigid.size() == 0) return;
  const Eigen::VectorXd own = floating_.held().middleRows(static_cast<Eigen::Index>(floating_.first_of_body(body)),
                                                          static_cast<Eigen::Index>(n_motions)) *
                              rigid;
  bodies_[body]->add_free_motions({own.data(), n_motions}, displacement);
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
