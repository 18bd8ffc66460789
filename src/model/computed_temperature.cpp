#include "computed_temperature.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/config/configured.hpp"
#include "creepcontact/heat/history.hpp"
#include "heat_definition.hpp"
#include "heat_remarks.hpp"
#include "heat_stops.hpp"
#include "kept_temperatures.hpp"

namespace creepcontact::model {
namespace {

constexpr double same_node = 1e-9;        // of the size of the model
constexpr int range_samples = 64;         // of functions in time
constexpr double linear_pressure = 1e-7;  // of Young's modulus: at most where conductances are made linear
constexpr double steep = 1e-6;            // of that pressure: where an infinite slope shows
constexpr double too_steep = 1.5;

/// Conductances such as p^0.95 have an infinite slope at p = 0, of which no integrator can make anything.
void bound_slope(heat::Interface& interface, double pressure) {
  const auto at = [&](double p) { return interface.conductance({.p = p}); };
  const double far = (at(pressure) - at(0)) / pressure, near = (at(steep * pressure) - at(0)) / (steep * pressure);
  if (!(std::abs(near) > too_steep * std::abs(far))) return;
  interface.linear_below = pressure;
  log::info("contact '{}': the slope of the conductance is infinite at p = 0; below p = {:.3g} it is taken linear",
            interface.name, pressure);
}

class HeatProblem {
 public:
  HeatProblem(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes, heat::Definition all)
      : config_(config),
        heat_(*config.heat),
        whole_(whole),
        meshes_(meshes),
        places_(some_places(meshes)),
        all_(std::move(all)) {}

  ComputedTemperature solve() {
    heat::Conduction problem(std::move(all_));
    const bool is_coupled = config_.has_coupled_heat();
    const bool is_steady = !heat_.start && !config::heat_changes_in_time(config_) && !is_coupled;
    const double end = is_steady ? 0 : config_.time.end;
    const HeatStops stops(config_, places_, guess(), end);
    const std::vector<double>& smooth_between = stops.kinks();
    std::string fingerprint;
    if (heat_.keep && !is_coupled) {
      fingerprint = heat_fingerprint(problem.definition(),
                                     fmt::format("start\t{}\ntime.end\t{:.17g}\nbreakpoints\t{}\ntolerance\t{:.17g}\n",
                                                 heat_.start ? heat_.start->text() : "steady", end,
                                                 fmt::join(smooth_between, ", "), heat_.tolerance));
      if (const auto kept = read_kept(*heat_.keep, fingerprint, problem.size())) {
        return {field(problem, *kept, false),
                creep::HeatModel{.definition = problem.definition(), .is_steady = end == 0},
                figures(problem, kept->values.front(), end)};
      }
    }
    std::vector<double> start = problem.unknowns(heat_.start.value_or(guess()));
    if (!heat_.start) {
      problem.steady(0, start);
      if (!is_steady && !is_coupled) {
        const auto [low, high] = std::ranges::minmax(start);
        log::info("heat: starts from the steady state with what acts at t = 0, {:.6g} to {:.6g}", low, high);
      }
    }
    heat::Figures of_problem = figures(problem, start, end);
    const Interval range = range_of_temperatures(problem, start);
    if (is_coupled) {
      heat::History at_start = heat::integrate(problem, start, {});
      at_start.kinks = stops.kinks_and_turns();
      log::info("heat: {} temperatures are part of the state, since conductances depend on contact{}", problem.size(),
                heat_.keep ? "; 'keep' has no temperatures to keep" : "");
      return {field(problem, at_start, true),
              creep::HeatModel{.definition = problem.definition(),
                               .is_state = true,
                               .start = std::move(start),
                               .start_is_steady = !heat_.start,
                               .range = size_of(range),
                               .unknown_of = problem.unknown_of()},
              std::move(of_problem)};
    }
    const double allowed = heat_.tolerance * size_of(range);
    const heat::History history =
        heat::integrate(problem, start, {end, smooth_between, allowed, stops.end_of_step(), stops.repeats()});
    tell(problem, history);
    if (heat_.keep) write_kept(*heat_.keep, fingerprint, history);
    return {field(problem, history, false), creep::HeatModel{.definition = problem.definition(), .is_steady = end == 0},
            std::move(of_problem)};
  }

