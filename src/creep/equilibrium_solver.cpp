#include "creepcontact/creep/equilibrium_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "creepcontact/base/index.hpp"
#include "creepcontact/base/log.hpp"
#include "fixed_contact_solve.hpp"

namespace creepcontact::creep {
namespace {

/// Smaller factors stay in the cache: waking the threads costs more than the pass.
constexpr std::int64_t parallel_bytes = 1 << 20;
constexpr double jacobian_tolerance = 1e-6;  // of products where they are iterated: a Krylov method asks for no more

/// @param step  0: the last accepted one
std::string kept_name(const char* what, std::size_t step, std::size_t body = 0) {
  return fmt::format("stiffness.kept.{}.{}.{}", step, what, body);
}

/// The contact of fixed_contact_solve(), with one active set.
struct ClosedRows {
  contact::CondensedInterface& interface;
  contact::ActiveSetSystem& active_set;
  const std::vector<int>& active;

  void add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap) const {
    interface.add_trace(body, y, gap);
  }
  contact::ContactState close(const Eigen::VectorXd& gap) const {
    // Initial strains are in equilibrium with themselves: no resultants.
    return active_set.solve(active, {gap, {}}).state;
  }
  void add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y) const {
    interface.add_multipliers(body, multiplier, y);
  }
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
                                           1e6 * options.dense_limit_mb, admit, options.stiffness_solver);
      }()),
      contact_solver_(make_contact_solver()),
      active_set_(interface_.problem(), std::max(options.schwarz.tolerance, jacobian_tolerance)) {
  counters_.factorizations = std::ssize(assembly.bodies());
  std::int64_t largest = 0, all = 0;
  for (std::size_t b = 0; b < assembly.bodies().size(); ++b) {
    const std::int64_t bytes = interface_.factored(b).solver().factor_bytes();
    largest = std::max(largest, bytes);
    all += bytes;
  }
  parallel_passes_ = all - largest > parallel_bytes;
  for (const mechanics::Body& body : assembly.bodies()) {
    const std::size_t n_free = body.constraints().n_free();
    const std::size_t n_full = body.constraints().n_full();
    stiffness_changes_ = stiffness_changes_ || body.stiffness_changes();
    work_.push_back({std::vector<double>(n_free), std::vector<double>(n_free), std::vector<double>(n_free),
                     std::vector<double>(n_full), std::vector<double>(n_full)});
  }
}

EquilibriumSolver::~EquilibriumSolver() = default;

