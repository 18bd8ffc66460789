#include "slip_advance.hpp"

#include <algorithm>
#include <cmath>

#include "creepcontact/base/index.hpp"

namespace creepcontact::creep {
namespace {

using contact::ContactStatus;

ContactStatus status_before(const SlipNode& node, const contact::ContactState& state) {
  return state.nodes.empty() ? ContactStatus::stick : node.at(state).status;
}

/// Time until a node that slips opens, if its pressure continues to fall.
double time_to_open(const SlipNode& node, const PathPoint& from) {
  const double rate = from.friction.rate[node.normal_row];
  return rate < 0 ? from.contact.multiplier[node.normal_row] / -rate : 0.0;
}

}  // namespace

SlipAdvance::SlipAdvance(const contact::ContactProblem& problem, std::span<const contact::Pair> pairs)
    : n_rows_(problem.node_of_row.size()) {
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const contact::MortarCoupling& coupling = pairs[p].coupling;
    if (!coupling.has_friction()) continue;
    for (std::size_t i = 0; i < coupling.nodes.size(); ++i) {
      const std::size_t number = static_cast<std::size_t>(pairs[p].first_node) + i;
      const contact::ContactNode& node = problem.nodes[number];
      nodes_.push_back({number, p, node.first_row, node.first_row + 1, node.n_rows - 1, coupling.area[i]});
    }
  }
}

Eigen::VectorXd SlipAdvance::reference(const PathPoint& from, double t) const {
  const SlipHistory& friction = from.friction;
  Eigen::VectorXd result = friction.slip;
  if (friction.is_fresh || friction.gap.size() == 0 || !(t > friction.time)) return result;
  for (const SlipNode& node : nodes_) {
    if (status_before(node, from.contact) != ContactStatus::open) continue;
    const double closing = -friction.rate[node.normal_row], gap = friction.gap[node.normal_row];
    if (!(closing > 0) || !(gap > 0)) continue;
    const double moving = std::min(t - friction.time, gap / closing);
    node.tangential(result) += moving * node.tangential(friction.rate);
  }
  return result;
}

void SlipAdvance::add_rates(const PathPoint& from, double duration, const contact::ContactState& to,
                            SlipHistory& next) const {
  next.rate.setZero(static_cast<Index>(n_rows_));
  next.is_fresh = !(duration > min_relative_step * std::abs(next.time));
  if (next.is_fresh) return;
  for (const SlipNode& node : nodes_) {
    const ContactStatus before = status_before(node, from.contact), now = node.at(to).status;
    const bool stays_open = before == ContactStatus::open && now == ContactStatus::open;
    if (!stays_open && now != ContactStatus::slip) continue;
    node.tangential(next.rate) = (node.tangential(next.slip) - node.tangential(from.friction.slip)) / duration;
    const Index row = node.normal_row;
    if (now == ContactStatus::slip)
      next.rate[row] = before == ContactStatus::open || from.contact.multiplier.size() == 0
                           ? 0.0
                           : (to.multiplier[row] - from.contact.multiplier[row]) / duration;
    else if (from.friction.gap.size() > 0)
      next.rate[row] = (next.gap[row] - from.friction.gap[row]) / duration;
  }
}

SlipHistory SlipAdvance::advanced(const PathPoint& from, double t, const Eigen::VectorXd& reference,
                                  const contact::ContactState& to, const Eigen::VectorXd& gaps) const {
  SlipHistory next = from.friction;
  const double duration = t - from.friction.time;
  next.time = t;
  next.gap = gaps + reference;
  const Eigen::VectorXd& before = from.contact.multiplier;
  for (const SlipNode& node : nodes_) {
    const ContactStatus status = node.at(to).status, last = status_before(node, from.contact);
    const Eigen::VectorXd slip = node.tangential(gaps), traction = node.tangential(to.multiplier);
    // An open node slides along, so that slip counts from touching.
    node.tangential(next.slip) = node.tangential(reference) + slip;
    auto direction = node.tangential(next.direction);
    const Eigen::VectorXd old = direction;
    double& path = next.path[static_cast<Index>(node.number)];
    if (status != ContactStatus::slip) {
      // At a breakpoint without a jump nothing slips, and rounding decides what a node at the limit is.
      constexpr double traction_tolerance = 1e-8;
      const bool unchanged =
          before.size() > 0 && status == ContactStatus::stick &&
          (to.multiplier - before).segment(node.normal_row, node.n + 1).norm() <= traction_tolerance * traction.norm();
      if (!unchanged) direction.setZero();
      if (status == ContactStatus::open && last == ContactStatus::slip && !from.friction.is_fresh) {
        const double slipping = std::clamp(time_to_open(node, from), 0.0, std::max(0.0, duration));
        const double weighted = slipping * node.tangential(from.friction.rate).norm();
        path += weighted / node.area;
        next.dissipated[node.pair] += weighted * node.tangential(before).norm() / 2;
      }
      continue;
    }
    direction.setZero();
    path += slip.norm() / node.area;
    // What slips only at the end of the step does so under the traction of the limit, reached before the slip; what
    // closes in it, under one that grows from zero.
    Eigen::VectorXd mean = traction;
    if (last == ContactStatus::open)
      mean = traction / 2;
    else if (before.size() > 0 && old.dot(traction) > 0)
      mean = (traction + node.tangential(before)) / 2;
    next.dissipated[node.pair] += std::max(0.0, -mean.dot(slip));  // below zero only by the solver's tolerance
    if (traction.norm() > 0) direction = traction.normalized();
  }
  add_rates(from, duration, to, next);
  return next;
}

}  // namespace creepcontact::creep
