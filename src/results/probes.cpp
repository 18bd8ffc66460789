#include "creepcontact/results/probes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "creepcontact/model/error_collector.hpp"
#include "probe_kinds.hpp"

namespace creepcontact::results {

void Reduction::add(double value, double weight) {
  sum_ += weight * value;
  weight_ += weight;
  max_ = std::max(max_, value);
  min_ = std::min(min_, value);
}

double Reduction::result(const Team& team) const {
  switch (kind_) {
    case config::Reduce::mean: {
      const double sum = team.sum(sum_), weight = team.sum(weight_);
      return weight > 0 ? sum / weight : 0;
    }
    case config::Reduce::max:
      return team.max(max_);
    case config::Reduce::min:
      return team.min(min_);
    case config::Reduce::sum:
      return team.sum(sum_);
  }
  return 0;
}

std::vector<std::size_t> probe_bodies(const config::Probe& probe, const model::Model& model) {
  std::vector<std::size_t> bodies = model::bodies_with(model.bodies(), probe.on.name);
  if (bodies.empty()) {
    std::string names;
    for (const mechanics::Body& body : model.bodies())
      for (const auto& [name, group] : body.mesh().groups)
        if (group.dimension < body.mesh().section.dimension() && names.find("'" + name + "'") == std::string::npos)
          names += (names.empty() ? "'" : ", '") + name + "'";
    throw ModelError(fmt::format("no body has a group '{}'; there are {}", probe.on.name, names));
  }
  if (!probe.body.given()) return bodies;
  const std::size_t wanted = model::find_body(model.bodies(), probe.body.name);
  if (std::find(bodies.begin(), bodies.end(), wanted) == bodies.end())
    throw ModelError(fmt::format("group '{}' is not on body '{}'", probe.on.name, probe.body.name));
  return {wanted};
}

std::vector<std::unique_ptr<Probe>> make_probes(const config::Config& config, const model::Model& model) {
  std::vector<PointLocator> locators;
  if (std::ranges::any_of(config.probes, [](const config::Probe& probe) { return probe.at.has_value(); }))
    for (const mechanics::Body& body : model.bodies()) locators.emplace_back(body.mesh());
  std::vector<std::unique_ptr<Probe>> result;
  model::ErrorCollector errors;
  for (const config::Probe& probe : config.probes)
    errors.collect(probe.location, [&] {
      using Location = OutputVariable::Location;
      const OutputVariable& variable = *quantity(probe.quantity).variable;
      const Location location = variable.location;
      if (variable.is_axial())
        result.push_back(axial_probe(probe, model));
      else if (location == Location::reaction)
        result.push_back(reaction_probe(probe, model));
      else if (location != Location::field)
        result.push_back(contact_probe(probe, model));
      else if (probe.at)
        result.push_back(point_probe(probe, model, locators));
      else if (probe.on.given())
        result.push_back(group_probe(probe, model));
      else
        result.push_back(body_probe(probe, model));
    });
  errors.raise();
  return result;
}

}  // namespace creepcontact::results
