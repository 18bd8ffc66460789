/// The equilibrium of all bodies in contact with a stiffness that may be another than that of the factors.

#include <algorithm>
#include <cmath>
#include <limits>

#include "creepcontact/numerics/point_sums.hpp"
#include "creepcontact/simulation/contact_elasticity.hpp"

namespace creepcontact::simulation {
namespace {

constexpr double exact = 1e-12;             // of the stiffness: rounding
constexpr double stress_tolerance = 1e-10;  // of the stress in the body, energy norm: far below any integrator's
constexpr double rounding = 1e-12;          // of the displacement, energy norm
constexpr double stalled = 0.9;  // where an iteration changes more than this part of what the last did, it stands
constexpr double farthest = 2;   // extrapolation, in steps
constexpr double good_if_stalled = 1e-8;  // of the displacement: rounding in an ill-conditioned stiffness

/// Twice the elastic energy, integral sigma H^-1 sigma.
double elastic_energy(const mechanics::Body& body, const std::vector<double>& stress) {
  const std::span<const double> weights = body.discretization().weights();
  const mechanics::ElasticState elastic = body.elastic();
  return numerics::sum_over_points(stress.size() / 6, [&](std::size_t p) {
    const Eigen::Map<const Tensor6> sigma(stress.data() + 6 * p);
    const material::Moduli& h = elastic.at(p);
    const double mean = tensor::trace(sigma) / 3;
    const double deviatoric = (sigma.squaredNorm() - 3 * mean * mean) / (2 * h.mu);
    return weights[p] * (deviatoric + mean * mean / (h.lambda + 2.0 / 3.0 * h.mu));
  });
}

Eigen::Map<Eigen::VectorXd> vector(std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}
Eigen::Map<const Eigen::VectorXd> vector(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

}  // namespace

ContactElasticity::StiffnessChange ContactElasticity::stiffness_change() const {
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  for (const auto& body : model_.bodies) {
    const auto [low, high] = body->stiffness_ratio();
    least = std::min(least, low);
    largest = std::max(largest, high);
  }
  return {(least + largest) / 2, (largest - least) / (largest + least)};
}

void ContactElasticity::refactorize() {
  const auto lap = watch_.lap(Part::factorize);
  std::vector<std::size_t> changed;
  for (std::size_t b = 0; b < model_.bodies.size(); ++b)
    if (model_.bodies[b]->stiffness_ratio() != std::pair(1.0, 1.0)) changed.push_back(b);
  interface_.refactorize(changed);
  solver_->flexibility_changed();
  frozen_.flexibility_changed();
  counters_.factorizations += std::ssize(changed);
  kept_.clear();  // y = L^T u is that of other factors
  stiffness_ = {};
}

void ContactElasticity::solve(double t, const CreepViews& creep) {
  for (const auto& body : model_.bodies) body->set_time(t);
  model_.temperature_watch.see(t, model_.bodies);
  time_ = t;
  stiffness_ = stiffness_change();
  if (stiffness_.rest > model_.refactor_change) refactorize();
  if (iterate(t, creep)) return;
  refactorize();
  iterate(t, creep);
}

bool ContactElasticity::iterate(double t, const CreepViews& creep) {
  const contact::InterfaceLoad given = start(t, creep);
  contact::ContactState from = warm_;
  from.multiplier /= stiffness_.scale;
  const double contraction = stiffness_.rest / (1 - stiffness_.rest);
  double before = std::numeric_limits<double>::infinity();
  while (true) {
    const double change = advance(given, from, creep);
    if (stiffness_.rest <= exact) break;
    const double size = displacement_norm();
    if (contraction * change <= std::max(stress_tolerance * stress_norm(), rounding * size)) break;
    if (change > stalled * before) {
      if (change > good_if_stalled * size) return false;
      break;
    }
    before = change;
    from = last_;
    leave_imbalance();
  }
  last_.multiplier *= stiffness_.scale;
  return true;
}

contact::InterfaceLoad ContactElasticity::start(double t, const CreepViews& creep) {
  const auto lap = watch_.lap(Part::material);
  contact::InterfaceLoad given = interface_.initial_load(t);
  for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
    model_.bodies[b]->right_hand_side(creep[b], work_[b].right_hand_side);
    model_.bodies[b]->clear_pins(work_[b].right_hand_side);
    interface_.add_resultant(b, given);
  }
  given.work /= stiffness_.scale;
  given.force /= stiffness_.scale;
  iterate_.clear();
  if (!stiffness_changes_) return given;
  // If s K0 is all of the stiffness, the first solve is exact from anywhere.
  if (stiffness_.rest <= exact || kept_.empty()) {
    iterate_.resize(model_.bodies.size());
    return given;
  }
  extrapolate(t);
  for (std::size_t b = 0; b < model_.bodies.size(); ++b) update_state(b, warm_.rigid, creep[b]);
  leave_imbalance();
  return given;
}

void ContactElasticity::extrapolate(double t) {
  iterate_ = kept_.front().bodies;
  if (kept_.size() < 2) return;
  const double last = kept_[0].time, before = kept_[1].time;
  // Steps that grow fast follow those after a jump, which tell little of what comes.
  const double part = std::clamp((t - last) / (last - before), -1.0, farthest);
  for (std::size_t b = 0; b < iterate_.size(); ++b) {
    const Iterate& old = kept_[1].bodies[b];
    vector(iterate_[b].factored) += part * (vector(iterate_[b].factored) - vector(old.factored));
    vector(iterate_[b].free) += part * (vector(iterate_[b].free) - vector(old.free));
  }
}

void ContactElasticity::update_state(std::size_t b, const Eigen::VectorXd& rigid,
                                     const mechanics::CreepStrainView& creep) {
  const mechanics::Body& body = *model_.bodies[b];
  const std::vector<double>& free = stiffness_changes_ ? iterate_[b].free : work_[b].free;
  body.constraints().expand(free, body.prescribed(), states_[b].displacement);
  interface_.add_rigid_motion(b, rigid, states_[b].displacement);
  body.discretization().stress(states_[b].displacement, body.elastic(), creep, states_[b].stress);
}

void ContactElasticity::leave_imbalance() {
  const auto lap = watch_.lap(Part::material);
  for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
    const mechanics::Body& body = *model_.bodies[b];
    body.imbalance(states_[b].stress, iterate_[b].free, work_[b].right_hand_side);
    body.clear_pins(work_[b].right_hand_side);
  }
}

