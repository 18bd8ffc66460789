#include "creepcontact/simulation/creep_rate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "creepcontact/base/error.hpp"
#include "stress_scale.hpp"

namespace creepcontact::simulation {
namespace {

/// A preconditioner need not follow every step: gamma may be off by this factor.
constexpr double same_gamma = 1.25;
/// Of the strain that the tolerance stands for: where hardening begins to count.
constexpr double least_share = 0.3;

// Jumps that differ by rounding alone count as one breakpoint: these times lie beyond all of them.
constexpr double beside = 16 * std::numeric_limits<double>::epsilon();

double just_before(double t) {
  return t * (1 - beside);
}
double just_after(double t) {
  return t * (1 + beside);
}

}  // namespace

CreepRate::CreepRate(ContactElasticity& elasticity, Stopwatch& watch, const std::vector<double>& output_times,
                     double tolerance)
    : elasticity_(elasticity),
      watch_(watch),
      layout_(elasticity.model()),
      scale_(std::make_unique<StressScale>(elasticity.model(), layout_)),
      state_(layout_.size()) {
  for (const auto& body : elasticity.model().bodies) {
    points_.emplace_back(*body);
    stress_change_.emplace_back(6 * body->discretization().n_points());
  }
  for (const MaterialPoints& points : points_)
    local_.push_back(points.has_internal_variables() ? std::make_unique<MaterialTangent>(points) : nullptr);
  if (size() == 0) return;
  set_scale(output_times);
  std::ranges::fill(state_, 0.0);
  for (std::size_t b = 0; b < points_.size(); ++b)
    if (!points_[b].empty()) points_[b].set_least_strain(least_share * tolerance * scale_->values()[layout_.offset(b)]);
  may_start_singular_ = smallest_start_exponent(0, state_) < 1;
}

CreepRate::~CreepRate() = default;

std::span<const double> CreepRate::scale() const {
  return scale_->values();
}

std::vector<double> CreepRate::elastic_stresses(const std::vector<double>& times, double end) {
  std::vector<double> stress(points_.size(), 0.0);
  layout_.views(state_, views_);  // no creep strain yet
  for (const double t : times) {
    try {
      elasticity_.solve(t, views_);
    } catch (const ModelError&) {
      if (t == times.front()) throw;
      continue;  // a load that lifts a body off later: the run goes on up to there
    }
    require_relaxation_in_the_run(t, end);
    for (std::size_t b = 0; b < stress.size(); ++b)
      stress[b] = std::max(stress[b], StressScale::typical(elasticity_.states()[b]));
  }
  return stress;
}

void CreepRate::set_scale(const std::vector<double>& output_times) {
  const double end = output_times.back();
  std::vector<double> times{0.0, end};
  for (const double t : elasticity_.model().breakpoints)
    if (t > 0 && t < end) times.insert(times.end(), {just_before(t), just_after(t)});
  std::vector<double> stress = elastic_stresses(times, end);
  // Loads that vanish at all these times may still act in between.
  if (*std::max_element(stress.begin(), stress.end()) == 0) stress = elastic_stresses(output_times, end);
  if (!(*std::max_element(stress.begin(), stress.end()) > 0))
    throw ModelError(
        "nothing loads the bodies: at no output time does any load, support, temperature or gap give stress");
  for (const auto& body : elasticity_.model().bodies) body->set_time(0.0);  // Young's modulus where the run begins
  scale_->set_elastic(stress);
}

void CreepRate::begin_segment(double begin, double end) {
  segment_begin_ = begin;
  segment_end_ = end;
}

double CreepRate::load_time(double t) const {
  return std::max(std::min(t, just_before(segment_end_)), just_after(segment_begin_));
}

bool CreepRate::evaluate(double t, std::span<const double> y) {
  t = load_time(t);
  if (evaluated_ && t == time_ && std::equal(y.begin(), y.end(), state_.begin())) return false;
  evaluated_ = false;
  std::copy(y.begin(), y.end(), state_.begin());
  layout_.views(state_, views_);
  try {
    elasticity_.solve(t, views_);
  } catch (const SolverError& error) {
    throw ode::RecoverableError(error.what());
  }
  require_finite_stress(t);
  for (MaterialPoints& points : points_) points.set_time(t);
  time_ = t;
  evaluated_ = true;
  for_output_ = false;
  return true;
}

void CreepRate::equilibrium(double t, std::span<const double> y) {
  if (evaluate(t, y)) for_output_ = true;
}

void CreepRate::rate(double t, std::span<const double> y, std::span<double> rate) {
  evaluate(t, y);
  for_output_ = false;
  ++rate_evaluations_;
  const auto lap = watch_.lap(Part::material);
  for (std::size_t b = 0; b < points_.size(); ++b)
    if (!points_[b].empty())
      points_[b].rate(elasticity_.states()[b].stress, y.data() + layout_.offset(b), rate.data() + layout_.offset(b));
  const double sum = Eigen::Map<const Eigen::VectorXd>(rate.data(), static_cast<Eigen::Index>(rate.size())).sum();
  if (!std::isfinite(sum)) throw ode::RecoverableError(describe_overflow(rate));
}

void CreepRate::jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                               std::span<double> product) {
  evaluate(t, y);
  ++jacobian_products_;
  layout_.views(v, views_);
  elasticity_.linearized(views_, stress_change_);
  const auto lap = watch_.lap(Part::material);
  for (std::size_t b = 0; b < points_.size(); ++b)
    if (!points_[b].empty())
      points_[b].derivative(elasticity_.states()[b].stress, y.data() + layout_.offset(b), stress_change_[b],
                            v.data() + layout_.offset(b), product.data() + layout_.offset(b));
}

