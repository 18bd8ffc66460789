#include "creepcontact/contact/load_balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "solver/unbalanced_load.hpp"

namespace creepcontact::contact {
namespace {

constexpr double force_round_off = 1e-13;  // of the forces on a body: what sums to zero but for it
constexpr double unconstrained_work =
    1e-8;  // of the forces on the body: rounding, or a load along an unconstrained motion
constexpr double residual_of_meshes = 1e-4;  // what an asymmetric mesh may leave of balanced loads

}  // namespace

void add_nodes(const Pair& pair, ContactProblem& problem) {
  const AdmissibleSet set = pair.coupling.type == ContactType::tied ? AdmissibleSet::space
                            : pair.coupling.has_friction()          ? AdmissibleSet::cone
                                                                    : AdmissibleSet::half_line;
  const int width = static_cast<int>(pair.coupling.rows_per_node());
  for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i)
    problem.add_node(set, width, static_cast<int>(pair.slave_body), static_cast<int>(pair.master_body));
}

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

Eigen::VectorXd held_resultant(const RigidBodyModes& modes, const Eigen::VectorXd& work, const Eigen::VectorXd& force) {
  const Eigen::VectorXd resultant = modes.held().transpose() * work, sum = held_force(modes, force);
  return (resultant.array().abs() > force_round_off * sum.array()).select(resultant, 0.0);
}

Eigen::VectorXd held_force(const RigidBodyModes& modes, const Eigen::VectorXd& force) {
  return modes.held().cwiseAbs().transpose() * force;
}

void report_unbalanced(const RigidBodyModes& modes, const UnbalancedLoad& unbalanced, double t) {
  throw ModelError(
      fmt::format("{}: at t = {:.6g} the loads move the assembly along this motion and no contact prevents it; add a "
                  "support, or a load that presses the bodies together",
                  modes.describe(modes.held() * unbalanced.motion), t));
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
