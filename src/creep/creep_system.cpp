#include "creepcontact/creep/creep_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/numerics/long_vectors.hpp"
#include "flow_vector.hpp"
#include "gasket_creep.hpp"
#include "heat_coupling.hpp"
#include "vector_views.hpp"

namespace creepcontact::creep {
namespace {

/// Part of the strain of the tolerance at which hardening begins to count.
constexpr double min_share = 0.3;
constexpr double near_accepted = 0.1;  // of the tolerance: an evaluation so near represents an accepted point
constexpr double same_value = 1e-9;    // of equal values at points that symmetry makes equal
constexpr double min_sliding_step =
    1e-6;  // relative to the time: a body that slides off in so short a step does slide off

std::vector<double> min_strains(const Assembly& assembly, const ErrorScale& scale, double tolerance) {
  const StateLayout layout(assembly);
  std::vector<double> result;
  for (std::size_t b = 0; b < assembly.bodies().size(); ++b)
    result.push_back(layout.stride(b) > 0 ? min_share * tolerance * scale.strain()[b]
                                          : material::PointState{}.min_strain);
  return result;
}

std::vector<double> min_gasket_strains(const ErrorScale& scale, double tolerance) {
  std::vector<double> result;
  for (const double strain : scale.gasket_strain())
    result.push_back(strain > 0 ? min_share * tolerance * strain : material::PointState{}.min_strain);
  return result;
}

/// Laws take a stress that is not a number for none, and a run would go on without creep.
void require_finite_stress(const Assembly& assembly, const Equilibrium& at) {
  for (std::size_t b = 0; b < at.bodies.size(); ++b) {
    if (!numerics::is_finite(at.bodies[b].stress))
      throw RecoverableError(
          fmt::format("the stress of body '{}' is no longer finite at t = {:.6g}; use shorter steps, or an integrator "
                      "with error control",
                      assembly.bodies()[b].name(), at.time));
  }
}

/// Whether the end of the path has other tractions, or other stresses of bodies that may yield, than the step had.
bool jumps(const Team& team, const Equilibrium& from, const History& to, double tolerance) {
  const auto differ = [tolerance](const auto& a, const auto& b) {
    return a.size() > 0 && (a - b).cwiseAbs().maxCoeff() > tolerance * b.cwiseAbs().maxCoeff();
  };
  if (differ(from.contact.multiplier, to.contact.multiplier)) return true;
  bool any = false;
  for (std::size_t b = 0; b < to.plastic.bodies.size(); ++b)
    if (const std::vector<double>& stress = to.plastic.bodies[b].stress; !stress.empty())
      any = any || differ(vector(from.bodies[b].stress), vector(stress));
  return team.any(any);
}

}  // namespace

CreepSystem::CreepSystem(EquilibriumSolver& solver, const ElasticSurvey& survey, double tolerance, Stopwatch& watch)
    : solver_(solver),
      watch_(watch),
      scale_(solver.assembly(), survey.stress, survey.gasket_strain),
      laws_(solver.assembly(), min_strains(solver.assembly(), scale_, tolerance)),
      may_start_singular_(survey.singular_start),
      tolerance_(tolerance),
      yield_steps_(solver.assembly()),
      history_(solver.initial_history()),
      gaskets_(std::make_unique<GasketCreep>(solver.assembly(), min_gasket_strains(scale_, tolerance))) {
  if (assembly().heat() != nullptr) heat_ = std::make_unique<HeatCoupling>(assembly());
  preconditioners_.resize(laws_.points().size());
  for (const MaterialPoints& points : laws_.points())
    local_.push_back(points.has_closed_form() ? nullptr : std::make_unique<MaterialTangent>(points));
}

CreepSystem::~CreepSystem() = default;

void CreepSystem::begin_segment(double begin, double end) {
  segment_begin_ = begin;
  segment_end_ = end;
  yield_steps_.begin_segment();
  history_.plastic.before.clear();
  history_.plastic.smooth_since = begin;
  history_.gaskets.begin_segment();
  if (heat_) heat_->rates().problem().set_segment(begin, end);
}

double CreepSystem::load_time(double t) const {
  return std::max(std::min(t, just_before(segment_end_)), just_after(segment_begin_));
}

CreepStrains CreepSystem::strains(std::span<const double> y) {
  laws_.layout().views(y, views_);
  gaskets_->closures(y, closures_);
  return {views_, closures_};
}

CreepStrains CreepSystem::strains(double t, std::span<const double> y) {
  const CreepStrains creep = strains(y);
  if (!heat_) return creep;
  temperatures_ = heat_->at_points(t, laws_.layout().temperatures(y));
  return {creep.bodies(), creep.closures(), temperatures_};
}

void CreepSystem::solve(double t, std::span<const double> y, Evaluation& into, const CarriedChanges* carried) {
  into.valid = into.has_tangents = false;
  into.time = t;
  numerics::copy(y, into.y);
  const CreepStrains creep = strains(t, into.y);
  try {
    if (path_.contains(t))
      path_.solve(solver_, t, creep, into.equilibrium);
    else
      solver_.solve(t, creep, history_, into.equilibrium, carried);
  } catch (const contact::SlidingOff& error) {
    // A trial state of the integrator may slide off where the solution does not.
    if (!has_friction() || t - history_.friction.time <= min_sliding_step * t) throw;
    throw RecoverableError(error.what());
  } catch (const SolverError& error) {
    throw RecoverableError(error.what());
  }
  into.temperatures.clear();
  if (heat_) into.temperatures = heat_->completed(t, laws_.layout().temperatures(std::span<const double>(into.y)));
  into.laws.resize(laws_.points().size());
  together(team(), [&] {
    require_finite_stress(assembly(), into.equilibrium);
    for (std::size_t b = 0; b < laws_.points().size(); ++b)
      laws_.points()[b].update(into.equilibrium.conditions[b], into.laws[b]);
  });
  into.valid = true;
}

bool CreepSystem::is_at(double t, std::span<const double> y, const Evaluation& of) const {
  return of.valid && of.time == t && !team().any(!numerics::equal(of.y, y));
}

const Evaluation& CreepSystem::evaluate_step(double t, std::span<const double> y, const CarriedChanges* carried) {
  t = load_time(t);
  if (is_at(t, y, step_)) return step_;
  if (is_at(t, y, output_))
    std::swap(step_, output_);
  else
    solve(t, y, step_, carried);
  return step_;
}

const Evaluation& CreepSystem::evaluate_output(double t, std::span<const double> y) {
  t = load_time(t);
  if (is_at(t, y, step_)) return step_;
  if (!is_at(t, y, output_)) solve(t, y, output_);
  return output_;
}

std::vector<double> CreepSystem::rate_of(const Evaluation& at) const {
  std::vector<double> rate(size(), 0.0);
  together(team(), [&] {
    laws_.for_each_creeping([&](std::size_t b, const MaterialPoints& points) {
      points.rate(laws_.state(b, at, at.y), laws_.layout().part(b, std::span(rate)), {});
    });
    gaskets_->rate(at.equilibrium, at.y, rate);
    if (heat_)
      heat_->rates().rate(at.time, laws_.layout().temperatures(std::span(at.y)),
                          joint_values(assembly(), at.equilibrium), laws_.layout().temperatures(std::span(rate)));
  });
  return rate;
}

double CreepSystem::rate_change(double from, std::span<const double> y, double t) {
  const Evaluation& accepted = evaluate_accepted(from, y);
  const std::vector<double> here = rate_of(accepted), state = accepted.y;
  std::vector<double> there;
  try {
    there = rate_of(evaluate_output(t, state));
  } catch (const RecoverableError&) {
    return std::numeric_limits<double>::infinity();
  } catch (const ModelError&) {  // loads that push a body away there, in the present state
    return std::numeric_limits<double>::infinity();
  }
  double largest = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    const double change = std::abs(there[i] - here[i]) / scale_.values()[i];
    largest = std::isnan(change) ? std::numeric_limits<double>::infinity() : std::max(largest, change);
  }
  return team().max(largest) / tolerance_;
}

