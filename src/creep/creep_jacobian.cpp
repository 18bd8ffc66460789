/// The Jacobian of a CreepSystem: its products, its preconditioner, and systems with it.

#include <algorithm>
#include <limits>

#include "creepcontact/creep/creep_system.hpp"
#include "gasket_creep.hpp"
#include "heat_coupling.hpp"

namespace creepcontact::creep {
namespace {

/// A preconditioner need not follow every step: gamma may be off by this factor.
constexpr double same_gamma = 1.25;

}  // namespace

void CreepSystem::resize_tangents() {
  step_.tangents.resize(laws_.points().size());
  for (std::size_t b = 0; b < laws_.points().size(); ++b) step_.tangents[b].resize(laws_.points()[b].size());
}

void CreepSystem::jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                                 std::span<double> product) {
  const Evaluation& at = evaluate_step(t, y);
  ++jacobian_products_;
  if (heat_) return heat_products(at, y, v, product);
  const Eigen::VectorXd multiplier = solver_.linearized(at.equilibrium, strains(v), stress_change_);
  const auto lap = watch_.lap(Part::material);
  laws_.for_each_creeping([&](std::size_t b, const MaterialPoints& points) {
    points.derivative(laws_.state(b, at, y), {stress_change_[b], laws_.layout().part(b, v)},
                      laws_.layout().part(b, product));
  });
  gaskets_->derivative(at.equilibrium, y, multiplier, v, product);
}

const std::vector<std::vector<material::StressTangent>>& CreepSystem::step_tangents() {
  tangents_needed_ = true;
  if (step_.has_tangents) return step_.tangents;
  resize_tangents();
  laws_.for_each_creeping([&](std::size_t b, const MaterialPoints& points) {
    points.tangents(laws_.state(b, step_, step_.y), step_.tangents[b]);
  });
  step_.has_tangents = true;
  return step_.tangents;
}

void CreepSystem::prepare_preconditioner(double t, std::span<const double> y) {
  const Evaluation& at = evaluate_step(t, y);
  const auto lap = watch_.lap(Part::material);
  laws_.for_each_creeping([&](std::size_t b, const MaterialPoints&) {
    if (!local_[b]) preconditioners_[b].linearize(laws_.state(b, at, y), step_tangents()[b]);
  });
  gasket_jacobians_ = gaskets_->jacobians(at.equilibrium, y);
  if (heat_) heat_->rates().prepare(at.time, laws_.layout().temperatures(y), joint_values(assembly(), at.equilibrium));
  local_gamma_ = 0;
}

void CreepSystem::precondition(double gamma, std::span<const double> r, std::span<double> z) {
  const auto lap = watch_.lap(Part::material);
  const bool prepared = gamma < same_gamma * local_gamma_ && local_gamma_ < same_gamma * gamma;
  if (!prepared) local_gamma_ = gamma;
  laws_.for_each_creeping([&](std::size_t b, const MaterialPoints&) {
    const std::span<const double> right = laws_.layout().part(b, r);
    const std::span<double> result = laws_.layout().part(b, z);
    if (!local_[b]) return preconditioners_[b].apply(gamma, right, result);
    // At the last evaluation, which may be nearer than the point prepared for.
    if (!prepared) local_[b]->prepare(gamma, laws_.state(b, step_, step_.y));
    local_[b]->solution(right, {}, result);
  });
  gaskets_->precondition(gasket_jacobians_, gasket_flexibility(), gamma, r, z);
  if (heat_) heat_->rates().precondition(gamma, laws_.layout().temperatures(r), laws_.layout().temperatures(z));
}

Eigen::VectorXd CreepSystem::gasket_flexibility() const {
  if (gaskets_->empty()) return {};
  return contact::row_flexibility(solver_.interface().problem()) + step_.equilibrium.contact.compliance;
}

void CreepSystem::precondition_once(double t, std::span<const double> y, double gamma, std::span<const double> r,
                                    std::span<double> z) {
  const Evaluation& at = evaluate_step(t, y);
  const auto lap = watch_.lap(Part::material);
  laws_.for_each_creeping([&](std::size_t b, const MaterialPoints&) {
    const PointsState state = laws_.state(b, at, y);
    const std::span<const double> right = laws_.layout().part(b, r);
    const std::span<double> result = laws_.layout().part(b, z);
    if (local_[b])
      local_[b]->solve_points(gamma, state, right, result);
    else
      PointPreconditioner::apply_once(state, step_tangents()[b], gamma, right, result);
  });
  gaskets_->precondition(gaskets_->jacobians(at.equilibrium, y), gasket_flexibility(), gamma, r, z);
  if (!heat_) return;
  heat_->rates().prepare(at.time, laws_.layout().temperatures(y), joint_values(assembly(), at.equilibrium));
  heat_->rates().precondition(gamma, laws_.layout().temperatures(r), laws_.layout().temperatures(z));
}

void CreepSystem::prepare_tangent(double t, std::span<const double> y, double gamma) {
  const Evaluation& at = evaluate_step(t, y);
  if (!tangent_) tangent_.emplace(solver_, laws_.points(), *gaskets_, laws_.layout(), watch_);
  std::vector<PointsState> states;
  for (std::size_t b = 0; b < laws_.points().size(); ++b) states.push_back(laws_.state(b, at, y));
  tangent_->prepare(gamma, states, gaskets_->jacobians(at.equilibrium, y), at.equilibrium.stiffness_scale);
}

void CreepSystem::solve_tangent(std::span<const double> r, std::span<double> z) {
  tangent_->solve(step_.equilibrium.contact, r, z);
}

double CreepSystem::stable_step(double t, std::span<const double> y) {
  evaluate_step(t, y);
  const auto lap = watch_.lap(Part::material);
  step_tangents();
  double fastest = 0;
  if (!gaskets_->empty())
    fastest = gaskets_->stiffest_rate(gaskets_->jacobians(step_.equilibrium, y), gasket_flexibility());
  fastest = team().max(fastest);
  const double of_bodies = std::ranges::min(relaxation_times(step_));
  return 2 * (fastest > 0 ? std::min(of_bodies, 1 / fastest) : of_bodies);
}

std::vector<double> CreepSystem::relaxation_times(const Evaluation& at) const {
  std::vector<double> times(laws_.points().size(), std::numeric_limits<double>::infinity());
  std::vector<material::StressTangent> found;
  laws_.for_each_creeping([&](std::size_t b, const MaterialPoints& points) {
    const PointsState state = laws_.state(b, at, at.y);
    if (!at.has_tangents) {
      found.resize(points.size());
      points.tangents(state, found);
    }
    const double fastest = points.stiffest_rate(state, at.has_tangents ? at.tangents[b] : found);
    if (fastest > 0) times[b] = 1 / fastest;
  });
  team().min(times);
  return times;
}

}  // namespace creepcontact::creep
