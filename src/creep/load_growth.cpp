/// Loads of an EquilibriumSolver that act at once, and grow in steps because what yields or slips depends on the way:
/// the first ones, and those that jump.

#include <algorithm>
#include <array>

#include "creepcontact/base/index.hpp"
#include "creepcontact/creep/elastic_survey.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "plastic_flow.hpp"
#include "slip_advance.hpp"
#include "stiffness_change.hpp"

namespace creepcontact::creep {
namespace {

using mechanics::BodyConditions;

constexpr std::array growing{&BodyConditions::external, &BodyConditions::prescribed, &BodyConditions::known,
                             &BodyConditions::thermal_strain, &BodyConditions::thermal_tensors};

/// Calls apply(part) with growing parts of the loads, the last one 1. What apply() cannot carry is tried in half the
/// step, six times at most. @param longest  part that is added at a time
template <typename Apply>
void load_in_parts(double longest, const Apply& apply) {
  const double shortest = longest / 64;
  double reached = 0, step = longest;
  const auto halve = [&] {
    step /= 2;
    return step >= shortest;
  };
  while (reached < 1) {
    // Equal steps end where they should in spite of round-off.
    const double part = reached + step > 1 - 1e-9 ? 1 : reached + step;
    try {
      apply(part);
    } catch (const SolverError&) {
      if (!halve()) throw;
      continue;
    } catch (const contact::SlidingOff&) {
      if (!halve()) throw;
      continue;
    }
    reached = part;
    step = std::min(2 * step, longest);
  }
}

/// Sets the time of what the first loads have left to 0: nothing is known of rates.
void begin_path(History& history) {
  if (history.friction.slip.size() > 0) {
    history.friction.time = 0;
    history.friction.rate.setZero();
    history.friction.is_fresh = true;
  }
  history.gaskets.time = 0;
  history.gaskets.begin_segment();
  history.plastic.time = 0;
  history.plastic.before.clear();
  for (PlasticState& body : history.plastic.bodies) body.rate.clear();
}

/// These conditions, but with loads, prescribed displacements and thermal strains between those of `from` and their
/// own. What `from` has none of grows from zero.
std::vector<BodyConditions> between(const std::vector<BodyConditions>& from, const std::vector<BodyConditions>& to,
                                    double part) {
  std::vector<BodyConditions> result = to;
  for (std::size_t b = 0; b < to.size(); ++b)
    for (const auto values : growing) {
      const std::vector<double>& before = from[b].*values;
      std::vector<double>& own = result[b].*values;
      own.resize(std::max(own.size(), before.size()));
      for (double& value : own) value *= part;
      for (std::size_t i = 0; i < before.size(); ++i) own[i] += (1 - part) * before[i];
    }
  return result;
}

/// What is there before the loads: the initial stress alone.
std::vector<BodyConditions> without_loads(const Assembly& assembly, std::vector<BodyConditions> at) {
  for (std::size_t b = 0; b < at.size(); ++b) {
    for (const auto values : growing) (at[b].*values).clear();
    const std::span<const double> initial = assembly.bodies()[b].initial_strain();
    at[b].thermal_tensors.assign(initial.begin(), initial.end());
  }
  return at;
}

}  // namespace

Eigen::VectorXd EquilibriumSolver::initial_gaps(double t) const {
  Eigen::VectorXd gaps(interface_.n_rows());
  for (const contact::Pair& pair : assembly_.pairs())
    gaps.segment(pair.first_row, pair.coupling.n_rows()) = pair.initial_gap(t);
  return gaps;
}

History EquilibriumSolver::initial_history(int substeps) {
  History history = initial_elastic_history(substeps);
  history.plastic = virgin_plastic_history(assembly_);
  if (history.plastic.bodies.empty()) return history;
  Equilibrium at;
  assembly_.update(0, at.conditions);
  resize(at);
  const std::vector<mechanics::CreepStrainView> no_creep(work_.size());
  PlasticFlow flow(assembly_, history.plastic, 0, at.conditions, options_.plastic_tolerance);
  equilibrate(flow.strains(no_creep), history, history.contact, {}, at);
  if (flow.advance(at)) {
    settle(at, no_creep, history);
    return history;
  }
  history = new_history();
  history.plastic = virgin_plastic_history(assembly_);
  at.time = 1;
  grow(without_loads(assembly_, at.conditions), 0, interface_.rows().unloaded_gap(), at, preloads_due(0, history),
       substeps, no_creep, history);
  begin_path(history);
  history.preloaded_until = 0;
  return history;
}

History EquilibriumSolver::initial_elastic_history(int substeps) {
  History history = new_history();
  const bool has_friction = interface_.problem().has_friction();
  const std::vector<std::size_t> preloads = preloads_due(0, history);
  if (!has_friction && preloads.empty() && !interface_.problem().has_gaskets()) return history;
  Equilibrium at;
  assembly_.update(0, at.conditions);
  if (stiffness_change(assembly_, interface_, at.conditions).rest > 0) refactorize(at.conditions);
  const std::vector<mechanics::CreepStrainView> no_creep(work_.size());
  // All of it is linear in the loads: one pass serves all substeps.
  contact::InterfaceLoad full = start(no_creep, history, {}, StiffnessChange(), at);
  forward();
  add_traces(full.gap);
  const Eigen::VectorXd unloaded = interface_.rows().unloaded_gap();
  load_in_parts(has_friction ? 1.0 / substeps : 1.0, [&](double part) {
    contact::InterfaceLoad load = full;
    load.gap = part * full.gap + (1 - part) * unloaded;
    at.time = part;  // for the rates of slip
    if (has_friction) load.gap -= slip_advance_->reference({history.contact, history.friction}, part);
    load.work *= part;
    load.force *= part;
    load.friction.direction = history.friction.direction;
    load.curves = gasket_curves(0, history, 1);
    const auto solve = [&](const History& trial) -> const Equilibrium& {
      contact::InterfaceLoad with_interference = load;
      with_interference.gap += interference_gaps(trial.interference);
      solve_contact(with_interference, trial.contact, at);
      return at;
    };
    take_part(part, preloads, solve, at, history);
  });
  begin_path(history);
  history.preloaded_until = 0;
  return history;
}

void EquilibriumSolver::take_part(double part, const std::vector<std::size_t>& preloads,
                                  const std::function<const Equilibrium&(const History&)>& solve, const Equilibrium& at,
                                  History& history) {
  if (preloads.empty())
    solve(history);
  else
    find_interference(preloads, part, history, solve);
  if (history.friction.slip.size() > 0) history.friction = slip_until(at, history);
  history.gaskets.advance(at.time, at.contact.closure);
  history.contact = at.contact;
}

void EquilibriumSolver::grow(const std::vector<BodyConditions>& from, double begin, const Eigen::VectorXd& gaps,
                             Equilibrium& at, const std::vector<std::size_t>& preloads, int substeps,
                             CreepStrains creep, History& history) {
  const std::vector<BodyConditions> full = at.conditions;
  const double end = at.time;
  load_in_parts(1.0 / substeps, [&](double part) {
    at.time = part == 1 ? end : begin + part * (end - begin);  // for rates
    at.conditions = between(from, full, part);
    const auto solve = [&](const History& trial) -> const Equilibrium& {
      equilibrate_yielding(creep, trial, {part, gaps}, at);
      return at;
    };
    take_part(part, preloads, solve, at, history);
    keep_flow(at, creep, return_error(at, history), history);
  });
}

void EquilibriumSolver::pass_jump(double t, double at, CreepStrains creep, History& history) {
  hold_what_is_reached(t, creep, history);
  const std::vector<std::size_t> preloads = preloads_due(t, history);
  const double before = history.plastic.time;
  Equilibrium after;
  after.time = at;
  assembly_.update(at, after.conditions);
  resize(after);
  grow(assembly_.at(before), before, initial_gaps(before), after, preloads, options_.initial_substeps, creep, history);
  history.plastic.before.clear();
  history.preloaded_until = std::max(history.preloaded_until, t);
}

}  // namespace creepcontact::creep
