#include "creepcontact/simulation/contact_elasticity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace creepcontact::simulation {
namespace {

/// Smaller factors stay in the cache: waking the threads costs more than the pass.
constexpr std::int64_t parallel_bytes = 1 << 20;
constexpr double jacobian_tolerance = 1e-6;  // of products where they are iterated: a Krylov method asks for no more

/// @param step  0: the last accepted one
std::string kept_name(const char* what, std::size_t step, std::size_t body = 0) {
  return fmt::format("stiffness.kept.{}.{}.{}", step, what, body);
}

contact::CondensedInterface factorize(Model& model, Stopwatch& watch,
                                      const contact::CondensedInterface::Admission& admit) {
  const auto lap = watch.lap(Part::factorize);
  return {model.bodies, std::move(model.pairs), 1e6 * model.dense_limit_mb, admit};
}

}  // namespace

ContactElasticity::ContactElasticity(Model& model, Stopwatch& watch,
                                     const contact::CondensedInterface::Admission& admit)
    : model_(model),
      watch_(watch),
      interface_(factorize(model, watch, admit)),
      solver_(make_contact_solver(model, interface_.problem())),
      frozen_(interface_.problem(), std::max(model.schwarz.tolerance, jacobian_tolerance)) {
  set_changes_.assign(interface_.pairs().size(), 0);
  counters_.factorizations = static_cast<std::int64_t>(model.bodies.size());
  std::int64_t largest = 0, all = 0;
  for (const auto& body : model.bodies) {
    const std::int64_t bytes = body->factor().factor_bytes();
    largest = std::max(largest, bytes);
    all += bytes;
  }
  parallel_passes_ = all - largest > parallel_bytes;
  for (const auto& body : model.bodies) {
    const auto n_free = static_cast<std::size_t>(body->constraints().n_free());
    const auto n_full = static_cast<std::size_t>(body->constraints().n_full());
    const std::size_t n_stress = 6 * body->discretization().n_points();
    stiffness_changes_ = stiffness_changes_ || body->stiffness_changes();
    states_.push_back({std::vector<double>(n_full), std::vector<double>(n_stress)});
    work_.push_back({std::vector<double>(n_free), std::vector<double>(n_free), std::vector<double>(n_free),
                     std::vector<double>(n_full), std::vector<double>(n_full)});
  }
}

void ContactElasticity::pass_through_factors(const std::function<void(std::size_t)>& pass) const {
  const auto lap = watch_.lap(Part::solve);
  const int n_bodies = static_cast<int>(model_.bodies.size());
  // One thread cannot use the whole bandwidth of the memory, which is what a pass costs.
#pragma omp parallel for schedule(dynamic, 1) if (parallel_passes_)
  for (int b = 0; b < n_bodies; ++b) pass(static_cast<std::size_t>(b));
}

void ContactElasticity::forward() {
  pass_through_factors(
      [&](std::size_t b) { model_.bodies[b]->factor().forward(work_[b].right_hand_side, work_[b].factored); });
}

void ContactElasticity::backward(const Eigen::VectorXd& multiplier) {
  {
    const auto lap = watch_.lap(Part::contact);
    for (std::size_t b = 0; b < model_.bodies.size(); ++b) interface_.add_multipliers(b, multiplier, work_[b].factored);
  }
  pass_through_factors([&](std::size_t b) { model_.bodies[b]->factor().backward(work_[b].factored, work_[b].free); });
}

void ContactElasticity::keep_warm() {
  std::vector<int> changed;
  std::ranges::set_symmetric_difference(warm_.active, last_.active, std::back_inserter(changed));
  auto row = changed.begin();
  int end = 0;
  for (std::size_t p = 0; p < interface_.pairs().size() && !warm_.active.empty(); ++p) {
    end += interface_.pairs()[p].coupling.n_rows();
    const auto next = std::lower_bound(row, changed.end(), end);
    if (next != row) ++set_changes_[p];
    row = next;
  }
  warm_ = last_;
  if (!stiffness_changes_) return;
  if (!kept_.empty() && kept_.front().time == time_) kept_.erase(kept_.begin());
  kept_.insert(kept_.begin(), {time_, iterate_});
  if (kept_.size() > 2) kept_.pop_back();
}

void ContactElasticity::log_contact(ContactLog& log) {
  log_ = &log;
  solver_->set_recorder(&log);
}