 private:
  /// Less than a degree counts as one: where nothing seems to happen, heat that is given still may.
  static double size_of(const Interval& range) { return std::max(range.high - range.low, 1.0); }

  heat::Figures figures(const heat::Conduction& problem, const std::vector<double>& start, double end) const {
    std::vector<double> of_bodies;
    for (std::size_t b = 0; b < meshes_.size(); ++b) of_bodies.push_back(problem.at_nodes(b, start).front());
    heat::Figures result = heat::figures(problem.definition(), of_bodies, end);
    if (end > 0) tell_of_heat(problem.definition(), result, end, !heat_.start, config_.units);
    return result;
  }
  /// Some temperature of the problem, from which a steady one is sought.
  double guess() const {
    const auto at_start = [](const Function& value) { return value({}); };
    if (!heat_.films.empty()) return at_start(heat_.films.front().fluid);
    if (!heat_.temperatures.empty()) return at_start(heat_.temperatures.front().value);
    return heat_.radiation.empty() ? 0 : at_start(heat_.radiation.front().ambient);
  }

  /// The range of all temperatures that are given, and of those at the start.
  Interval range_of_temperatures(heat::Conduction& problem, const std::vector<double>& start) const {
    const auto [low, high] = std::ranges::minmax(start);
    Interval range{low, high};
    const auto add = [&](double value) {
      if (heat_.absolute_zero && value < *heat_.absolute_zero)
        throw ModelError(
            fmt::format("a temperature of {:.6g} is given, below absolute_zero = {:.6g}", value, *heat_.absolute_zero));
      if (std::isfinite(value)) range = {std::min(range.low, value), std::max(range.high, value)};
    };
    std::vector<const Function*> given;
    for (const auto& one : heat_.films) given.push_back(&one.fluid);
    for (const auto& one : heat_.radiation) given.push_back(&one.ambient);
    for (const auto& one : heat_.temperatures) given.push_back(&one.value);
    for (const Function* function : given)
      for (const Vector3& x : places_) {
        for (int k = 0; k <= range_samples; ++k)
          add((*function)({.x = x[0], .y = x[1], .z = x[2], .t = config_.time.end * k / range_samples}));
        for (const double t : function->breakpoints(config_.time.end))
          add((*function)({.x = x[0], .y = x[1], .z = x[2], .t = t}));
      }
    if (heat_.fluxes.empty() && heat_.sources.empty() && heat_.point_flows.empty()) return range;
    try {  // heat that is given may lead beyond them
      std::vector<double> last = start;
      problem.steady(config_.time.end, last);
      for (const double value : last) add(value);
    } catch (const Error&) {  // there is no steady state
    }
    return range;
  }

  void tell(const heat::Conduction& problem, const heat::History& history) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const std::vector<double>& values : history.values) {
      const auto [least, most] = std::ranges::minmax(values);
      low = std::min(low, least);
      high = std::max(high, most);
    }
    if (history.times.size() == 1)
      return log::info("heat: steady temperatures of {} nodes, {:.6g} to {:.6g}", problem.size(), low, high);
    const double bytes = 2.0 * static_cast<double>(problem.size() * history.times.size() * sizeof(double));
    log::info(
        "heat: temperatures of {} nodes, {:.6g} to {:.6g}, in {} steps with {} factorisations; {} times are kept "
        "({:.3g} MB){}",
        problem.size(), low, high, history.n_steps, problem.n_factorizations(), history.times.size(), bytes / 1e6,
        history.period
            ? fmt::format("; from t = {:.6g} on they repeat every {:.6g}", history.times.back(), *history.period)
            : "");
  }

