#include "computed_temperature.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include "course_events.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/config/configured.hpp"
#include "creepcontact/heat/history.hpp"
#include "creepcontact/model/step_guard.hpp"
#include "heat_remarks.hpp"
#include "kept_temperatures.hpp"

namespace creepcontact::model {
namespace {

constexpr double same_node = 1e-9;  // of the size of the model
constexpr int range_samples = 64;   // of functions in time
constexpr std::size_t course_places = 5;
constexpr std::size_t most_stops = 1000;  // of a function, at each of which a step ends
constexpr double linear_pressure = 1e-7;  // of Young's modulus: at most where conductances are made linear
constexpr double steep = 1e-6;            // of that pressure: where an infinite slope shows
constexpr double too_steep = 1.5;

/// Errors of an entry of [heat] name its list and place.
template <typename Work>
void for_entries(const auto& entries, const char* list, const Work& work) {
  for (std::size_t i = 0; i < entries.size(); ++i) try {
      work(entries[i]);
    } catch (const ModelError& error) {
      throw ModelError(fmt::format("{}[{}]: {}", list, i, error.what()));
    }
}

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
  HeatProblem(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes,
              const SharedNodes& shared, const ModelLinks& links)
      : config_(config), heat_(*config.heat), whole_(whole), meshes_(meshes) {
    all_.time_unit = heat_.time_unit.value_or(1);
    all_.absolute_zero = heat_.absolute_zero.value_or(0);
    add_bodies();
    add_flows();
    add_point_flows();
    warn_of_twice_given();
    tell_of_films_in_contact();
    for (const config::Contact& contact : config.contacts) add_contact(contact);
    for (const SharedNodes::Joined& both : shared.joined())
      all_.equal.push_back({{both.first.body, both.first.node}, {both.second.body, both.second.node}});
    for (std::size_t b = 0; b < meshes.size(); ++b)
      for (const mechanics::NodeLinks::Turned& link : links.of_body[b].turned)
        all_.equal.push_back({{b, link.node}, {b, link.of}});
    for (const ModelLinks::UnmatchedFace& unmatched : links.unmatched) add_sector_faces(unmatched);
  }

  ComputedTemperature solve() {
    heat::Conduction problem(std::move(all_));
    const bool is_coupled = config_.has_coupled_heat();
    const bool is_steady = !heat_.start && !config::heat_changes_in_time(config_) && !is_coupled;
    const double end = is_steady ? 0 : config_.time.end;
    const Stops stops = find_stops(end);
    const std::vector<double>& smooth_between = stops.kinks;
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
      at_start.kinks = stops.kinks;
      at_start.kinks.insert(at_start.kinks.end(), stops.turns.begin(), stops.turns.end());
      at_start.kinks = sorted(std::move(at_start.kinks), end);
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
        heat::integrate(problem, start, {end, smooth_between, allowed, end_of_step(stops, end)});
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
    if (end > 0) tell_of_heat(problem.definition(), result, end, !heat_.start);
    return result;
  }
  int face_dimension() const { return whole_.section.dimension() - 1; }
  std::vector<std::size_t> bodies_on(const config::Reference& on, const config::Reference& body, int dimension) const {
    return model::bodies_on(config_, whole_, meshes_, on.name, body, dimension);
  }

  void add_bodies() {
    for (std::size_t b = 0; b < meshes_.size(); ++b) {
      const config::Material& material = config_.material(config_.bodies[b].material.name);
      all_.bodies.push_back({config_.bodies[b].name, &meshes_[b], material.conductivity,
                             material.conductivity.size() == 3 ? material_axes(config_.bodies[b]) : std::nullopt,
                             material.heat_capacity.value_or(0.0), material.density.value_or(1)});
    }
  }

  /// A name that no other flow has: the second one on a surface is number 2.
  std::string another(const std::string& name) {
    const int number = ++names_[name];
    return number == 1 ? name : fmt::format("{}, number {}", name, number);
  }

  void add_flow(heat::SurfaceFlow::Kind kind, const config::Reference& on, const config::Reference& body,
                const Function& factor, const Function& beyond) {
    using Kind = heat::SurfaceFlow::Kind;
    const char* const word = kind == Kind::film ? "film" : kind == Kind::flux ? "flux" : "radiation";
    for (const std::size_t b : bodies_on(on, body, face_dimension()))
      all_.flows.push_back({kind, b, mesh::boundary_faces(meshes_[b], on.name), factor, beyond,
                            another(fmt::format("{} on '{}' of body '{}'", word, on.name, config_.bodies[b].name))});
  }