const Evaluation& CreepSystem::evaluate_result(double t, std::span<const double> y) {
  evaluate_output(t, y);
  Evaluation& found = is_at(load_time(t), y, step_) ? step_ : output_;
  if (has_friction()) reported_.raise(found.equilibrium.friction);
  return found;
}

const Evaluation& CreepSystem::evaluate_accepted(double t, std::span<const double> y) {
  return step_.valid && step_.time == load_time(t) ? step_ : evaluate_step(t, y);
}

void CreepSystem::forget_evaluations() {
  step_.valid = output_.valid = false;
}

void CreepSystem::rate(double t, std::span<const double> y, std::span<double> rate) {
  const Evaluation& at = evaluate_step(t, y);
  ++rate_evaluations_;
  const auto lap = watch_.lap(Part::material);
  const bool with_tangents = std::exchange(tangents_needed_, false);
  if (with_tangents) resize_tangents();
  together(team(), [&] {
    laws_.for_each_creeping([&](std::size_t b, const MaterialPoints& points) {
      const auto tangents = with_tangents ? std::span(step_.tangents[b]) : std::span<material::StressTangent>();
      points.rate(laws_.state(b, at, y), laws_.layout().part(b, rate), tangents);
    });
    gaskets_->rate(at.equilibrium, y, rate);
    if (heat_)
      heat_->rates().rate(at.time, laws_.layout().temperatures(y), joint_values(assembly(), at.equilibrium),
                          laws_.layout().temperatures(rate));
    step_.has_tangents = step_.has_tangents || with_tangents;
    if (!numerics::is_finite(rate)) throw RecoverableError(describe_overflow(at, rate));
  });
}

