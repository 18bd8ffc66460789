#include "creepcontact/creep/equilibrium_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "contact_broadcast.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/base/log.hpp"
#include "slip_advance.hpp"

namespace creepcontact::creep {
namespace {

constexpr double jacobian_tolerance = 1e-6;  // of products where they are iterated: a Krylov method asks for no more

/// @param step  0: the last accepted one
std::string kept_name(const char* what, std::size_t step, std::size_t body = 0) {
  return fmt::format("stiffness.kept.{}.{}.{}", step, what, body);
}

using creep::packed;
std::vector<double> packed(const Eigen::VectorXd& vector) {
  return {vector.begin(), vector.end()};
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::VectorXd::Map(values.data(), std::ssize(values));
}

void save_friction(const History& history, Memory& memory) {
  const SlipHistory& friction = history.friction;
  memory["contact.nodes"] = packed(history.contact.nodes);
  memory["contact.image"] = packed(history.contact.image);
  memory["contact.factored"] = packed(history.contact.factored);
  memory["friction.slip"] = packed(friction.slip);
  memory["friction.gap"] = packed(friction.gap);
  memory["friction.rate"] = packed(friction.rate);
  memory["friction.direction"] = packed(friction.direction);
  memory["friction.path"] = packed(friction.path);
  memory["friction.dissipated"] = friction.dissipated;
  memory["friction.time"] = {friction.time, friction.is_fresh ? 1.0 : 0.0};
}

void restore_friction(const Memory& memory, History& history) {
  SlipHistory& friction = history.friction;
  history.contact.nodes = unpacked(memory.at("contact.nodes"));
  history.contact.image = vector_of(memory.at("contact.image"));
  history.contact.factored = unpacked(memory.at("contact.factored"));
  friction.slip = vector_of(memory.at("friction.slip"));
  friction.direction = vector_of(memory.at("friction.direction"));
  friction.path = vector_of(memory.at("friction.path"));
  friction.dissipated = memory.at("friction.dissipated");
  const auto clock = memory.find("friction.time");
  if (clock == memory.end()) {  // of an earlier version: the next step is taken as it is
    friction.time = memory.at("friction.turning").at(0);
    return;
  }
  friction.time = clock->second.at(0);
  friction.is_fresh = clock->second.at(1) != 0;
  friction.gap = vector_of(memory.at("friction.gap"));
  friction.rate = vector_of(memory.at("friction.rate"));
}

}  // namespace

EquilibriumSolver::EquilibriumSolver(const Assembly& assembly, const SolverOptions& options, Stopwatch& watch,
                                     const contact::CondensedInterface::Admission& admit)
    : EquilibriumSolver(assembly, options, watch, admit, assembly.at(0)) {}

EquilibriumSolver::EquilibriumSolver(const Assembly& assembly, const SolverOptions& options, Stopwatch& watch,
                                     const contact::CondensedInterface::Admission& admit,
                                     const std::vector<mechanics::BodyConditions>& at_start)
    : assembly_(assembly),
      options_(options),
      watch_(watch),
      interface_([&] {
        const auto lap = watch.lap(Part::factorize);
        return contact::CondensedInterface(assembly.bodies(), assembly.pairs(), assembly.rigid_body_modes(), at_start,
                                           1e6 * options.dense_limit_mb, admit, options.stiffness_solver,
                                           assembly.team());
      }()),
      contact_solver_(make_contact_solver()),
      active_set_(interface_.problem(), std::max(options.schwarz.tolerance, jacobian_tolerance)),
      slip_advance_(std::make_unique<const SlipAdvance>(interface_.problem(), assembly.pairs())) {
  counters_.factorizations = std::ssize(assembly.bodies());
  for (const mechanics::Body& body : assembly.bodies()) {
    const std::size_t n_free = body.constraints().n_free();
    const std::size_t n_full = body.constraints().n_full();
    stiffness_changes_ = stiffness_changes_ || body.stiffness_changes();
    work_.push_back({std::vector<double>(n_free), std::vector<double>(n_free), std::vector<double>(n_free),
                     std::vector<double>(n_full), std::vector<double>(n_full)});
  }
  solver_error_ = interface_.error_bound();
}

EquilibriumSolver::~EquilibriumSolver() = default;

std::unique_ptr<contact::ContactSolver> EquilibriumSolver::make_contact_solver() const {
  if (!interface_.is_here()) return nullptr;
  const contact::ContactProblem& problem = interface_.problem();
  if (problem.has_friction()) {
    contact::FrictionOptions options{options_.friction, options_.schwarz};
    if (problem.large != nullptr) options.schwarz.acceleration = contact::SchwarzOptions::Acceleration::cg;
    return contact::friction_solver(problem, options);
  }
  if (problem.large == nullptr)
    return options_.use_schwarz ? contact::schwarz_solver(problem, options_.schwarz)
                                : contact::active_set_solver(problem);
  constexpr int max_iterations = 1000;
  contact::SchwarzOptions options = options_.schwarz;
  if (!options_.use_schwarz || options.acceleration != contact::SchwarzOptions::Acceleration::cg)
    log::warning(
        "contact: {} multipliers are too many for dense matrices; conjugate gradients without them are used "
        "(contact_solver.dense_limit_mb sets the limit)",
        problem.n_rows());
  options.acceleration = contact::SchwarzOptions::Acceleration::cg;
  options.max_iterations = std::max(options.max_iterations, max_iterations);
  return contact::schwarz_solver(problem, options);
}

void EquilibriumSolver::add_traces(Eigen::VectorXd& gap) {
  const auto lap = watch_.lap(Part::contact);
  for (std::size_t b = 0; b < work_.size(); ++b) interface_.add_trace(b, work_[b].factored, gap);
}

void EquilibriumSolver::forward() {
  const auto lap = watch_.lap(Part::solve);
  std::vector<linalg::Substitution> substitutions;
  for (std::size_t b = 0; b < work_.size(); ++b)
    substitutions.push_back({&interface_.factored(b).solver(), work_[b].right_hand_side, work_[b].factored});
  linalg::forward(substitutions);
}

void EquilibriumSolver::backward(const Eigen::VectorXd& multiplier) {
  {
    const auto lap = watch_.lap(Part::contact);
    for (std::size_t b = 0; b < work_.size(); ++b) interface_.add_multipliers(b, multiplier, work_[b].factored);
  }
  const auto lap = watch_.lap(Part::solve);
  std::vector<linalg::Substitution> substitutions;
  for (std::size_t b = 0; b < work_.size(); ++b)
    substitutions.push_back({&interface_.factored(b).solver(), work_[b].factored, work_[b].free});
  linalg::backward(substitutions);
}

contact::ContactState EquilibriumSolver::contact_change(const contact::ContactState& at, const Eigen::VectorXd& gap) {
  contact::ContactState change;
  together(assembly_.team(), [&] {
    if (interface_.is_here()) change = active_set_.solve_change(at, gap);
  });
  broadcast(assembly_.team(), change);
  return change;
}

void EquilibriumSolver::set_recorder(contact::IterationRecorder* recorder) {
  recorder_ = recorder;
  if (contact_solver_) contact_solver_->set_recorder(recorder);
}

void EquilibriumSolver::set_stop(const StopRequest& stop) {
  stop_ = stop;
  if (contact_solver_) contact_solver_->set_stop(stop);
  active_set_.set_stop(stop);
}

History EquilibriumSolver::new_history() const {
  History history;
  history.set_changes.assign(assembly_.pairs().size(), 0);
  history.interference.assign(assembly_.pairs().size(), 0.0);
  if (interface_.problem().has_friction()) {
    SlipHistory& friction = history.friction;
    friction.slip.setZero(interface_.n_rows());
    friction.direction.setZero(interface_.n_rows());
    friction.rate.setZero(interface_.n_rows());
    friction.path.setZero(std::ssize(interface_.problem().nodes));
    friction.dissipated.assign(assembly_.pairs().size(), 0.0);
  }
  return history;
}

History EquilibriumSolver::initial_history(int substeps) {
  History history = new_history();
  const bool has_friction = interface_.problem().has_friction();
  const std::vector<std::size_t> preloads = preloads_due(0, history);
  if (!has_friction && preloads.empty()) return history;
  Equilibrium at;
  assembly_.update(0, at.conditions);
  if (stiffness_change(at.conditions).rest > 0) refactorize(at.conditions);
  const std::vector<mechanics::CreepStrainView> no_creep(work_.size());
  // All of it is linear in the loads: one pass serves all substeps.
  contact::InterfaceLoad full = start(no_creep, history, {}, at);
  forward();
  add_traces(full.gap);
  const Eigen::VectorXd unloaded = interface_.unloaded_gap();
  const double longest = has_friction ? 1.0 / substeps : 1.0, shortest = longest / 64;
  double reached = 0, step = longest;
  while (reached < 1) {
    // Equal steps end where they should in spite of round-off.
    const double part = reached + step > 1 - 1e-9 ? 1 : reached + step;
    contact::InterfaceLoad load = full;
    load.gap = part * full.gap + (1 - part) * unloaded;
    at.time = part;  // for the rates of slip
    if (has_friction) load.gap -= slip_advance_->reference({history.contact, history.friction}, part);
    load.work *= part;
    load.force *= part;
    load.friction.direction = history.friction.direction;
    const auto solve = [&](const History& trial) -> const Equilibrium& {
      contact::InterfaceLoad with_interference = load;
      with_interference.gap += interference_gaps(trial.interference);
      solve_contact(with_interference, trial.contact, at);
      return at;
    };
    try {
      if (preloads.empty())
        solve(history);
      else
        find_interference(preloads, part, history, solve);
    } catch (const SolverError&) {
      step /= 2;
      if (step < shortest) throw;
      continue;
    } catch (const contact::SlidingOff&) {
      step /= 2;
      if (step < shortest) throw;
      continue;
    }
    if (has_friction) history.friction = slip_until(at, history);
    history.contact = at.contact;
    reached = part;
    step = std::min(2 * step, longest);
  }
  if (has_friction) {
    history.friction.time = 0;
    history.friction.rate.setZero();
    history.friction.is_fresh = true;
  }
  history.preloaded_until = 0;
  return history;
}

SlipHistory EquilibriumSolver::slip_until(const Equilibrium& at, const History& history) const {
  const PathPoint from{history.contact, history.friction};
  return slip_advance_->advanced(from, at.time, slip_advance_->reference(from, at.time), at.contact, at.gaps);
}

std::vector<PathPoint> EquilibriumSolver::accept(const Equilibrium& at, History& history, const PathOptions& options) {
  std::vector<PathPoint> path = follow_friction(at, history, options);
  const contact::ContactState& contact = path.empty() ? at.contact : path.back().contact;
  std::vector<int> changed;
  std::ranges::set_symmetric_difference(history.contact.active, contact.active, std::back_inserter(changed));
  auto row = changed.begin();
  Index end = 0;
  for (std::size_t p = 0; p < assembly_.pairs().size() && !history.contact.active.empty(); ++p) {
    end += assembly_.pairs()[p].coupling.n_rows();
    const auto next = std::lower_bound(row, changed.end(), end);
    if (next != row) ++history.set_changes[p];
    row = next;
  }
  history.friction = path.empty() ? at.friction : path.back().friction;
  history.contact = contact;
  if (!iterates()) return path;
  std::vector<History::Accepted>& accepted = history.accepted;
  if (!accepted.empty() && accepted.front().time == at.time) accepted.erase(accepted.begin());
  accepted.insert(accepted.begin(), {at.time, at.displacements, at.factors});
  if (accepted.size() > 2) accepted.pop_back();
  return path;
}

RunCounters EquilibriumSolver::counters() const {
  RunCounters all = counters_;
  all.elastic_solves += interface_.n_products();
  return all;
}

void EquilibriumSolver::save(const History& history, Memory& memory) const {
  const contact::ContactState& contact = history.contact;
  memory["contact.multiplier"].assign(contact.multiplier.begin(), contact.multiplier.end());
  memory["contact.rigid"].assign(contact.rigid.begin(), contact.rigid.end());
  memory["contact.active"].assign(contact.active.begin(), contact.active.end());
  memory["contact.interference"] = history.interference;
  memory["contact.preloaded_until"] = {history.preloaded_until};
  memory["contact.reached"].assign(history.reached.begin(), history.reached.end());
  memory["contact.sweeps_given_up"] = {contact_solver_ && contact_solver_->has_given_up_sweeps() ? 1.0 : 0.0};
  if (history.friction.slip.size() > 0) save_friction(history, memory);
  for (std::size_t b = 0; b < work_.size() && stiffness_changes_; ++b)
    memory["stiffness.factor_times"].push_back(interface_.factored(b).time());
  if (!iterates()) return;
  std::size_t k = 0;
  for (const History::Accepted& step : history.accepted) {
    if (step.factors != factors_) continue;
    memory[kept_name("time", k)] = {step.time};
    for (std::size_t b = 0; b < work_.size(); ++b) memory[kept_name("free", k, b)] = step.displacements[b];
    ++k;
  }
}

void EquilibriumSolver::restore(const Memory& memory, History& history) {
  history.contact.multiplier = vector_of(memory.at("contact.multiplier"));
  history.contact.rigid = vector_of(memory.at("contact.rigid"));
  const std::vector<double>& active = memory.at("contact.active");
  history.contact.active.assign(active.begin(), active.end());
  history.interference = memory.at("contact.interference");
  history.preloaded_until = memory.at("contact.preloaded_until").at(0);
  history.reached = vector_of(memory.at("contact.reached"));
  if (memory.at("contact.sweeps_given_up").at(0) != 0 && contact_solver_) contact_solver_->give_up_sweeps();
  if (interface_.problem().has_friction()) restore_friction(memory, history);
  history.accepted.clear();
  if (stiffness_changes_) {
    const std::vector<double>& factor_times = memory.at("stiffness.factor_times");
    std::vector<mechanics::BodyConditions> at;
    for (std::size_t b = 0; b < work_.size(); ++b) at.push_back(assembly_.bodies()[b].at(factor_times.at(b)));
    refactorize(at);
  }
  if (!iterates()) return;
  for (std::size_t k = 0; memory.contains(kept_name("time", k)); ++k) {
    history.accepted.push_back({memory.at(kept_name("time", k)).at(0), {}, factors_});
    for (std::size_t b = 0; b < work_.size(); ++b)
      history.accepted.back().displacements.push_back(memory.at(kept_name("free", k, b)));
  }
}

}  // namespace creepcontact::creep