  void add_flows() {
    using Kind = heat::SurfaceFlow::Kind;
    for_entries(heat_.films, "films", [&](const config::HeatFilm& film) {
      add_flow(Kind::film, film.on, film.body, film.coefficient, film.fluid);
    });
    for_entries(heat_.fluxes, "fluxes",
                [&](const config::HeatFlux& flux) { add_flow(Kind::flux, flux.on, flux.body, flux.value, 0.0); });
    for_entries(heat_.radiation, "radiation", [&](const config::HeatRadiation& radiation) {
      const double sigma = *heat_.stefan_boltzmann;
      add_flow(Kind::radiation, radiation.on, radiation.body,
               Function::composed(
                   fmt::format("{:.17g} times {}", sigma, radiation.emissivity.text()), {radiation.emissivity},
                   [sigma](const std::vector<double>& values) {
                     return values[0] <= 1 ? sigma * values[0] : std::numeric_limits<double>::quiet_NaN();
                   }),
               radiation.ambient);
    });
    for_entries(heat_.sources, "sources", [&](const config::HeatSource& source) {
      all_.sources.push_back({body_index(config_, source.body.name), source.value,
                              another(fmt::format("source in body '{}'", source.body.name))});
    });
    for_entries(heat_.temperatures, "temperatures", [&](const config::HeatTemperature& given) {
      for (const std::size_t b : bodies_on(given.on, given.body, -1))
        all_.given.push_back(
            {b, mesh::group_nodes(meshes_[b], given.on.name), given.value,
             another(fmt::format("given temperature of '{}' on body '{}'", given.on.name, config_.bodies[b].name))});
    });
  }

  void tell_of_films_in_contact() const {
    for (const config::HeatFilm& film : heat_.films)
      for (const config::Contact& contact : config_.contacts)
        if (std::ranges::any_of(contact.between, [&](const auto& side) { return side.name == film.on.name; }))
          log::info("heat: the film on '{}' acts where contact '{}' is closed, too", film.on.name, contact.name);
  }

  void warn_of_twice_given() const {
    for (std::size_t i = 0; i < all_.given.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const heat::GivenTemperature &later = all_.given[i], &earlier = all_.given[j];
        if (later.body != earlier.body) continue;
        const std::set<std::int64_t> nodes(earlier.nodes.begin(), earlier.nodes.end());
        for (const std::int64_t node : later.nodes) {
          if (!nodes.contains(node)) continue;
          const Vector3& x = meshes_[later.body].nodes[static_cast<std::size_t>(node)];
          const Arguments at{.x = x[0], .y = x[1], .z = x[2]};
          const double one = earlier.value(at), other = later.value(at);
          if (one == other) continue;
          log::warning("heat: at ({:.6g}, {:.6g}, {:.6g}) the {} is {:.6g}, and the {} is {:.6g}: the last one counts",
                       x[0], x[1], x[2], earlier.name, one, later.name, other);
          break;
        }
      }
  }

  void add_point_flows() {
    for_entries(heat_.point_flows, "point_flows", [&](const config::HeatPointFlow& flow) {
      heat::PointFlow made{{}, flow.value, another(fmt::format("flow into the nodes of '{}'", flow.on.name))};
      for (const std::size_t b : bodies_on(flow.on, flow.body, -1))
        for (const std::int64_t node : mesh::group_nodes(meshes_[b], flow.on.name)) made.nodes.push_back({b, node});
      all_.point_flows.push_back(std::move(made));
    });
  }

  void add_contact(const config::Contact& contact) {
    using Kind = config::Conductance::Kind;
    if (contact.conductance.kind == Kind::insulated) return;
    const auto owners = [&](std::size_t side) { return bodies_on(contact.between[side], {}, face_dimension()); };
    const std::array<std::size_t, 2> bodies = contact_bodies(contact, config_, {owners(0), owners(1)});
    heat::Interface made{
        contact.name, bodies[0], bodies[1], {}, contact.conductance.value, contact.conductance.kind != Kind::function};
    made.faces = contact::facing_faces(
        meshes_[bodies[0]], mesh::boundary_faces(meshes_[bodies[0]], contact.between[0].name), meshes_[bodies[1]],
        mesh::boundary_faces(meshes_[bodies[1]], contact.between[1].name), sector(config_));
    all_.interfaces.push_back(std::move(made));
  }