void CreepRate::prepare_preconditioner(double t, std::span<const double> y) {
  evaluate(t, y);
  const auto lap = watch_.lap(Part::material);
  for (std::size_t b = 0; b < points_.size(); ++b)
    if (!points_[b].empty() && !local_[b])
      points_[b].linearize(elasticity_.states()[b].stress, y.data() + layout_.offset(b));
  local_gamma_ = 0;
}

void CreepRate::precondition(double gamma, std::span<const double> r, std::span<double> z) {
  const auto lap = watch_.lap(Part::material);
  const bool prepared = gamma < same_gamma * local_gamma_ && local_gamma_ < same_gamma * gamma;
  if (!prepared) local_gamma_ = gamma;
  for (std::size_t b = 0; b < points_.size(); ++b) {
    if (points_[b].empty()) continue;
    const std::size_t offset = layout_.offset(b);
    if (!local_[b]) {
      points_[b].precondition(gamma, r.data() + offset, z.data() + offset);
      continue;
    }
    // Of the last evaluation, which may be nearer than the point prepared for.
    if (!prepared) local_[b]->prepare(gamma, elasticity_.states()[b].stress, state_.data() + offset);
    local_[b]->solution(r.data() + offset, {}, z.data() + offset);
  }
}

void CreepRate::prepare_tangent(double t, std::span<const double> y, double gamma) {
  evaluate(t, y);
  if (!tangent_) tangent_.emplace(elasticity_, points_, layout_, watch_);
  tangent_->prepare(gamma, y);
}

void CreepRate::solve_tangent(std::span<const double> r, std::span<double> z) {
  tangent_->solve(r, z);
}

double CreepRate::smallest_start_exponent(double t, std::span<const double> y) const {
  double smallest = 1;
  for (std::size_t b = 0; b < points_.size(); ++b)
    if (!points_[b].empty())
      smallest = std::min(smallest,
                          points_[b].start_exponent(t, elasticity_.states()[b].stress, y.data() + layout_.offset(b)));
  return smallest;
}

double CreepRate::start_exponent(double t, std::span<const double> y) {
  evaluate(t, y);
  return smallest_start_exponent(t, y);
}

void CreepRate::start_increment(double t, std::span<const double> y, double stress_time, double duration,
                                std::span<double> change) {
  evaluate(stress_time, y);
  const auto lap = watch_.lap(Part::material);
  for (std::size_t b = 0; b < points_.size(); ++b)
    if (!points_[b].empty())
      points_[b].add_increment(t, duration, elasticity_.states()[b].stress, y.data() + layout_.offset(b),
                               change.data() + layout_.offset(b));
}

bool CreepRate::knows(material::Measure measure) const {
  return std::ranges::any_of(points_, [&](const MaterialPoints& points) { return points.knows(measure); });
}

std::vector<double> CreepRate::measure(material::Measure of, std::size_t body, std::span<const double> y) const {
  if (!points_[body].knows(of)) return {};
  return points_[body].measure(of, elasticity_.states()[body].stress, y.data() + layout_.offset(body));
}

std::optional<CreepRate::Extreme> CreepRate::largest(material::Measure of, std::size_t body,
                                                     std::span<const double> y) const {
  const std::vector<double> values = measure(of, body, y);
  if (values.empty()) return std::nullopt;
  const auto at = std::max_element(values.begin(), values.end());
  const auto point = static_cast<std::size_t>(at - values.begin());
  return Extreme{*at, body, elasticity_.model().bodies[body]->discretization().point_coordinates()[point]};
}

double CreepRate::stable_step(double t, std::span<const double> y) {
  evaluate(t, y);
  const std::vector<double> times = relaxation_times();
  return 2 * *std::min_element(times.begin(), times.end());
}

std::vector<double> CreepRate::relaxation_times() const {
  std::vector<double> times;
  for (std::size_t b = 0; b < points_.size(); ++b) {
    const double fastest = points_[b].empty() ? 0
                                              : points_[b].stiffest_rate(elasticity_.states()[b].stress,
                                                                         state_.data() + layout_.offset(b));
    times.push_back(fastest > 0 ? 1 / fastest : std::numeric_limits<double>::infinity());
  }
  return times;
}

void CreepRate::accept(double t, std::span<const double> /*y*/) {
  // The last evaluation is at or beside the accepted point: its contact state and stress are the nearest ones at hand,
  // unless the step was too short for any and the last one is an output's of long ago.
  if (for_output_ && load_time(t) != time_) return;
  elasticity_.keep_warm();
  const auto lap = watch_.lap(Part::material);
  scale_->follow(elasticity_.states());
}

void CreepRate::save(ContactElasticity::Memory& memory) const {
  elasticity_.save(memory);
  memory["strain_scale"] = scale_->strain();
}

void CreepRate::restore(const ContactElasticity::Memory& memory) {
  elasticity_.restore(memory);
  scale_->restore(memory.at("strain_scale"));
}

ode::System::Counters CreepRate::counters() const {
  const ContactElasticity::Counters elastic = elasticity_.counters();
  Counters result;
  result.rate_evaluations = rate_evaluations_;
  result.jacobian_products = jacobian_products_;
  result.elastic_solves = elastic.elastic_solves;
  result.contact_solves = elastic.contact_solves;
  result.schwarz_iterations = elastic.schwarz_iterations;
  result.factorizations = elastic.factorizations;
  if (tangent_) {
    result.elastic_solves += tangent_->solves();
    result.factorizations += tangent_->factorizations();
  }
  result.active_contacts = static_cast<std::int64_t>(elasticity_.active_contacts());
  return result;
}

}  // namespace creepcontact::simulation