  /// @param is_of_state  the field is that at the start
  mechanics::TemperatureField field(const heat::Conduction& problem, const heat::History& history,
                                    bool is_of_state) const {
    Eigen::AlignedBox3d box;
    for (const Vector3& x : whole_.nodes) box.extend(x);
    const auto on_body = [&](std::size_t b, const std::vector<std::vector<double>>& all) {
      std::vector<std::vector<double>> result;
      result.reserve(all.size());
      for (const std::vector<double>& values : all) result.push_back(problem.at_nodes(b, values));
      return result;
    };
    std::vector<mechanics::TemperatureField::OnBody> result;
    for (std::size_t b = 0; b < meshes_.size(); ++b) {
      const auto end = meshes_[b].nodes.begin() + static_cast<std::ptrdiff_t>(meshes_[b].n_cell_nodes());
      mechanics::ScatteredTemperatures given;
      given.points.assign(meshes_[b].nodes.begin(), end);
      given.times = history.times;
      given.values = on_body(b, history.values);
      if (history.times.size() > 1) {
        given.rates_before = on_body(b, history.rates_before);
        given.rates_after = on_body(b, history.rates_after);
      }
      given.kinks = history.kinks;
      given.last_period = history.period;
      given.is_of_state = is_of_state;
      given.node_tolerance = same_node * box.diagonal().norm();
      std::vector<Vector3> nodes = given.points;
      result.push_back({std::move(nodes), std::make_shared<const mechanics::TemperatureField>(std::move(given))});
    }
    return mechanics::TemperatureField(std::move(result));
  }

  const config::Config& config_;
  const config::Heat& heat_;
  const mesh::Mesh& whole_;
  const BodyMeshes& meshes_;
  std::vector<Vector3> places_;
  heat::Definition all_;
};

}  // namespace

ComputedTemperature computed_temperature(const config::Config& config, const mesh::Mesh& whole,
                                         const BodyMeshes& meshes, const SharedNodes& shared, const ModelLinks& links) {
  return HeatProblem(config, whole, meshes, heat_definition(config, whole, meshes, shared, links)).solve();
}

creep::HeatModel of_assembly(creep::HeatModel heat, const config::Config& config, const creep::Assembly& assembly) {
  const std::vector<mechanics::Body>& bodies = assembly.bodies();
  double least_modulus = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    heat.definition.bodies[b].mesh = &bodies[b].mesh();
    const material::Material& material = bodies[b].material();
    least_modulus = std::min(least_modulus, material.young_modulus({.T = material.reference_temperature}));
  }
  for (heat::Interface& interface : heat.definition.interfaces) {
    const auto found = std::ranges::find(assembly.pairs(), interface.name, &contact::Pair::name);
    if (found == assembly.pairs().end()) continue;  // only the heat is computed
    const contact::Pair& pair = *found;
    if (pair.slave_surface.empty()) continue;  // faces of a sector
    const mesh::Mesh &slave = bodies[pair.slave_body].mesh(), &master = bodies[pair.master_body].mesh();
    if (interface.first != pair.slave_body || interface.second != pair.master_body ||
        pair.slave_body == pair.master_body) {
      interface.first = pair.slave_body;
      interface.second = pair.master_body;
      interface.faces = contact::facing_faces(slave, mesh::boundary_faces(slave, pair.slave_surface), master,
                                              mesh::boundary_faces(master, pair.master_surface), sector(config));
    }
    interface.contact_nodes.assign(slave.nodes.size(), -1);
    for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i)
      interface.contact_nodes[static_cast<std::size_t>(pair.coupling.nodes[i].node)] =
          static_cast<int>(pair.first_node) + static_cast<int>(i);
    if (interface.conductance.depends_on_contact()) bound_slope(interface, linear_pressure * least_modulus);
  }
  return heat;
}

}  // namespace creepcontact::model