  /// Like a contact of the body with itself in the next sector.
  void add_sector_faces(const ModelLinks::UnmatchedFace& unmatched) {
    const mesh::Mesh& mesh = meshes_[unmatched.body];
    const auto faces = [&](std::size_t side) {
      return mesh::boundary_faces(mesh, config_.cyclic[unmatched.cyclic].between[side].name);
    };
    heat::Interface made{sector_tie_name(config_, unmatched), unmatched.body, unmatched.body, {}, 0.0, true};
    made.faces = contact::facing_faces(mesh, faces(1), mesh, faces(0), sector(config_));
    all_.interfaces.push_back(std::move(made));
  }

  /// Some temperature of the problem, from which a steady one is sought.
  double guess() const {
    const auto at_start = [](const Function& value) { return value({}); };
    if (!heat_.films.empty()) return at_start(heat_.films.front().fluid);
    if (!heat_.temperatures.empty()) return at_start(heat_.temperatures.front().value);
    return heat_.radiation.empty() ? 0 : at_start(heat_.radiation.front().ambient);
  }

  std::vector<Vector3> some_places() const {
    std::vector<Vector3> result;
    for (std::size_t i = 0; i < course_places; ++i)
      result.push_back(whole_.nodes[i * (whole_.nodes.size() - 1) / (course_places - 1)]);
    return result;
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
      for (const Vector3& x : some_places()) {
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

  /// What steps must not pass.
  struct Stops {
    std::vector<double> kinks;  ///< with jumps: the integration starts again there
    std::vector<double> turns;  ///< ascending
    StepLimits limits;          ///< where functions vibrate
  };

  Stops find_stops(double end) const {
    Stops stops{config_.time.breakpoints, {}, {}};
    std::vector<StepLimit> limits;
    const double T = guess();
    for (const config::ConfiguredFunction& function : config::functions(config_)) {
      if (!function.acts_by_temperature_alone() || !function.value.depends_on_time() || !(end > 0)) continue;
      if (function.value.table_range("t")) {
        std::ranges::copy(function.value.breakpoints(end), std::back_inserter(stops.kinks));
        continue;
      }
      for (const Vector3& x : some_places()) {
        const CourseEvents events =
            find_events([&](double t) { return function.value({.x = x[0], .y = x[1], .z = x[2], .t = t, .T = T}); },
                        end, config_.time.cycle, {});
        for (const auto* found : {&events.jumps, &events.kinks})
          std::ranges::copy(*found, std::back_inserter(stops.kinks));
        if (events.vibrates || events.turns.size() > most_stops)
          std::ranges::copy(events.limits, std::back_inserter(limits));
        else
          for (const Turn& turn : events.turns) stops.turns.push_back(turn.time);
        if (!function.value.depends_on_position()) break;
      }
    }
    return {sorted(std::move(stops.kinks), end), sorted(std::move(stops.turns), end), StepLimits(limits)};
  }

  /// Those within the run, each once.
  static std::vector<double> sorted(std::vector<double> times, double end) {
    std::ranges::sort(times);
    std::vector<double> result;
    for (const double t : times)
      if (t > 0 && t < end && (result.empty() || t > result.back() * (1 + 1e-11))) result.push_back(t);
    return result;
  }

  /// See heat::HistoryOptions: at turns, and before what the guard of steps finds in functions of t.
  std::function<double(double, double, double, double)> end_of_step(const Stops& stops, double end) const {
    return [&stops, guard = StepGuard(heat_courses(config_, some_places(), guess()), end, heat_.tolerance)](
               double from, double to, double begin, double last) {
      if (const auto turn = std::ranges::upper_bound(stops.turns, from); turn != stops.turns.end())
        to = std::min(to, *turn);
      to = std::min(to, stops.limits.latest_end(from));
      for (std::size_t i = 0; i < guard.courses().size(); ++i)
        if (const auto found = guard.examine(i, from, to, {begin, last})) to = std::min(to, found->time);
      return to;
    };
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
        "({:.3g} MB)",
        problem.size(), low, high, history.n_steps, problem.n_factorizations(), history.times.size(), bytes / 1e6);
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
  heat::Definition all_;
  std::map<std::string, int> names_;  // how often given
};

}  // namespace

ComputedTemperature computed_temperature(const config::Config& config, const mesh::Mesh& whole,
                                         const BodyMeshes& meshes, const SharedNodes& shared, const ModelLinks& links) {
  return HeatProblem(config, whole, meshes, shared, links).solve();
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