double ContactElasticity::advance(const contact::InterfaceLoad& given, const contact::ContactState& from,
                                  const CreepViews& creep) {
  const std::size_t n_bodies = model_.bodies.size();
  forward();
  contact::InterfaceLoad load = given;
  {
    const auto lap = watch_.lap(Part::contact);
    for (std::size_t b = 0; b < n_bodies; ++b) {
      auto y = vector(work_[b].factored);
      if (stiffness_.scale != 1) y /= stiffness_.scale;
      if (stiffness_changes_ && !iterate_[b].factored.empty()) y += vector(iterate_[b].factored);
      interface_.add_trace(b, work_[b].factored, load);
    }
  }
  if (interface_.n_rows() > 0) solve_contact(load, from);
  backward(last_.multiplier);
  double change = 0;
  const auto lap = watch_.lap(Part::material);
  for (std::size_t b = 0; b < n_bodies; ++b) {
    if (stiffness_changes_) {
      auto& [factored, free] = iterate_[b];
      factored.resize(work_[b].factored.size());  // zeros at the start from no displacement
      change += (vector(work_[b].factored) - vector(factored)).squaredNorm();
      factored = work_[b].factored;
      free = work_[b].free;
    }
    update_state(b, last_.rigid, creep[b]);
  }
  ++counters_.elastic_solves;
  return std::sqrt(change);
}

double ContactElasticity::displacement_norm() const {
  double sum = 0;
  for (const Iterate& iterate : iterate_) sum += vector(iterate.factored).squaredNorm();
  return std::sqrt(sum);
}

double ContactElasticity::stress_norm() const {
  double sum = 0;
  for (std::size_t b = 0; b < model_.bodies.size(); ++b) sum += elastic_energy(*model_.bodies[b], states_[b].stress);
  return std::sqrt(sum);
}

}  // namespace creepcontact::simulation
