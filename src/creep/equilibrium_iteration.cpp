/// The equilibrium of all bodies in contact with a stiffness that may be another than that of the factors.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact_broadcast.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "plastic_flow.hpp"
#include "slip_advance.hpp"
#include "stiffness_change.hpp"
#include "stress_norm.hpp"
#include "vector_views.hpp"

namespace creepcontact::creep {
namespace {

constexpr double exact = 1e-12;      // of the stiffness: rounding
constexpr double rounding = 1e-12;   // of the displacement, energy norm
constexpr double stalled = 0.9;      // an iteration that changes more than this part of the last change has stalled
constexpr double farthest = 2;       // extrapolation, in steps
constexpr int plain_iterations = 2;  // before round-off is thought of
constexpr double good_if_stalled = 1e-8;  // of the displacement: rounding in an ill-conditioned stiffness

/// What the last two accepted steps lead to. @param steps  with the factors in use, the last one first; not empty
FreeDisplacements extrapolated(double t, const std::vector<const History::Accepted*>& steps) {
  FreeDisplacements result = steps[0]->displacements;
  if (steps.size() < 2) return result;
  const double last = steps[0]->time, before = steps[1]->time;
  // Steps that grow fast follow those after a jump, which tell little of what comes.
  const double part = std::clamp((t - last) / (last - before), -1.0, farthest);
  for (std::size_t b = 0; b < result.size(); ++b) {
    const auto old = vector(steps[1]->displacements[b]);
    vector(result[b]) += part * (vector(result[b]) - old);
  }
  return result;
}

/// Energy norm of the displacements of an equilibrium.
double displacement_norm(const Assembly& assembly, const Equilibrium& of) {
  double sum = 0;
  std::vector<double> stress;
  for (std::size_t b = 0; b < of.bodies.size(); ++b) {
    const mechanics::Discretization& discretization = assembly.bodies()[b].discretization();
    const mechanics::ElasticState moduli = of.conditions[b].stiffness();
    stress.resize(of.bodies[b].stress.size());
    discretization.stress(of.bodies[b].displacement, moduli, {}, stress);
    sum += elastic_energy(discretization, moduli, stress);
  }
  return std::sqrt(assembly.team().sum(sum));
}
}  // namespace

void EquilibriumSolver::refactorize(const std::vector<mechanics::BodyConditions>& at) {
  const auto lap = watch_.lap(Part::factorize);
  std::vector<std::size_t> changed;
  for (std::size_t b = 0; b < work_.size(); ++b)
    if (assembly_.team().any(interface_.factored(b).stiffness_ratio(at[b]) != std::pair(1.0, 1.0)))
      changed.push_back(b);
  interface_.flexibility().refactorize(changed, at);
  if (assembly_.heat() != nullptr) {
    factor_temperatures_.resize(work_.size());
    for (const std::size_t b : changed) factor_temperatures_[b] = at[b].temperature;
  }
  if (contact_solver_) contact_solver_->flexibility_changed();
  active_set_.flexibility_changed();
  counters_.factorizations +=
      std::ranges::count_if(changed, [&](std::size_t b) { return !interface_.factored(b).solver().found_factor(); });
  ++factors_;
}

void EquilibriumSolver::solve(double t, CreepStrains creep, const History& history, Equilibrium& into,
                              const CarriedChanges* carried) {
  into.time = t;
  assembly_.update(t, into.conditions, creep.temperatures());
  resize(into);
  equilibrate_yielding(creep, history, {}, into, carried);
  if (history.friction.slip.size() > 0) into.friction = slip_until(into, history);
  into.largest_closure = history.gaskets.largest;
  if (into.largest_closure.size() > 0) into.largest_closure = into.largest_closure.cwiseMax(into.contact.closure);
}

double EquilibriumSolver::yielding_excursion(double t, CreepStrains creep, const History& history) {
  if (history.plastic.bodies.empty()) return 0;
  Equilibrium at;
  at.time = t;
  assembly_.update(t, at.conditions);
  resize(at);
  PlasticFlow flow(assembly_, history.plastic, t, at.conditions, options_.plastic_tolerance, false);
  equilibrate({flow.strains(creep.bodies()), creep.closures()}, history, history.contact, {}, at);
  return flow.excursion(at);
}

void EquilibriumSolver::resize(Equilibrium& into) const {
  into.bodies.resize(work_.size());
  for (std::size_t b = 0; b < work_.size(); ++b) {
    const mechanics::Body& body = assembly_.bodies()[b];
    into.bodies[b].displacement.resize(3 * body.mesh().nodes.size());
    into.bodies[b].stress.resize(6 * body.discretization().n_points());
  }
}

void EquilibriumSolver::equilibrate_yielding(CreepStrains creep, const History& history, const Growth& growth,
                                             Equilibrium& into, const CarriedChanges* carried) {
  if (history.plastic.bodies.empty()) return equilibrate(creep, history, history.contact, growth, into, carried);
  PlasticFlow flow(assembly_, history.plastic, into.time, into.conditions, options_.plastic_tolerance, true,
                   growth.part);
  contact::ContactState from = history.contact;
  for (bool done = false; !done; from = into.contact) {
    equilibrate({flow.strains(creep.bodies()), creep.closures()}, history, from, growth, into);
    const auto lap = watch_.lap(Part::material);
    done = flow.advance(into);
  }
}

void EquilibriumSolver::equilibrate(CreepStrains creep, const History& history, const contact::ContactState& from,
                                    const Growth& growth, Equilibrium& into, const CarriedChanges* carried) {
  StiffnessChange change = stiffness_change(assembly_, interface_, into.conditions);
  if (change.rest > options_.refactor_change) {
    refactorize(into.conditions);
    change = {};
  }
  if (!iterate(creep, history, from, growth, change.solved_with(solver_error_), into, carried)) {
    refactorize(into.conditions);
    iterate(creep, history, from, growth, StiffnessChange().solved_with(solver_error_), into, carried);
  }
}

bool EquilibriumSolver::iterate(CreepStrains creep, const History& history, const contact::ContactState& begin,
                                const Growth& growth, const StiffnessChange& stiffness, Equilibrium& into,
                                const CarriedChanges* carried) {
  into.stiffness_scale = stiffness.scale;
  into.factors = factors_;
  const contact::InterfaceLoad given = start(creep, history, growth, stiffness, into);
  contact::ContactState from = begin;
  from.multiplier /= stiffness.scale;
  if (stiffness_changes_) from.image.resize(0);  // of other factors, perhaps
  const double contraction = stiffness.rest / (1 - stiffness.rest);
  double before = std::numeric_limits<double>::infinity();
  std::optional<double> size;  // rarely needed
  for (int iteration = 0;; ++iteration) {
    const double change = advance(given, from, creep, into, carried);
    if (stiffness.rest <= exact) break;
    if (contraction * change <= options_.stress_tolerance * stress_norm(assembly_, into)) break;
    const bool is_stalled = change > stalled * before;
    if (is_stalled || iteration >= plain_iterations) {
      if (!size) size = displacement_norm(assembly_, into);
      if (contraction * change <= rounding * *size) break;
      if (is_stalled && change > good_if_stalled * *size) return false;
      if (is_stalled) break;
    }
    before = change;
    from = into.contact;
    compute_residual(into);
  }
  into.contact.multiplier *= stiffness.scale;
  return true;
}

std::vector<contact::ClosureCurve> EquilibriumSolver::gasket_curves(double t, const History& history,
                                                                    double stiffness_scale) const {
  std::vector<contact::ClosureCurve> curves = interface_.rows().gasket_curves(t, history.gaskets.largest);
  if (stiffness_scale != 1)
    for (contact::ClosureCurve& curve : curves) curve.scale(1 / stiffness_scale);
  return curves;
}

contact::InterfaceLoad EquilibriumSolver::start(CreepStrains creep, const History& history, const Growth& growth,
                                                const StiffnessChange& stiffness, Equilibrium& into) {
  const auto lap = watch_.lap(Part::material);
  contact::InterfaceLoad given = interface_.rows().initial_load(into.conditions.front().time, into.conditions);
  for (std::size_t b = 0; b < work_.size(); ++b) {
    const mechanics::Body& body = assembly_.bodies()[b];
    body.right_hand_side(into.conditions[b], creep[b], work_[b].right_hand_side);
    body.clear_fixing_dofs(work_[b].right_hand_side);
    interface_.rows().add_resultant(b, into.conditions[b], given);
  }
  for (Eigen::VectorXd* of_motions : {&given.work, &given.force})
    assembly_.team().sum({of_motions->data(), static_cast<std::size_t>(of_motions->size())});
  if (growth.gaps.size() > 0) given.gap += (1 - growth.part) * (growth.gaps - initial_gaps(given.time));
  if (history.friction.slip.size() > 0) {
    given.gap -= slip_advance_->reference({history.contact, history.friction}, into.time);
    given.friction.direction = history.friction.direction;
  }
  if (!creep.closures().empty()) given.gap += interface_.rows().creep_gaps(creep.closures());
  into.creep_closure.assign(creep.closures().begin(), creep.closures().end());
  given.curves = gasket_curves(given.time, history, stiffness.scale);
  given.gap += interference_gaps(history.interference);
  if (history.reached.size() > 0) given.gap += history.reached;
  into.interference = history.interference;
  given.work /= stiffness.scale;
  given.force /= stiffness.scale;
  into.displacements.clear();
  if (!iterates()) return given;
  std::vector<const History::Accepted*> steps;
  for (const History::Accepted& step : history.accepted)
    if (step.factors == factors_) steps.push_back(&step);
  // If s K0 is all of the stiffness, the first solve is exact from anywhere.
  if (stiffness.rest <= exact || steps.empty()) {
    into.displacements.resize(work_.size());
    return given;
  }
  into.displacements = extrapolated(into.time, steps);
  for (std::size_t b = 0; b < work_.size(); ++b)
    update_state(b, into.displacements[b], history.contact.rigid, creep[b], into);
  compute_residual(into);
  return given;
}

void EquilibriumSolver::update_state(std::size_t b, std::span<const double> free, const Eigen::VectorXd& rigid,
                                     const mechanics::CreepStrainView& creep, Equilibrium& into) const {
  const mechanics::Body& body = assembly_.bodies()[b];
  const mechanics::BodyConditions& at = into.conditions[b];
  BodyState& state = into.bodies[b];
  body.constraints().expand(free, at.prescribed, state.displacement);
  interface_.rows().add_rigid_motion(b, rigid, state.displacement);
  body.discretization().stress(state.displacement, at.elastic(), creep, state.stress);
}

void EquilibriumSolver::compute_residual(const Equilibrium& of) {
  const auto lap = watch_.lap(Part::material);
  for (std::size_t b = 0; b < work_.size(); ++b) {
    interface_.factored(b).residual(of.conditions[b].external_forces(), of.bodies[b].stress, of.displacements[b],
                                    work_[b].right_hand_side);
    assembly_.bodies()[b].clear_fixing_dofs(work_[b].right_hand_side);
  }
}

void EquilibriumSolver::solve_contact(const contact::InterfaceLoad& load, const contact::ContactState& from,
                                      Equilibrium& into) {
  const auto lap = watch_.lap(Part::contact);
  contact::ContactResult result;
  std::optional<contact::SlidingOff> sliding;  // which no team can agree on: it is of `contact`
  together(assembly_.team(), [&] {
    stop_.heed();
    if (!interface_.flexibility().is_here()) return;
    if (recorder_ != nullptr) recorder_->begin_solve(load.time);
    try {
      result = contact_solver_->solve(interface_.balance().contact_load(load), from);
    } catch (const contact::UnbalancedLoad& unbalanced) {
      try {
        interface_.balance().report(unbalanced, load.time);
      } catch (const contact::SlidingOff& error) {
        sliding = error;
      }
    }
  });
  if (assembly_.team().any(sliding.has_value()))
    throw sliding.value_or(contact::SlidingOff("the loads move the assembly"));
  broadcast(assembly_.team(), result);
  counters_.schwarz_iterations += result.iterations;
  ++counters_.contact_solves;
  into.contact = std::move(result.state);
  into.gaps = std::move(result.gap);
}

double EquilibriumSolver::advance(const contact::InterfaceLoad& given, const contact::ContactState& from,
                                  CreepStrains creep, Equilibrium& into, const CarriedChanges* carried) {
  if (into.stiffness_scale != 1)
    for (Work& work : work_) vector(work.right_hand_side) /= into.stiffness_scale;
  std::vector<ChangeTask> with;
  if (carried != nullptr) with = (*carried)(into);
  clear_fixing_dofs(with);
  forward(with);
  contact::InterfaceLoad load = given;
  for (std::size_t b = 0; b < into.displacements.size(); ++b)
    interface_.rows().add_gaps(b, into.displacements[b], load.gap);
  add_traces(load.gap);
  if (interface_.n_rows() > 0) solve_contact(load, from, into);
  close_changes(into.contact.active, with);
  backward(into.contact.multiplier, with);
  finish_changes(with);
  const auto lap = watch_.lap(Part::material);
  const double change = iterates() ? change_norm(into.contact.multiplier) : 0;
  for (std::size_t b = 0; b < work_.size(); ++b) {
    if (iterates()) {
      std::vector<double>& free = into.displacements[b];
      free.resize(work_[b].free.size());  // zeros at the start from no displacement
      vector(free) += vector(work_[b].free);
      update_state(b, free, into.contact.rigid, creep[b], into);
    } else {
      update_state(b, work_[b].free, into.contact.rigid, creep[b], into);
    }
  }
  ++counters_.elastic_solves;
  return change;
}

double EquilibriumSolver::change_norm(const Eigen::VectorXd& multiplier) const {
  double energy = 0;  // u . K0 u, with the forces K0 u: parts of the right-hand sides, and those of contact
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(interface_.n_rows());
  for (std::size_t b = 0; b < work_.size(); ++b) {
    energy += vector(work_[b].right_hand_side).dot(vector(work_[b].free));
    interface_.rows().add_gaps(b, work_[b].free, gap);
  }
  energy = assembly_.team().sum(energy);
  if (multiplier.size() == gap.size()) energy += multiplier.dot(gap);
  return std::sqrt(std::max(0.0, energy));
}

}  // namespace creepcontact::creep