std::unique_ptr<contact::ContactSolver> EquilibriumSolver::make_contact_solver() const {
  const contact::ContactProblem& problem = interface_.problem();
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

void EquilibriumSolver::for_each_factor(const std::function<void(std::size_t)>& pass) const {
  const auto lap = watch_.lap(Part::solve);
  const int n_bodies = static_cast<int>(work_.size());
  // One thread cannot use the whole bandwidth of the memory, which is what a pass costs.
#pragma omp parallel for schedule(dynamic, 1) if (parallel_passes_)
  for (int b = 0; b < n_bodies; ++b) pass(b);
}

void EquilibriumSolver::forward() {
  for_each_factor(
      [&](std::size_t b) { interface_.factored(b).solver().forward(work_[b].right_hand_side, work_[b].factored); });
}

void EquilibriumSolver::backward(const Eigen::VectorXd& multiplier) {
  {
    const auto lap = watch_.lap(Part::contact);
    for (std::size_t b = 0; b < work_.size(); ++b) interface_.add_multipliers(b, multiplier, work_[b].factored);
  }
  for_each_factor([&](std::size_t b) { interface_.factored(b).solver().backward(work_[b].factored, work_[b].free); });
}

void EquilibriumSolver::set_recorder(contact::IterationRecorder* recorder) {
  recorder_ = recorder;
  contact_solver_->set_recorder(recorder);
}

void EquilibriumSolver::linearized(const Equilibrium& at, CreepStrains creep_change,
                                   std::vector<std::vector<double>>& stress) {
  const std::size_t n_bodies = work_.size();
  std::vector<FactoredSide> sides;
  {
    const auto lap = watch_.lap(Part::material);
    for (std::size_t b = 0; b < n_bodies; ++b) {
      mechanics::FactoredBody& factored = interface_.factored(b);
      factored.body().initial_strain_force(factored.elastic(), creep_change[b], work_[b].free);
      factored.body().clear_fixing_dofs(work_[b].free);
      sides.push_back({&factored.solver(), work_[b].free});
    }
  }
  ClosedRows rows{interface_, active_set_, at.contact.active};
  const contact::ContactState change = fixed_contact_solve(
      sides, interface_.n_rows(), [&](const auto& pass) { for_each_factor(pass); }, rows, watch_);
  const auto lap = watch_.lap(Part::material);
  stress.resize(n_bodies);
  for (std::size_t b = 0; b < n_bodies; ++b) {
    const mechanics::FactoredBody& factored = interface_.factored(b);
    const mechanics::Body& body = factored.body();
    body.constraints().expand(work_[b].free, work_[b].no_displacement, work_[b].displacement);
    interface_.add_rigid_motion(b, change.rigid, work_[b].displacement);
    stress[b].resize(6 * body.discretization().n_points());
    body.discretization().stress(work_[b].displacement, factored.elastic(), creep_change[b], stress[b]);
    if (at.stiffness_scale != 1)
      for (double& component : stress[b]) component *= at.stiffness_scale;
  }
  ++counters_.elastic_solves;
}

History EquilibriumSolver::new_history() const {
  History history;
  history.set_changes.assign(assembly_.pairs().size(), 0);
  return history;
}

void EquilibriumSolver::accept(const Equilibrium& at, History& history) const {
  std::vector<int> changed;
  std::ranges::set_symmetric_difference(history.contact.active, at.contact.active, std::back_inserter(changed));
  auto row = changed.begin();
  Index end = 0;
  for (std::size_t p = 0; p < assembly_.pairs().size() && !history.contact.active.empty(); ++p) {
    end += assembly_.pairs()[p].coupling.n_rows();
    const auto next = std::lower_bound(row, changed.end(), end);
    if (next != row) ++history.set_changes[p];
    row = next;
  }
  history.contact = at.contact;
  if (!stiffness_changes_) return;
  std::vector<History::Accepted>& accepted = history.accepted;
  if (!accepted.empty() && accepted.front().time == at.time) accepted.erase(accepted.begin());
  accepted.insert(accepted.begin(), {at.time, at.displacements, at.factors});
  if (accepted.size() > 2) accepted.pop_back();
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
  memory["contact.sweeps_given_up"] = {contact_solver_->has_given_up_sweeps() ? 1.0 : 0.0};
  if (!stiffness_changes_) return;
  for (std::size_t b = 0; b < work_.size(); ++b)
    memory["stiffness.factor_times"].push_back(interface_.factored(b).time());
  std::size_t k = 0;
  for (const History::Accepted& step : history.accepted) {
    if (step.factors != factors_) continue;
    memory[kept_name("time", k)] = {step.time};
    for (std::size_t b = 0; b < work_.size(); ++b) {
      memory[kept_name("factored", k, b)] = step.displacements[b].factored;
      memory[kept_name("free", k, b)] = step.displacements[b].free;
    }
    ++k;
  }
}

void EquilibriumSolver::restore(const Memory& memory, History& history) {
  const auto vector = [&](const char* name) {
    const std::vector<double>& values = memory.at(name);
    return Eigen::VectorXd(Eigen::VectorXd::Map(values.data(), values.size()));
  };
  history.contact.multiplier = vector("contact.multiplier");
  history.contact.rigid = vector("contact.rigid");
  const std::vector<double>& active = memory.at("contact.active");
  history.contact.active.assign(active.begin(), active.end());
  if (memory.at("contact.sweeps_given_up").at(0) != 0) contact_solver_->give_up_sweeps();
  history.accepted.clear();
  if (!stiffness_changes_) return;
  const std::vector<double>& factor_times = memory.at("stiffness.factor_times");
  std::vector<mechanics::BodyConditions> at;
  for (std::size_t b = 0; b < work_.size(); ++b) at.push_back(assembly_.bodies()[b].at(factor_times.at(b)));
  refactorize(at);
  for (std::size_t k = 0; memory.contains(kept_name("time", k)); ++k) {
    history.accepted.push_back({memory.at(kept_name("time", k)).at(0), {}, factors_});
    for (std::size_t b = 0; b < work_.size(); ++b)
      history.accepted.back().displacements.push_back(
          {memory.at(kept_name("factored", k, b)), memory.at(kept_name("free", k, b))});
  }
}

}  // namespace creepcontact::creep