void ContactElasticity::solve_contact(const contact::InterfaceLoad& load, const contact::ContactState& warm) {
  const auto lap = watch_.lap(Part::contact);
  if (log_) log_->begin_solve(load.time);
  try {
    contact::ContactResult result = solver_->solve(interface_.contact_load(load), warm);
    counters_.schwarz_iterations += result.iterations;
    ++counters_.contact_solves;
    last_ = std::move(result.state);
    gaps_ = std::move(result.gap);
  } catch (const contact::UnbalancedLoad& unbalanced) {
    interface_.report(unbalanced, load.time);
  }
}

void ContactElasticity::linearized(const CreepViews& creep_change, std::vector<std::vector<double>>& stress) {
  const std::size_t n_bodies = model_.bodies.size();
  contact::InterfaceLoad load = interface_.no_load();
  {
    const auto lap = watch_.lap(Part::material);
    for (std::size_t b = 0; b < n_bodies; ++b) {
      model_.bodies[b]->initial_strain_force(creep_change[b], work_[b].right_hand_side);
      model_.bodies[b]->clear_pins(work_[b].right_hand_side);
    }
  }
  forward();
  contact::ContactState change;
  if (interface_.n_rows() > 0) {
    const auto lap = watch_.lap(Part::contact);
    for (std::size_t b = 0; b < n_bodies; ++b) interface_.add_trace(b, work_[b].factored, load);
    // Initial strains are in equilibrium with themselves: no resultants.
    change = frozen_.solve(last_.active, {load.gap, {}}).state;
  }
  backward(change.multiplier);
  const auto lap = watch_.lap(Part::material);
  for (std::size_t b = 0; b < n_bodies; ++b) {
    const mechanics::Body& body = *model_.bodies[b];
    body.constraints().expand(work_[b].free, work_[b].no_displacement, work_[b].displacement);
    interface_.add_rigid_motion(b, change.rigid, work_[b].displacement);
    body.discretization().stress(work_[b].displacement, body.factored(), creep_change[b], stress[b]);
    if (stiffness_.scale != 1)
      for (double& component : stress[b]) component *= stiffness_.scale;
  }
  ++counters_.elastic_solves;
}

void ContactElasticity::save(Memory& memory) const {
  memory["contact.multiplier"].assign(warm_.multiplier.begin(), warm_.multiplier.end());
  memory["contact.rigid"].assign(warm_.rigid.begin(), warm_.rigid.end());
  memory["contact.active"].assign(warm_.active.begin(), warm_.active.end());
  memory["contact.sweeps_given_up"] = {solver_->has_given_up_sweeps() ? 1.0 : 0.0};
  if (!stiffness_changes_) return;
  for (const auto& body : model_.bodies) memory["stiffness.factor_times"].push_back(body->factor_time());
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    memory[kept_name("time", k)] = {kept_[k].time};
    for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
      memory[kept_name("factored", k, b)] = kept_[k].bodies[b].factored;
      memory[kept_name("free", k, b)] = kept_[k].bodies[b].free;
    }
  }
}

void ContactElasticity::restore(const Memory& memory) {
  const auto vector = [&](const char* name) {
    const std::vector<double>& values = memory.at(name);
    return Eigen::VectorXd(Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  warm_.multiplier = vector("contact.multiplier");
  warm_.rigid = vector("contact.rigid");
  const std::vector<double>& active = memory.at("contact.active");
  warm_.active.assign(active.begin(), active.end());
  last_ = warm_;
  if (memory.at("contact.sweeps_given_up").at(0) != 0) solver_->give_up_sweeps();
  if (!stiffness_changes_) return;
  const std::vector<double>& factor_times = memory.at("stiffness.factor_times");
  for (std::size_t b = 0; b < model_.bodies.size(); ++b) model_.bodies[b]->set_time(factor_times.at(b));
  refactorize();
  for (std::size_t k = 0; memory.contains(kept_name("time", k)); ++k) {
    kept_.push_back({memory.at(kept_name("time", k)).at(0), {}});
    for (std::size_t b = 0; b < model_.bodies.size(); ++b)
      kept_.back().bodies.push_back({memory.at(kept_name("factored", k, b)), memory.at(kept_name("free", k, b))});
  }
}

}  // namespace creepcontact::simulation
