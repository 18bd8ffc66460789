#include "plastic_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/numerics/parallel.hpp"
#include "stress_norm.hpp"

namespace creepcontact::creep {
namespace {

constexpr int mixing_depth = 10;
constexpr int max_passes = 200;
constexpr int passes_before_collapse = 40;  // guesses on the way may be far off
constexpr double yield_rounding = 1e-6;     // of the yield stress
constexpr double max_flow = 100;            // elastic strains at yield, in one step: beyond is collapse

std::int64_t signed_size(std::size_t n) {
  return static_cast<std::int64_t>(n);
}

/// False where the times differ by the rounding with which both sides of a jump are told apart.
bool is_later(double t, double than) {
  constexpr double instant = 1e-12;
  return t - than > instant * std::abs(t);
}

/// Over all points. Most evaluations ask no more: without a branch, and without temporary tensors, it is as fast as
/// memory.
double largest_squared_von_mises(const std::vector<double>& stress) {
  const std::int64_t n = signed_size(stress.size() / 6);
  double largest = 0;
#pragma omp parallel for schedule(static) reduction(max : largest) if (n > signed_size(numerics::parallel_points))
  for (std::int64_t i = 0; i < n; ++i) {
    const double* const s = &stress[static_cast<std::size_t>(6 * i)];
    const double mean = (s[0] + s[1] + s[2]) / 3, a = s[0] - mean, b = s[1] - mean, c = s[2] - mean;
    largest = std::max(largest, 1.5 * (a * a + b * b + c * c + s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
  }
  return largest;
}

}  // namespace

PlasticHistory virgin_plastic_history(const Assembly& assembly) {
  PlasticHistory history;
  const auto yields = [](const mechanics::Body& body) { return body.material().plasticity != nullptr; };
  if (!std::ranges::any_of(assembly.bodies(), yields)) return history;
  history.bodies.resize(assembly.bodies().size());
  for (std::size_t b = 0; b < history.bodies.size(); ++b)
    if (const mechanics::Body& body = assembly.bodies()[b]; yields(body))
      history.bodies[b].stress.assign(6 * body.discretization().n_points(), 0.0);
  return history;
}

PlasticFlow::PlasticFlow(const Assembly& assembly, const PlasticHistory& from, double t,
                         std::span<const mechanics::BodyConditions> at, double tolerance, bool goes_on, double part)
    : assembly_(assembly),
      from_(from),
      time_(t),
      at_(at),
      tolerance_(tolerance),
      part_(part),
      mixing_(mixing_depth, assembly.team()) {
  for (std::size_t b = 0; b < assembly.bodies().size(); ++b) {
    if (assembly.bodies()[b].material().plasticity == nullptr) continue;
    Body body{.number = b, .points = PlasticPoints(assembly.bodies()[b], at[b])};
    // Flow goes on as in the last step, or stops.
    if (const std::vector<double>& rate = from.bodies[b].rate;
        goes_on && !rate.empty() && is_later(t, from.time) && is_later(from.time, from.smooth_since)) {
      body.guess.resize(rate.size());
      for (std::size_t i = 0; i < rate.size(); ++i) body.guess[i] = (t - from.time) * rate[i];
      for (std::size_t p = 0; p < body.points.size(); ++p)
        if (!tensor::view(rate, p).isZero(0)) activate(body, p);
    }
    bodies_.push_back(std::move(body));
  }
}

void PlasticFlow::activate(Body& body, std::size_t point) {
  body.is_active.resize(body.points.size());
  if (body.is_active[point] != 0) return;
  body.is_active[point] = 1;
  body.active.push_back(static_cast<std::int32_t>(point));
}

std::span<const mechanics::CreepStrainView> PlasticFlow::strains(std::span<const mechanics::CreepStrainView> creep) {
  views_.assign(creep.begin(), creep.end());
  for (Body& body : bodies_) {
    const std::vector<double>& before = from_.bodies[body.number].strain;
    if (before.empty() && body.guess.empty()) continue;
    const mechanics::CreepStrainView& own = creep[body.number];
    body.strain.assign(6 * body.points.size(), 0.0);
#pragma omp parallel for schedule(static) if (body.points.size() > numerics::parallel_points)
    for (std::int64_t i = 0; i < signed_size(body.points.size()); ++i) {
      const auto p = static_cast<std::size_t>(i);
      tensor::Map sum = tensor::writable(body.strain, p);
      if (!own.empty()) sum += own.at(p);
      if (!before.empty()) sum += tensor::view(before, p);
      if (!body.guess.empty()) sum += tensor::view(body.guess, p);
    }
    views_[body.number] = {body.strain, 6};
  }
  return views_;
}

bool PlasticFlow::return_stress(const Equilibrium& at) {
  bool flows = false;
  together(assembly_.team(), [&] { flows = return_own_stress(at); });
  return assembly_.team().any(flows);
}

bool PlasticFlow::yields(const Body& body, std::size_t point, const std::vector<double>& stress, double margin) const {
  const std::vector<double>& back = from_.bodies[body.number].back;
  const double yield = (1 + margin) * yield_before(body, point);
  const tensor::ConstMap at = tensor::view(stress, point);
  if (back.empty()) return tensor::squared_von_mises(at) > yield * yield;
  return tensor::squared_von_mises(Tensor6(at - body.points.back_stress(point, back))) > yield * yield;
}

bool PlasticFlow::any_yields(const Body& body, const std::vector<double>& stress) const {
  const PlasticState& before = from_.bodies[body.number];
  const std::int64_t n = signed_size(body.points.size());
  if (body.points.is_uniform() && before.accumulated.empty() && before.back.empty()) {
    const double yield = n > 0 ? yield_before(body, 0) : 0;
    return largest_squared_von_mises(stress) > yield * yield;
  }
  bool any = false;
#pragma omp parallel for schedule(static) reduction(|| : any) if (n > signed_size(numerics::parallel_points))
  for (std::int64_t i = 0; i < n; ++i) {
    any = any || yields(body, static_cast<std::size_t>(i), stress);
  }
  return any;
}

bool PlasticFlow::return_own_stress(const Equilibrium& at) {
  bool flows = false;
  for (Body& body : bodies_) {
    const PlasticState& before = from_.bodies[body.number];
    const std::vector<double>& stress = at.bodies[body.number].stress;
    const std::size_t n = body.points.size(), width = body.points.back_width();
    bool any = false;
    if (body.guess.empty() && !any_yields(body, stress)) {
      body.flow.clear();
      continue;
    }
    const auto flow_at = [&](std::size_t p, std::span<double> back) {
      Tensor6 trial = tensor::deviator(Tensor6(tensor::view(stress, p)));
      if (!body.guess.empty()) trial += 2 * body.points.shear_modulus(p) * tensor::view(body.guess, p);
      return body.points.flow(p, before, trial, back);
    };
    std::vector<material::PlasticFlowStep> found(n);
    std::vector<double> back(n * width);
#pragma omp parallel for schedule(static) reduction(|| : any) if (n > numerics::parallel_points)
    for (std::int64_t i = 0; i < signed_size(n); ++i) {
      const auto p = static_cast<std::size_t>(i);
      found[p] = flow_at(p, std::span(back).subspan(p * width, width));
      any = any || found[p].accumulated > 0;
    }
    flows = flows || any;
    if (!any && body.guess.empty()) {
      body.flow.clear();
      continue;
    }
    body.flow.assign(6 * n, 0.0);
    body.accumulated.assign(n, 0.0);
    body.back = std::move(back);
    for (std::size_t p = 0; p < n; ++p) {
      if (found[p].accumulated == 0) continue;
      if (n_iterations_ >= passes_before_collapse) require_limited_flow(body, p, found[p].accumulated);
      tensor::writable(body.flow, p) = found[p].strain;
      body.accumulated[p] = found[p].accumulated;
      activate(body, p);
    }
  }
  return flows;
}

std::string PlasticFlow::loads() const {
  if (part_ == 1) return fmt::format("the loads of t = {:.6g}", time_);
  return fmt::format("{:.4g} % of the loads of t = {:.6g}", 100 * part_, at_.front().time);
}

void PlasticFlow::require_limited_flow(const Body& body, std::size_t point, double change) const {
  if (change <= max_flow * elastic_strain_at_yield(body, point)) return;
  constexpr double without_limit = 1;
  const std::string flow =
      change > without_limit ? "without limit" : fmt::format("by a plastic strain of {:.3g} in one step", change);
  throw SolverError(fmt::format("{} cannot be carried: body '{}' flows {} at {}", loads(),
                                assembly_.bodies()[body.number].name(), flow, place(body, point)));
}

void PlasticFlow::give_up() const {
  const Body* worst = nullptr;
  std::size_t point = 0;
  double most = -1;
  for (const Body& body : bodies_)
    for (std::size_t p = 0; p < body.accumulated.size(); ++p)
      if (const double of_elastic = body.accumulated[p] / elastic_strain_at_yield(body, p); of_elastic > most)
        most = of_elastic, worst = &body, point = p;
  const double largest = assembly_.team().max(most);
  together(assembly_.team(), [&] {
    if (most != largest) return;
    if (worst == nullptr) throw SolverError(fmt::format("{}: the plastic strain is not found", loads()));
    throw SolverError(
        fmt::format("{} cannot be carried, or hardly: body '{}' still flows after {} iterations, so far by a plastic "
                    "strain of {:.3g} in one step at {}",
                    loads(), assembly_.bodies()[worst->number].name(), max_passes, worst->accumulated[point],
                    place(*worst, point)));
  });
}

std::string PlasticFlow::place(const Body& body, std::size_t point) const {
  const Vector3& x = assembly_.bodies()[body.number].discretization().point_coordinates()[point];
  return fmt::format("({:.6g}, {:.6g}, {:.6g}), where the yield stress is {:.6g}", x.x(), x.y(), x.z(),
                     yield_before(body, point));
}

double PlasticFlow::yield_before(const Body& body, std::size_t point) const {
  return body.points.yield_stress(point, from_.bodies[body.number].accumulated);
}

double PlasticFlow::elastic_strain_at_yield(const Body& body, std::size_t point) const {
  return yield_before(body, point) / (3 * body.points.shear_modulus(point));
}

double PlasticFlow::root_of_energy(const Body& body, std::size_t point) const {
  const mechanics::Discretization& discretization = assembly_.bodies()[body.number].discretization();
  return std::sqrt(2 * body.points.shear_modulus(point) * discretization.weights()[point]);
}

void PlasticFlow::gather(std::vector<double>& guess, std::vector<double>& flow) const {
  guess.clear();
  flow.clear();
  for (const Body& body : bodies_)
    for (const std::int32_t p : body.active) {
      const auto point = static_cast<std::size_t>(p);
      const double root = root_of_energy(body, point);
      for (std::size_t k = 6 * point; k < 6 * point + 6; ++k) {
        guess.push_back(body.guess.empty() ? 0 : root * body.guess[k]);
        flow.push_back(body.flow.empty() ? 0 : root * body.flow[k]);
      }
    }
}

void PlasticFlow::scatter(std::span<const double> guess) {
  std::size_t next = 0;
  for (Body& body : bodies_) {
    if (body.active.empty()) continue;
    body.guess.assign(6 * body.points.size(), 0.0);
    for (const std::int32_t p : body.active) {
      const auto point = static_cast<std::size_t>(p);
      const double root = root_of_energy(body, point);
      for (std::size_t k = 6 * point; k < 6 * point + 6; ++k) body.guess[k] = guess[next++] / root;
    }
  }
}

void PlasticFlow::finish(Equilibrium& into) const {
  into.plastic.time = time_;
  into.plastic.smooth_since = from_.smooth_since;
  into.plastic.flows =
      assembly_.team().any(std::ranges::any_of(bodies_, [](const Body& body) { return !body.flow.empty(); }));
  into.plastic.bodies.resize(from_.bodies.size());
  for (const Body& body : bodies_) {
    const PlasticState& before = from_.bodies[body.number];
    PlasticState& after = into.plastic.bodies[body.number];
    std::vector<double>& stress = into.bodies[body.number].stress;
    const std::size_t n = body.points.size(), width = body.points.back_width();
    after.strain = before.strain;
    after.accumulated = before.accumulated;
    after.back = before.back;
    after.rate.clear();
    if (!body.flow.empty()) {
      after.strain.resize(6 * n);
      after.accumulated.resize(n);
      after.back.resize(n * width);
      if (is_later(time_, from_.time)) after.rate.assign(6 * n, 0.0);
      for (const std::int32_t active : body.active) {
        const auto p = static_cast<std::size_t>(active);
        const tensor::ConstMap change = tensor::view(body.flow, p);
        tensor::writable(after.strain, p) += change;
        after.accumulated[p] += body.accumulated[p];
        std::copy_n(body.back.begin() + signed_size(p * width), width, after.back.begin() + signed_size(p * width));
        if (!after.rate.empty()) tensor::writable(after.rate, p) = change / (time_ - from_.time);
        Tensor6 rest = change;
        if (!body.guess.empty()) rest -= tensor::view(body.guess, p);
        tensor::writable(stress, p) -= 2 * body.points.shear_modulus(p) * rest;
      }
    }
    after.stress.clear();  // that of the equilibrium
  }
}

double PlasticFlow::excursion(const Equilibrium& at) const {
  double largest = 0;
  bool leaves = false;
  for (const Body& body : bodies_) {
    const std::vector<double>&now = at.bodies[body.number].stress, &then = from_.bodies[body.number].stress;
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      const Tensor6 change = tensor::view(now, p) - tensor::view(then, p);
      largest = std::max(largest, tensor::von_mises(change) / yield_before(body, p));
      leaves = leaves || yields(body, p, now, yield_rounding);
    }
  }
  largest = assembly_.team().max(largest);
  return assembly_.team().any(leaves) ? largest : 0;
}

double PlasticFlow::redone_error(const std::vector<PlasticState>& before, const Equilibrium& at) const {
  constexpr double of_difference = 1.0 / 3;  // a double step of second order is off by four times two steps
  double largest = 0;
  for (const Body& body : bodies_) {
    const PlasticState &from = before[body.number], &now = at.plastic.bodies[body.number];
    const std::vector<double>& stress = at.bodies[body.number].stress;
    std::vector<double> back(body.points.back_width());
    for (std::size_t p = 0; p < body.points.size() && !now.strain.empty(); ++p) {
      Tensor6 change = tensor::view(now.strain, p);
      if (!from.strain.empty()) change -= tensor::view(from.strain, p);
      if (change.isZero(0)) continue;
      const double mu = body.points.shear_modulus(p);
      const Tensor6 trial = tensor::deviator(Tensor6(tensor::view(stress, p))) + 2 * mu * change;
      const Tensor6 redone = body.points.flow(p, from, trial, back).strain;
      const double yield = body.points.yield_stress(p, now.accumulated);
      largest = std::max(largest, of_difference * tensor::von_mises(Tensor6(2 * mu * (redone - change))) / yield);
    }
  }
  return assembly_.team().max(largest);
}

double PlasticFlow::difference(const PlasticHistory& a, const PlasticHistory& b) const {
  double largest = 0;
  const auto size = [](const std::vector<double>& first, const std::vector<double>& second, std::size_t point) {
    Tensor6 difference = Tensor6::Zero();
    if (!first.empty()) difference += tensor::view(first, point);
    if (!second.empty()) difference -= tensor::view(second, point);
    return tensor::von_mises(difference);
  };
  for (const Body& body : bodies_) {
    const PlasticState &of_a = a.bodies[body.number], &of_b = b.bodies[body.number];
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      const double yield = body.points.yield_stress(p, of_b.accumulated);
      largest = std::max({largest, size(of_a.stress, of_b.stress, p) / yield,
                          2 * body.points.shear_modulus(p) * size(of_a.strain, of_b.strain, p) / yield});
    }
  }
  return assembly_.team().max(largest);
}

bool PlasticFlow::advance(Equilibrium& into) {
  const bool flows = return_stress(into);
  const auto has_guess = [](const Body& body) { return !body.guess.empty(); };
  if (!flows && !assembly_.team().any(std::ranges::any_of(bodies_, has_guess))) {
    finish(into);
    return true;
  }
  std::vector<double> guess, flow;
  gather(guess, flow);
  double change = 0;
  for (std::size_t i = 0; i < guess.size(); ++i) change += (flow[i] - guess[i]) * (flow[i] - guess[i]);
  change = std::sqrt(assembly_.team().sum(change));
  if (change <= tolerance_ * stress_norm(assembly_, into)) {
    together(assembly_.team(), [&] {
      for (const Body& body : bodies_)
        for (const std::int32_t p : body.active)
          if (!body.accumulated.empty())
            require_limited_flow(body, static_cast<std::size_t>(p), body.accumulated[static_cast<std::size_t>(p)]);
    });
    finish(into);
    return true;
  }
  if (++n_iterations_ == max_passes) give_up();
  std::vector<double> next(guess.size());
  mixing_.mix(guess, flow, next);
  scatter(next);
  return false;
}

}  // namespace creepcontact::creep
