#include "creepcontact/simulation/contact_elasticity.hpp"

#include <algorithm>

namespace creepcontact::simulation {
namespace {

constexpr double jacobian_tolerance = 1e-6;  // of products where they are iterated: a Krylov method asks for no more

contact::CondensedInterface factorize(Model& model, Stopwatch& watch) {
  const auto lap = watch.lap(Part::factorize);
  return {model.bodies, std::move(model.pairs), 1e6 * model.dense_limit_mb};
}

}  // namespace

ContactElasticity::ContactElasticity(Model& model, Stopwatch& watch)
    : model_(model),
      watch_(watch),
      interface_(factorize(model, watch)),
      solver_(make_contact_solver(model, interface_.problem())),
      frozen_(interface_.problem(), std::max(model.schwarz.tolerance, jacobian_tolerance)) {
  counters_.factorizations = static_cast<std::int64_t>(model.bodies.size());
  for (const auto& body : model.bodies) {
    const auto n_free = static_cast<std::size_t>(body->constraints().n_free());
    const auto n_full = static_cast<std::size_t>(body->constraints().n_full());
    const std::size_t n_stress = 6 * body->discretization().n_points();
    states_.push_back({std::vector<double>(n_full), std::vector<double>(n_stress)});
    work_.push_back({std::vector<double>(n_free), std::vector<double>(n_free), std::vector<double>(n_free),
                     std::vector<double>(n_full), std::vector<double>(n_full)});
  }
}

void ContactElasticity::forward(std::size_t body, contact::InterfaceLoad& load) {
  interface_.take_resultant(body, work_[body].right_hand_side, load);
  const auto lap = watch_.lap(Part::solve);
  model_.bodies[body]->factor().forward(work_[body].right_hand_side, work_[body].factored);
  interface_.add_trace(body, work_[body].factored, load);
}

void ContactElasticity::log_contact(ContactLog& log) {
  log_ = &log;
  solver_->set_recorder(&log);
}

void ContactElasticity::solve_contact(double t, const contact::ContactLoad& load) {
  const auto lap = watch_.lap(Part::contact);
  if (log_) log_->begin_solve(t);
  try {
    contact::ContactResult result = solver_->solve(load, warm_);
    counters_.schwarz_iterations += result.iterations;
    ++counters_.contact_solves;
    last_ = std::move(result.state);
    gaps_ = std::move(result.gap);
  } catch (const contact::UnbalancedLoad& unbalanced) {
    interface_.report(unbalanced, t);
  }
}

void ContactElasticity::backward(std::size_t body, const Eigen::VectorXd& multiplier) {
  interface_.add_multipliers(body, multiplier, work_[body].factored);
  const auto lap = watch_.lap(Part::solve);
  model_.bodies[body]->factor().backward(work_[body].factored, work_[body].free);
}

void ContactElasticity::solve(double t, const CreepViews& creep) {
  const std::size_t n_bodies = model_.bodies.size();
  for (const auto& body : model_.bodies) body->set_time(t);
  contact::InterfaceLoad load = interface_.initial_load(t);
  for (std::size_t b = 0; b < n_bodies; ++b) {
    {
      const auto lap = watch_.lap(Part::material);
      model_.bodies[b]->right_hand_side(creep[b], work_[b].right_hand_side);
    }
    forward(b, load);
  }
  if (interface_.n_rows() > 0) solve_contact(t, interface_.contact_load(load));
  for (std::size_t b = 0; b < n_bodies; ++b) {
    backward(b, last_.multiplier);
    const auto lap = watch_.lap(Part::material);
    const mechanics::Body& body = *model_.bodies[b];
    body.constraints().expand(work_[b].free, body.prescribed(), states_[b].displacement);
    interface_.add_rigid_motion(b, last_.rigid, states_[b].displacement);
    body.discretization().stress(states_[b].displacement, body.elastic(), creep[b], states_[b].stress);
  }
  ++counters_.elastic_solves;
}

void ContactElasticity::linearized(const CreepViews& creep_change, std::vector<std::vector<double>>& stress) {
  const std::size_t n_bodies = model_.bodies.size();
  contact::InterfaceLoad load = interface_.no_load();
  for (std::size_t b = 0; b < n_bodies; ++b) {
    {
      const auto lap = watch_.lap(Part::material);
      model_.bodies[b]->initial_strain_force(creep_change[b], work_[b].right_hand_side);
    }
    forward(b, load);
  }
  contact::ContactState change;
  if (interface_.n_rows() > 0) {
    const auto lap = watch_.lap(Part::contact);
    // Initial strains are in equilibrium with themselves: no resultants.
    change = frozen_.solve(last_.active, {load.gap, {}}).state;
  }
  for (std::size_t b = 0; b < n_bodies; ++b) {
    backward(b, change.multiplier);
    const auto lap = watch_.lap(Part::material);
    const mechanics::Body& body = *model_.bodies[b];
    body.constraints().expand(work_[b].free, work_[b].no_displacement, work_[b].displacement);
    interface_.add_rigid_motion(b, change.rigid, work_[b].displacement);
    body.discretization().stress(work_[b].displacement, {body.elastic().moduli, {}}, creep_change[b], stress[b]);
  }
  ++counters_.elastic_solves;
}

}  // namespace creepcontact::simulation