double CreepSystem::smallest_start_exponent(double t, const Evaluation& at) const {
  double smallest = 1;
  laws_.for_each_creeping([&](std::size_t b, const MaterialPoints& points) {
    smallest = std::min(smallest, points.start_exponent(t, laws_.state(b, at, at.y)));
  });
  smallest = std::min(smallest, gaskets_->start_exponent(t, at.equilibrium, at.y));
  return team().min(smallest);
}

double CreepSystem::start_exponent(double t, std::span<const double> y) {
  return smallest_start_exponent(t, evaluate_step(t, y));
}

void CreepSystem::start_increment(double t, std::span<const double> y, double stress_time, double duration,
                                  std::span<double> change) {
  const Evaluation& at = evaluate_step(stress_time, y);
  const auto lap = watch_.lap(Part::material);
  laws_.for_each_creeping([&](std::size_t b, const MaterialPoints& points) {
    points.add_increment(t, duration, laws_.state(b, at, y), laws_.layout().part(b, change));
  });
  gaskets_->add_increment(t, duration, at.equilibrium, y, change);
}

std::optional<CreepSystem::Extreme> CreepSystem::largest(const material::StateVariable& scalar, std::size_t body,
                                                         const Evaluation& at, std::span<const double> y) const {
  if (!laws_.points()[body].has(scalar)) return std::nullopt;
  const std::vector<double> values = laws_.evaluate(scalar, body, at, y);
  std::array<double, 4> extreme{-std::numeric_limits<double>::infinity()};
  if (!values.empty()) {
    const double most = *std::ranges::max_element(values);
    // Where several points have it but for rounding, the first: the place does not depend on rounding.
    const auto first =
        std::ranges::find_if(values, [=](double v) { return !(v < most - same_value * std::abs(most)); });
    const Vector3& x = assembly().bodies()[body].discretization().point_coordinates()[first - values.begin()];
    extreme = {most, x.x(), x.y(), x.z()};
  }
  team().broadcast(extreme, team().rank_of_max(extreme[0]));
  return Extreme{extreme[0], body, {extreme[1], extreme[2], extreme[3]}};
}

std::vector<std::optional<RelaxationTime>> CreepSystem::initial_relaxation(const Evaluation& at, double near) const {
  std::vector<std::optional<RelaxationTime>> times(laws_.points().size());
  laws_.for_each_creeping([&](std::size_t b, const MaterialPoints& points) {
    times[b] = relaxation_time(team(), points, laws_.state(b, at, at.y), near);
  });
  return times;
}

bool CreepSystem::is_near(double t, std::span<const double> y, const Evaluation& of) const {
  if (!of.valid || of.time != t) return false;
  const std::span<const double> scale = scale_.values();
  double largest = 0;
  for (std::size_t i = 0; i < y.size(); ++i) largest = std::max(largest, std::abs(y[i] - of.y[i]) / scale[i]);
  return team().max(largest) <= near_accepted * tolerance_;
}

double CreepSystem::excursion_at_end(std::span<const double> y) {
  constexpr double unknown = 1;
  try {
    return solver_.yielding_excursion(load_time(segment_end_), strains(load_time(segment_end_), y), history_);
  } catch (const SolverError&) {  // the steps will tell
    return unknown;
  } catch (const ModelError&) {
    return unknown;
  }
}

double CreepSystem::longest_step(double t, std::span<const double> y) {
  const double for_yielding = yield_steps_.longest(t, segment_end_, [&] { return excursion_at_end(y); });
  return std::isfinite(segment_end_) ? std::min(for_yielding, longest_step_of_friction(t, segment_end_)) : for_yielding;
}

