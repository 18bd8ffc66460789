#include "creepcontact/creep/equilibrium_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "contact_broadcast.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/base/log.hpp"
#include "friction_follower.hpp"
#include "plastic_flow.hpp"
#include "slip_advance.hpp"
#include "stiffness_change.hpp"

namespace creepcontact::creep {
namespace {

constexpr double jacobian_tolerance = 1e-6;  // of products where they are iterated: a Krylov method asks for no more

/// The state of a solver that evaluations depend on.
struct SolverState {
  std::vector<double> factor_times;  // per body: the time whose stiffness is factored
  std::int64_t factors = 0;          // EquilibriumSolver::factors_
  bool sweeps_given_up = false;
  std::vector<std::vector<double>> factor_temperatures;  // EquilibriumSolver::factor_temperatures_
  static constexpr auto members =
      std::tuple{Member{"factor_times", &SolverState::factor_times}, Member{"factors", &SolverState::factors},
                 Member{"sweeps_given_up", &SolverState::sweeps_given_up},
                 Member{"factor_temperatures", &SolverState::factor_temperatures}};
};

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
      slip_advance_(std::make_unique<const SlipAdvance>(interface_.problem(), assembly.pairs())),
      friction_(make_friction_follower()),
      stiffness_changes_(creep::stiffness_changes(assembly)) {
  for (std::size_t b = 0; b < assembly.bodies().size(); ++b)
    if (!interface_.factored(b).solver().found_factor()) ++counters_.factorizations;
  for (const mechanics::Body& body : assembly.bodies()) {
    const std::size_t n_free = body.constraints().n_free();
    const std::size_t n_full = body.constraints().n_full();
    work_.push_back({std::vector<double>(n_free), std::vector<double>(n_free), std::vector<double>(n_free),
                     std::vector<double>(n_full), std::vector<double>(n_full)});
  }
  solver_error_ = interface_.error_bound();
}

EquilibriumSolver::~EquilibriumSolver() = default;

std::unique_ptr<contact::ContactSolver> EquilibriumSolver::make_contact_solver() const {
  if (!interface_.flexibility().is_here()) return nullptr;
  return contact::gasket_solver(
      interface_.problem(), [this](const contact::ContactProblem& problem) { return make_contact_solver(problem); });
}

std::unique_ptr<contact::ContactSolver> EquilibriumSolver::make_contact_solver(
    const contact::ContactProblem& problem) const {
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

std::unique_ptr<FrictionFollower> EquilibriumSolver::make_friction_follower() {
  const auto traces = [this](std::span<const std::vector<double>> forces, Eigen::VectorXd& gap) {
    for (std::size_t b = 0; b < work_.size(); ++b) work_[b].right_hand_side = forces[b];
    forward();
    add_traces(gap);
  };
  const auto solve = [this](const contact::ContactLoad& load, const contact::ContactState& from, double t) {
    if (recorder_ != nullptr) recorder_->begin_solve(t);
    return contact_solver_->solve(load, from);
  };
  return std::make_unique<FrictionFollower>(assembly_, interface_, *slip_advance_, traces, solve, watch_);
}

double EquilibriumSolver::longest_for_friction(double t, double end) const {
  return friction_->longest_step(t, end);
}

void EquilibriumSolver::add_traces(Eigen::VectorXd& gap) {
  const auto lap = watch_.lap(Part::contact);
  for (std::size_t b = 0; b < work_.size(); ++b) interface_.flexibility().add_trace(b, work_[b].factored, gap);
}

void EquilibriumSolver::forward(std::span<const ChangeTask> with) {
  const auto lap = watch_.lap(Part::solve);
  if (!with.empty()) {
    std::vector<linalg::SeveralSubstitutions> passes = passes_of(with);
    for (std::size_t b = 0; b < work_.size(); ++b)
      passes[b].vectors.push_back({work_[b].right_hand_side, work_[b].factored});
    return linalg::pass_several(linalg::PassDirection::forward, passes);
  }
  std::vector<linalg::Substitution> substitutions;
  for (std::size_t b = 0; b < work_.size(); ++b)
    substitutions.push_back({&interface_.factored(b).solver(), work_[b].right_hand_side, work_[b].factored});
  linalg::forward(substitutions);
}

void EquilibriumSolver::backward(const Eigen::VectorXd& multiplier, std::span<const ChangeTask> with) {
  {
    const auto lap = watch_.lap(Part::contact);
    for (std::size_t b = 0; b < work_.size(); ++b)
      interface_.flexibility().add_multipliers(b, multiplier, work_[b].factored);
  }
  const auto lap = watch_.lap(Part::solve);
  if (!with.empty()) {
    std::vector<linalg::SeveralSubstitutions> passes = passes_of(with);
    for (std::size_t b = 0; b < work_.size(); ++b) passes[b].vectors.push_back({work_[b].factored, work_[b].free});
    return linalg::pass_several(linalg::PassDirection::backward, passes);
  }
  std::vector<linalg::Substitution> substitutions;
  for (std::size_t b = 0; b < work_.size(); ++b)
    substitutions.push_back({&interface_.factored(b).solver(), work_[b].factored, work_[b].free});
  linalg::backward(substitutions);
}

contact::ContactState EquilibriumSolver::contact_change(const contact::ContactState& at, const Eigen::VectorXd& gap) {
  contact::ContactState change;
  together(assembly_.team(), [&] {
    if (interface_.flexibility().is_here()) change = active_set_.solve_change(at, gap);
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
  if (interface_.problem().has_gaskets()) history.gaskets.largest.setZero(std::ssize(interface_.problem().nodes));
  return history;
}

RunCounters EquilibriumSolver::counters() const {
  RunCounters all = counters_ + friction_->counters();
  all.elastic_solves += interface_.flexibility().n_products();
  return all;
}

void EquilibriumSolver::save(const History& history, Memory& memory) const {
  SolverState state;
  state.factors = factors_;
  state.factor_temperatures = factor_temperatures_;
  state.sweeps_given_up = contact_solver_ && contact_solver_->has_given_up_sweeps();
  for (std::size_t b = 0; b < work_.size(); ++b) state.factor_times.push_back(interface_.factored(b).time());
  memory.save("solver", state);
  memory.save("history", history);
}

void EquilibriumSolver::restore(const Memory& memory, History& history) {
  SolverState state;
  memory.restore("solver", state);
  memory.restore("history", history);
  if (state.sweeps_given_up && contact_solver_) contact_solver_->give_up_sweeps();
  if (stiffness_changes_) {
    std::vector<mechanics::BodyConditions> at;
    for (std::size_t b = 0; b < work_.size(); ++b)
      assembly_.bodies()[b].update(
          state.factor_times.at(b), at.emplace_back(),
          state.factor_temperatures.empty() ? std::span<const double>() : state.factor_temperatures.at(b));
    refactorize(at);
  }
  std::erase_if(history.accepted, [&](const History::Accepted& step) { return step.factors != state.factors; });
  for (History::Accepted& step : history.accepted) step.factors = factors_;
}

}  // namespace creepcontact::creep
