#include "cycle_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace creepcontact::run {
namespace {

constexpr double min_relative_stress = 1e-2;  // of the typical stress of the most stressed body
/// The last one that a body has says when its life ends.
constexpr std::array life_variables{&material::damage, &material::life_fraction, &material::fatigue_fraction,
                                    &material::creep_fatigue};

double largest_of(const Team& team, const std::vector<double>& values) {
  return team.max(values.empty() ? 0.0 : *std::ranges::max_element(values));
}

}  // namespace

CycleWatch::CycleWatch(creep::CreepSystem& system) : system_(system) {
  for (const creep::MaterialPoints& points : system.laws().points()) {
    life_.emplace_back();
    for (const material::StateVariable* variable : life_variables)
      if (points.has(*variable)) life_.back().push_back(variable);
  }
}

void CycleWatch::begin(StepView& view) {
  bodies_.assign(life_.size(), {});
  probes_.assign(view.probe_values().size(), {});
  first_.assign(view.y().begin(), view.y().end());
  observe(view);
}

void CycleWatch::observe_probes(std::span<const double> values) {
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    probes_[i].min = std::min(probes_[i].min, values[i]);
    probes_[i].max = std::max(probes_[i].max, values[i]);
    probes_[i].end = values[i];
  }
}

void CycleWatch::observe(StepView& view) {
  observe_probes(view.probe_values());
  const creep::Evaluation& at = view.evaluation();
  std::vector<mechanics::CreepStrainView> creep;
  system_.layout().views(view.y(), creep);
  const std::vector<double> typical = creep::ErrorScale::typical(system_.assembly(), at.equilibrium);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    observe_body(b, at, creep[b]);
    bodies_[b].typical_stress = std::max(bodies_[b].typical_stress, typical[b]);
  }
}

void CycleWatch::observe_body(std::size_t b, const creep::Evaluation& at, const mechanics::CreepStrainView& creep) {
  Body& body = bodies_[b];
  const std::vector<double>& stress = at.equilibrium.bodies[b].stress;
  const std::size_t n_points = stress.size() / 6;
  const mechanics::ElasticState elastic = at.equilibrium.conditions[b].elastic();
  std::vector<double>& strain = body.strain.emplace_back(stress.size());
  const std::vector<double> plastic = system_.laws().evaluate(material::plastic_strain, b, at, at.y);
  if (!creep.empty() || !plastic.empty()) body.inelastic.emplace_back(stress.size());
  for (std::size_t p = 0; p < n_points; ++p) {
    tensor::Map total = tensor::writable(strain, p);
    total = material::elastic_strain(elastic.at(p), tensor::view(stress, p));
    if (body.inelastic.empty()) continue;
    tensor::Map inelastic = tensor::writable(body.inelastic.back(), p);
    if (!creep.empty()) inelastic += creep.at(p);
    if (!plastic.empty()) inelastic += tensor::view(plastic, p);
    total += inelastic;
  }
  const double reference = system_.assembly().bodies()[b].material().reference_temperature;
  body.highest_temperature.resize(n_points, -std::numeric_limits<double>::infinity());
  const std::vector<double>& temperature = at.equilibrium.conditions[b].temperature;
  for (std::size_t p = 0; p < n_points; ++p)
    body.highest_temperature[p] =
        std::max(body.highest_temperature[p], temperature.empty() ? reference : temperature[p]);
  if (body.first_stress.empty()) body.first_stress = stress;
  body.last_stress = stress;
}

std::vector<double> CycleWatch::ranges(const States& states, std::size_t n_points) {
  std::vector<double> result(n_points, 0.0);
  for (std::size_t i = 0; i < states.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t p = 0; p < n_points; ++p)
        result[p] =
            std::max(result[p], tensor::equivalent_strain(tensor::view(states[i], p) - tensor::view(states[j], p)));
  return result;
}

bool CycleWatch::add_cycle(std::span<double> y) const {
  const Team& team = system_.team();
  bool counted = false;
  together(team, [&] {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const creep::MaterialPoints& points = system_.laws().points()[b];
      if (!points.counts_cycles()) continue;
      counted = true;
      const std::vector<double> range = ranges(bodies_[b].strain, points.size());
      std::vector<material::CycleRange> cycles;
      for (std::size_t p = 0; p < range.size(); ++p) cycles.push_back({range[p], bodies_[b].highest_temperature[p]});
      points.add_cycle(cycles, system_.layout().part(b, y));
    }
  });
  return team.any(counted);
}

double CycleWatch::stress_change() const {
  double largest = 0, change = 0;
  for (const Body& body : bodies_) largest = std::max(largest, body.typical_stress);
  for (const Body& body : bodies_)
    for (std::size_t p = 0; 6 * p < body.last_stress.size(); ++p)
      change =
          std::max(change, tensor::von_mises(tensor::view(body.last_stress, p) - tensor::view(body.first_stress, p)) /
                               std::max(body.typical_stress, min_relative_stress * largest));
  return system_.team().max(largest > 0 ? change : 0.0);
}

CycleRecord CycleWatch::record(std::span<const double> y, std::span<const double> end, std::int64_t number) const {
  const Team& team = system_.team();
  CycleRecord result;
  result.probes = probes_;
  result.stress_change = stress_change();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    CycleRecord::Body& body = result.bodies.emplace_back();
    const std::size_t n_points = bodies_[b].last_stress.size() / 6;
    body.strain_range = largest_of(team, ranges(bodies_[b].strain, n_points));
    body.inelastic_strain_range = largest_of(team, ranges(bodies_[b].inelastic, n_points));
    for (const material::StateVariable* variable : life_[b]) {
      const auto at = [&](std::span<const double> state) {
        return system_.laws().evaluate(*variable, b, system_.step_evaluation(), state);
      };
      const std::vector<double> before = at(first_), after = at(y), reached = at(end);
      std::vector<double> change(after.size());
      double left = std::numeric_limits<double>::infinity();
      for (std::size_t p = 0; p < after.size(); ++p) {
        change[p] = after[p] - before[p];
        if (change[p] > 0) left = std::min(left, (1 - reached[p]) / change[p]);
      }
      body.life.push_back({largest_of(team, reached), largest_of(team, change)});
      body.limit = static_cast<double>(number) + team.min(left);
    }
  }
  return result;
}

}  // namespace creepcontact::run