void CreepSystem::pass_breakpoint(double t, std::span<const double> y) {
  const History before = has_yielding() ? history_ : History();
  if (solver_.has_preload_due(t, history_)) {
    forget_evaluations();
    step_.y.assign(y.begin(), y.end());
    solver_.apply_preloads(t, load_time(t), strains(load_time(t), step_.y), history_);
  }
  if (has_yielding() && settle_flow(t, y, before)) return;
  if (has_friction() || has_gaskets()) accept(t, y);
}

void CreepSystem::settle_flow(double t, std::span<const double> y) {
  if (has_yielding()) settle_flow(t, y, History(history_));
}

bool CreepSystem::settle_flow(double t, std::span<const double> y, const History& before) {
  const Evaluation& at = evaluate_step(t, y);
  const CreepStrains creep = strains(load_time(t), step_.y);
  if (!at.equilibrium.plastic.flows) {
    solver_.settle(at.equilibrium, creep, history_);
    return false;
  }
  history_ = before;
  solver_.pass_jump(t, load_time(t), creep, history_);
  path_ = {};
  forget_evaluations();
  return true;
}

std::vector<double> CreepSystem::flow() const {
  return flow_vector(assembly(), history_.plastic);
}

void CreepSystem::set_flow(std::span<const double> flow) {
  set_flow_vector(assembly(), flow, history_.plastic);
  path_ = {};
  forget_evaluations();
}

std::vector<double> CreepSystem::scale_of_flow() const {
  std::vector<double> scale;
  for (std::size_t b = 0; b < assembly().bodies().size(); ++b)
    scale.resize(scale.size() + flow_size(assembly(), b), scale_.strain()[b]);
  return scale;
}

void CreepSystem::accept(double t, std::span<const double> y) {
  if (depends_on_path()) {
    if (step_.equilibrium.plastic.flows || has_friction() || has_gaskets())
      if (!is_near(load_time(t), y, step_)) evaluate_step(t, y);
  }
  const double begin = std::max(0.0, segment_begin_);
  path_ = LastPath(solver_.accept(step_.equilibrium,
                                  depends_on_path() ? strains(load_time(t), step_.y) : CreepStrains(views_), history_,
                                  {tolerance_, std::isfinite(segment_end_) ? segment_end_ - begin : 0.0}));
  rate_has_jumped_ = path_.has_substeps() && jumps(team(), step_.equilibrium, history_, tolerance_);
  const auto lap = watch_.lap(Part::material);
  scale_.follow(step_.equilibrium);
  yield_steps_.accept(step_.equilibrium);
  if (path_.has_substeps()) forget_evaluations();  // the state is that of the end of the path
}

void CreepSystem::save(Memory& memory) const {
  solver_.save(history_, memory);
  scale_.save(memory);
  yield_steps_.save(memory);
}

void CreepSystem::restore(const Memory& memory) {
  solver_.restore(memory, history_);
  path_ = {};
  scale_.restore(memory);
}

void CreepSystem::resume(double t, std::span<const double> y, const Memory& memory) {
  memory.restore("history.plastic", history_.plastic);  // begin_segment() has forgotten the step before
  yield_steps_.resume(memory, [&]() -> const Equilibrium& { return evaluate_step(t, y).equilibrium; });
}

RunCounters CreepSystem::run_counters() const {
  RunCounters result = solver_.counters();
  result.rhs_evaluations = rate_evaluations_;
  result.jacobian_products = jacobian_products_;
  if (tangent_) {
    result.elastic_solves += tangent_->solves();
    result.factorizations += tangent_->factorizations();
  }
  return result;
}

std::string CreepSystem::describe_overflow(const Evaluation& at, std::span<const double> rate) const {
  for (std::size_t b = 0; b < laws_.points().size(); ++b) {
    const std::size_t stride = laws_.layout().stride(b);
    for (std::size_t p = 0; stride > 0 && p < laws_.points()[b].size(); ++p) {
      const auto own = laws_.layout().part(b, rate).subspan(p * stride, stride);
      if (std::ranges::all_of(own, [](double value) { return std::isfinite(value); })) continue;
      const mechanics::Body& body = assembly().bodies()[b];
      const Vector3& x = body.discretization().point_coordinates()[p];
      return fmt::format(
          "the creep rate of material '{}' overflows, is negative or is undefined in body '{}' at ({:.6g}, {:.6g}, "
          "{:.6g}), where the equivalent stress is {:.6g} and t = {:.6g}; check its creep constants and their units",
          body.material().name, body.name(), x.x(), x.y(), x.z(),
          tensor::von_mises(tensor::view(at.equilibrium.bodies[b].stress, p)), at.time);
    }
  }
  return "the creep rate overflows";
}

}  // namespace creepcontact::creep
