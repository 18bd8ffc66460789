#include "plastic_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

/// What a point has from its accepted past. @param width  of its back stresses: 6 n_back
material::PlasticPoint point_of(const PlasticState& of, std::size_t point, std::size_t width) {
  return {tensor::deviator(Tensor6(tensor::view(of.stress, point))), of.accumulated.empty() ? 0 : of.accumulated[point],
          of.back.empty() ? std::span<const double>() : std::span(of.back).subspan(point * width, width)};
}

/// False where the times differ by the rounding with which both sides of a jump are told apart.
bool is_later(double t, double than) {
  constexpr double instant = 1e-12;
  return t - than > instant * std::abs(t);
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
    const mechanics::Body& of = assembly.bodies()[b];
    const material::Plasticity* law = of.material().plasticity.get();
    if (law == nullptr) continue;
    const std::size_t n = of.discretization().n_points();
    Body body{.number = b, .law = law};
    const bool varies = law->depends_on_temperature() && !at[b].temperature.empty();
    const std::size_t n_sets = varies ? n : 1, width = law->n_constants();
    body.constants.resize(n_sets * width);
    try {
      for (std::size_t i = 0; i < n_sets; ++i) {
        const double T = at[b].temperature.empty() ? of.material().reference_temperature : at[b].temperature[i];
        law->evaluate(T, std::span(body.constants).subspan(i * width, width));
      }
    } catch (const std::invalid_argument& error) {
      throw SolverError(fmt::format("material '{}': {}", of.material().name, error.what()));
    }
    body.n_points = n;
    // Flow goes on as in the last step, or stops.
    if (const std::vector<double>& rate = from.bodies[b].rate;
        goes_on && !rate.empty() && is_later(t, from.time) && is_later(from.time, from.smooth_since)) {
      body.guess.resize(rate.size());
      for (std::size_t i = 0; i < rate.size(); ++i) body.guess[i] = (t - from.time) * rate[i];
      for (std::size_t p = 0; p < n; ++p)
        if (!tensor::view(rate, p).isZero(0)) activate(body, p);
    }
    bodies_.push_back(std::move(body));
  }
}

void PlasticFlow::activate(Body& body, std::size_t point) {
  body.is_active.resize(body.n_points);
  if (body.is_active[point] != 0) return;
  body.is_active[point] = 1;
  body.active.push_back(static_cast<std::int32_t>(point));
}

std::span<const double> PlasticFlow::constants(const Body& body, std::size_t point) const {
  const std::size_t width = body.law->n_constants();
  return std::span(body.constants).subspan(body.constants.size() == width ? 0 : point * width, width);
}

double PlasticFlow::temperature(const Body& body, std::size_t point) const {
  const std::vector<double>& given = at_[body.number].temperature;
  return given.empty() ? assembly_.bodies()[body.number].material().reference_temperature : given[point];
}

