#include "creepcontact/contact/load_balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/base/log.hpp"
#include "solver/unbalanced_load.hpp"

namespace creepcontact::contact {
namespace {

constexpr double overlap_of_rounding = 1e-9;  // of the size of a multiplier's area
constexpr double force_round_off = 1e-13;     // of the forces on a body: what sums to zero but for it
constexpr double unconstrained_work =
    1e-8;  // of the forces on the body: rounding, or a load along an unconstrained motion
constexpr double residual_of_meshes = 1e-4;  // of balanced loads on an asymmetric mesh

/// @param work  of the external forces on unit rigid-body modes, RigidBodyModes::size()
/// @param force  per mode: sum of the absolute external forces on its body, the scale of `work`
/// @returns a warning if the loads drive an unconstrained mode by little, as on meshes that are not quite symmetric
/// @throws ModelError with the motion if by more
std::string require_free_motions_unloaded(const RigidBodyModes& modes, const Eigen::VectorXd& work,
                                          const Eigen::VectorXd& force, double t) {
  const Eigen::VectorXd driving = modes.unconstrained().transpose() * work;
  const Eigen::VectorXd sum = modes.unconstrained().cwiseAbs().transpose() * force;
  std::string warning;
  for (Index j = 0; j < driving.size(); ++j) {
    if (std::abs(driving[j]) <= unconstrained_work * sum[j]) continue;
    const std::string motion = modes.describe(modes.unconstrained().col(j));
    if (std::abs(driving[j]) > residual_of_meshes * sum[j])
      throw ModelError(
          fmt::format("{}: at t = {:.6g} the loads cause this motion (generalised force {:.4g}), and neither supports "
                      "nor contact prevent it; add a support, or balance the loads",
                      motion, t, driving[j]));
    if (warning.empty())
      warning = fmt::format(
          "{}: the loads are out of balance along this motion by {:.2g} of their sum, as on a mesh that is not quite "
          "symmetric; the motion is prevented at single nodes",
          motion, std::abs(driving[j]) / sum[j]);
  }
  return warning;
}

/// What the forces on the bodies would do on the modes that contact holds if nothing cancelled.
Eigen::VectorXd held_force(const RigidBodyModes& modes, const Eigen::VectorXd& force) {
  return modes.held().cwiseAbs().transpose() * force;
}

/// Work on the modes that contact holds, without round-off.
Eigen::VectorXd held_resultant(const RigidBodyModes& modes, const Eigen::VectorXd& work, const Eigen::VectorXd& force) {
  const Eigen::VectorXd resultant = modes.held().transpose() * work, sum = held_force(modes, force);
  return (resultant.array().abs() > force_round_off * sum.array()).select(resultant, 0.0);
}

[[noreturn]] void report_unbalanced(const RigidBodyModes& modes, const UnbalancedLoad& unbalanced, double t) {
  throw ModelError(
      fmt::format("{}: at t = {:.6g} the loads move the assembly along this motion and no contact prevents it; add a "
                  "support, or a load that presses the bodies together",
                  modes.describe(modes.held() * unbalanced.motion), t));
}

}  // namespace

void add_nodes(const Pair& pair, ContactProblem& problem) {
  const bool lets_go = pair.gasket && !pair.gasket->kind().law.pulls();  // a spring too, though its row is a tie
  const AdmissibleSet set = pair.coupling.type == ContactType::tied && !lets_go ? AdmissibleSet::space
                            : pair.coupling.has_friction()                      ? AdmissibleSet::cone
                                                                                : AdmissibleSet::half_line;
  const int width = static_cast<int>(pair.coupling.rows_per_node());
  for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
    problem.add_node(set, width, static_cast<int>(pair.slave_body), static_cast<int>(pair.master_body));
    if (pair.gasket) problem.nodes.back().gasket_area = pair.coupling.area[i];
  }
}

void LoadBalance::warn_of_held_overlaps(const InterfaceLoad& load) {
  if (overlap_warned_ || immovable_.empty()) return;
  for (const Pair& pair : rows_.pairs()) {
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

ContactLoad LoadBalance::contact_load(const InterfaceLoad& load) {
  warn_of_held_overlaps(load);
  const std::string warning = require_free_motions_unloaded(rows_.rigid_body_modes(), load.work, load.force, load.time);
  if (!warning.empty() && !residual_warned_) log::warning("{}", warning);
  residual_warned_ = residual_warned_ || !warning.empty();
  return {load.gap,
          held_resultant(rows_.rigid_body_modes(), load.work, load.force),
          load.friction,
          idle_rows(rows_.pairs(), load.time),
          held_force(rows_.rigid_body_modes(), load.force),
          load.curves};
}

void LoadBalance::report(const UnbalancedLoad& unbalanced, double t) const {
  if (!rows_.problem().has_friction()) report_unbalanced(rows_.rigid_body_modes(), unbalanced, t);
  throw SlidingOff(fmt::format(
      "{}: at t = {:.6g} the loads move the assembly along this motion, and neither contact nor friction "
      "prevents it (generalised force that remains: {:.4g}); add a support, more friction, or a load that "
      "presses the bodies together",
      rows_.rigid_body_modes().describe(rows_.rigid_body_modes().held() * unbalanced.motion), t, unbalanced.force));
}

void require_balance(std::span<const mechanics::Body> bodies, std::span<const Pair> pairs, const RigidBodyModes& modes,
                     std::span<const mechanics::BodyConditions> at, double t) {
  Eigen::VectorXd work = Eigen::VectorXd::Zero(modes.size()), force = work;
  ContactProblem problem;
  for (const Pair& pair : pairs) add_nodes(pair, problem);
  problem.rigid.setZero(problem.n_rows(), modes.held().cols());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::size_t first = modes.first_of_body(b), n = bodies[b].free_motions().size();
    if (n == 0) continue;
    const double sum = bodies[b].external_resultant(at[b], {work.data() + first, n});
    force.segment(static_cast<Index>(first), static_cast<Index>(n)).setConstant(sum);
    problem.rigid += modes.gaps(b, pairs) * modes.held().middleRows(static_cast<Index>(first), static_cast<Index>(n));
  }
  require_free_motions_unloaded(modes, work, force, t);
  if (problem.has_friction()) return;
  try {
    throw_if_unbalanced(problem,
                        {{}, held_resultant(modes, work, force), {}, idle_rows(pairs, t), held_force(modes, force)});
  } catch (const UnbalancedLoad& unbalanced) {
    report_unbalanced(modes, unbalanced, t);
  }
}

}  // namespace creepcontact::contact
