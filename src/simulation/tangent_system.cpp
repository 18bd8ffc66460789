#include "creepcontact/simulation/tangent_system.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "creepcontact/ode/system.hpp"

namespace creepcontact::simulation {

TangentSystem::TangentSystem(const ContactElasticity& elasticity, const std::vector<MaterialPoints>& points,
                             const StateLayout& layout, Stopwatch& watch)
    : elasticity_(elasticity), layout_(layout), watch_(watch), sides_(points.size()) {
  for (std::size_t b = 0; b < sides_.size(); ++b) {
    const mechanics::Body& body = *elasticity.model().bodies[b];
    if (points[b].empty()) continue;
    Side& side = sides_[b];
    side.material.emplace(points[b]);
    side.stress.resize(6 * body.discretization().n_points());
    side.strain.resize(side.stress.size());
    side.displacement.resize(static_cast<std::size_t>(body.constraints().n_full()));
    side.no_displacement.resize(side.displacement.size());
    side.free.resize(static_cast<std::size_t>(body.constraints().n_free()));
  }
}

void TangentSystem::factorize(std::size_t b) {
  Side& side = sides_[b];
  mechanics::Body& body = *elasticity_.model().bodies[b];
  const auto lap = watch_.lap(Part::factorize);
  if (!side.factor) side.factor.emplace(body.factor().same_pattern());
  ++factorizations_;
  try {
    side.factor->factorize(body.stiffness(side.material->moduli()));
  } catch (const linalg::SingularMatrix& error) {
    throw ode::RecoverableError(
        fmt::format("body '{}': the tangent stiffness is not positive definite (reciprocal condition {:.2g})",
                    body.name(), error.rcond));
  }
}

void TangentSystem::prepare(double gamma, std::span<const double> y) {
  interface_.reset();
  std::vector<const linalg::SupernodalCholesky*> factors(sides_.size());
  for (std::size_t b = 0; b < sides_.size(); ++b) {
    if (!sides_[b].material) continue;
    {
      const auto lap = watch_.lap(Part::material);
      sides_[b].material->prepare(gamma, elasticity_.states()[b].stress, y.data() + layout_.offset(b));
    }
    factorize(b);
    factors[b] = &*sides_[b].factor;
  }
  const auto lap = watch_.lap(Part::factorize);
  interface_ =
      std::make_unique<contact::TangentInterface>(elasticity_.interface(), factors, 1 / elasticity_.stiffness_scale());
}

template <typename Work>
void TangentSystem::for_each_side(const Work& work) {
  for (std::size_t b = 0; b < sides_.size(); ++b)
    if (sides_[b].material) work(b, sides_[b], *elasticity_.model().bodies[b]);
}

template <typename Pass>
void TangentSystem::pass_through_factors(const Pass& pass) {
  elasticity_.pass_through_factors([&](std::size_t b) {
    if (sides_[b].material) pass(sides_[b]);
  });
}

Eigen::VectorXd TangentSystem::forward(std::span<const double> r) {
  {
    const auto lap = watch_.lap(Part::material);
    for_each_side([&](std::size_t b, Side& side, const mechanics::Body& body) {
      side.material->initial_stress(r.data() + layout_.offset(b), side.stress);
      std::fill(side.displacement.begin(), side.displacement.end(), 0.0);
      body.discretization().add_initial_stress_force(side.material->moduli(), side.stress, side.displacement);
      body.constraints().restrict_to_free(side.displacement, side.free);
      // Initial strains are in equilibrium with themselves: only the pins' forces are to be taken out.
      body.clear_pins(side.free);
    });
  }
  pass_through_factors([](Side& side) { side.factor->forward(side.free, side.free); });
  const auto lap = watch_.lap(Part::contact);
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(interface_->n_rows());
  for_each_side([&](std::size_t b, Side& side, const mechanics::Body&) { interface_->add_trace(b, side.free, gap); });
  return gap;
}

void TangentSystem::backward(const contact::ContactState& change) {
  {
    const auto lap = watch_.lap(Part::contact);
    for_each_side([&](std::size_t b, Side& side, const mechanics::Body&) {
      interface_->add_multipliers(b, change.multiplier, side.free);
    });
  }
  pass_through_factors([](Side& side) { side.factor->backward(side.free, side.free); });
}

contact::ContactState TangentSystem::close(const Eigen::VectorXd& gap) {
  const auto lap = watch_.lap(Part::contact);
  try {
    return interface_->close(elasticity_.active_set(), gap);
  } catch (const SolverError& error) {
    throw ode::RecoverableError(error.what());
  }
}

void TangentSystem::solve(std::span<const double> r, std::span<double> z) {
  // Nothing but contact strains an elastic body, and its displacement is not asked for: it needs no pass.
  const contact::ContactState change = close(forward(r));
  backward(change);
  const auto lap = watch_.lap(Part::material);
  for_each_side([&](std::size_t b, Side& side, const mechanics::Body& body) {
    body.constraints().expand(side.free, side.no_displacement, side.displacement);
    elasticity_.interface().add_rigid_motion(b, change.rigid, side.displacement);
    body.discretization().tangent_strain(side.displacement, side.material->moduli(), side.stress, side.strain);
    side.material->solution(r.data() + layout_.offset(b), side.strain, z.data() + layout_.offset(b));
  });
  ++solves_;
}

}  // namespace creepcontact::simulation