std::span<const mechanics::CreepStrainView> PlasticFlow::strains(std::span<const mechanics::CreepStrainView> creep) {
  views_.assign(creep.begin(), creep.end());
  for (Body& body : bodies_) {
    const std::vector<double>& before = from_.bodies[body.number].strain;
    if (before.empty() && body.guess.empty()) continue;
    const mechanics::CreepStrainView& own = creep[body.number];
    body.strain.assign(6 * body.n_points, 0.0);
#pragma omp parallel for schedule(static) if (body.n_points > numerics::parallel_points)
    for (std::int64_t i = 0; i < signed_size(body.n_points); ++i) {
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

bool PlasticFlow::yields(const Body& body, std::size_t point, const std::vector<double>& stress) const {
  const PlasticState& before = from_.bodies[body.number];
  const std::size_t width = 6 * body.law->n_back();
  const std::span<const double> own = constants(body, point);
  const double yield = yield_before(body, point);
  const tensor::ConstMap at = tensor::view(stress, point);
  if (before.back.empty()) return tensor::squared_von_mises(at) > yield * yield;
  const Tensor6 X = body.law->back_stress(std::span(before.back).subspan(point * width, width), own);
  return tensor::squared_von_mises(Tensor6(at - X)) > yield * yield;
}

bool PlasticFlow::return_own_stress(const Equilibrium& at) {
  bool flows = false;
  for (Body& body : bodies_) {
    const PlasticState& before = from_.bodies[body.number];
    const std::vector<double>& stress = at.bodies[body.number].stress;
    const mechanics::ElasticState elastic = at_[body.number].elastic();
    const std::size_t n = body.n_points, width = 6 * body.law->n_back();
    bool any = false;
    if (body.guess.empty()) {
#pragma omp parallel for schedule(static) reduction(|| : any) if (n > numerics::parallel_points)
      for (std::int64_t i = 0; i < signed_size(n); ++i) any = any || yields(body, static_cast<std::size_t>(i), stress);
      if (!any) {
        body.flow.clear();
        continue;
      }
      any = false;
    }
    const auto flow_at = [&](std::size_t p, std::span<double> back) {
      Tensor6 trial = tensor::deviator(Tensor6(tensor::view(stress, p)));
      if (!body.guess.empty()) trial += 2 * elastic.at(p).mu * tensor::view(body.guess, p);
      const material::PlasticPoint from = point_of(before, p, width);
      return body.law->flow(from, trial, elastic.at(p).mu, temperature(body, p), constants(body, p), back);
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
  const PlasticState& before = from_.bodies[body.number];
  const double p = before.accumulated.empty() ? 0 : before.accumulated[point];
  return body.law->yield_stress(p, temperature(body, point), constants(body, point)).stress;
}

double PlasticFlow::elastic_strain_at_yield(const Body& body, std::size_t point) const {
  return yield_before(body, point) / (3 * at_[body.number].elastic().at(point).mu);
}

double PlasticFlow::root_of_energy(const Body& body, std::size_t point) const {
  const mechanics::Discretization& discretization = assembly_.bodies()[body.number].discretization();
  return std::sqrt(2 * at_[body.number].elastic().at(point).mu * discretization.weights()[point]);
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
    body.guess.assign(6 * body.n_points, 0.0);
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
    const std::size_t n = body.n_points, width = 6 * body.law->n_back();
    after.strain = before.strain;
    after.accumulated = before.accumulated;
    after.back = before.back;
    after.rate.clear();
    if (!body.flow.empty()) {
      after.strain.resize(6 * n);
      after.accumulated.resize(n);
      after.back.resize(n * width);
      if (is_later(time_, from_.time)) after.rate.assign(6 * n, 0.0);
      const mechanics::ElasticState elastic = at_[body.number].elastic();
      for (const std::int32_t active : body.active) {
        const auto p = static_cast<std::size_t>(active);
        const tensor::ConstMap change = tensor::view(body.flow, p);
        tensor::writable(after.strain, p) += change;
        after.accumulated[p] += body.accumulated[p];
        std::copy_n(body.back.begin() + signed_size(p * width), width, after.back.begin() + signed_size(p * width));
        if (!after.rate.empty()) tensor::writable(after.rate, p) = change / (time_ - from_.time);
        Tensor6 rest = change;
        if (!body.guess.empty()) rest -= tensor::view(body.guess, p);
        tensor::writable(stress, p) -= 2 * elastic.at(p).mu * rest;
      }
    }
    after.stress.clear();  // that of the equilibrium
  }
}

double PlasticFlow::excursion(const Equilibrium& at) const {
  double largest = 0;
  bool yields = false;
  for (const Body& body : bodies_) {
    const PlasticState& before = from_.bodies[body.number];
    const std::size_t width = 6 * body.law->n_back();
    for (std::size_t p = 0; p < body.n_points; ++p) {
      const Tensor6 now = tensor::view(at.bodies[body.number].stress, p), then = tensor::view(before.stress, p);
      const material::PlasticPoint from = point_of(before, p, width);
      const double yield = body.law->yield_stress(from.accumulated, temperature(body, p), constants(body, p)).stress;
      largest = std::max(largest, tensor::von_mises(Tensor6(now - then)) / yield);
      yields = yields || tensor::von_mises(Tensor6(now - body.law->back_stress(from.back, constants(body, p)))) >
                             (1 + yield_rounding) * yield;
    }
  }
  largest = assembly_.team().max(largest);
  return assembly_.team().any(yields) ? largest : 0;
}

double PlasticFlow::redone_error(const Equilibrium& at) const {
  constexpr double of_difference = 1.0 / 3;  // a double step of second order is off by four times two steps
  double largest = 0;
  for (const Body& body : bodies_) {
    const PlasticState &before = from_.bodies[body.number], &now = at.plastic.bodies[body.number];
    const std::vector<double>& stress = at.bodies[body.number].stress;
    const mechanics::ElasticState elastic = at_[body.number].elastic();
    const std::size_t width = 6 * body.law->n_back();
    std::vector<double> back(width);
    for (std::size_t p = 0; p < body.n_points && !now.strain.empty(); ++p) {
      Tensor6 change = tensor::view(now.strain, p);
      if (!before.strain.empty()) change -= tensor::view(before.strain, p);
      if (change.isZero(0)) continue;
      const double mu = elastic.at(p).mu;
      const Tensor6 trial = tensor::deviator(Tensor6(tensor::view(stress, p))) + 2 * mu * change;
      const material::PlasticPoint from = point_of(before, p, width);
      const Tensor6 redone = body.law->flow(from, trial, mu, temperature(body, p), constants(body, p), back).strain;
      const double yield = body.law->yield_stress(now.accumulated[p], temperature(body, p), constants(body, p)).stress;
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
    const mechanics::ElasticState elastic = at_[body.number].elastic();
    for (std::size_t p = 0; p < body.n_points; ++p) {
      const double accumulated = of_b.accumulated.empty() ? 0 : of_b.accumulated[p];
      const double yield = body.law->yield_stress(accumulated, temperature(body, p), constants(body, p)).stress;
      largest = std::max({largest, size(of_a.stress, of_b.stress, p) / yield,
                          2 * elastic.at(p).mu * size(of_a.strain, of_b.strain, p) / yield});
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
