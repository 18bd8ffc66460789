#include "creepcontact/results/probes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/model/error_collector.hpp"
#include "creepcontact/results/probe_expression.hpp"
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

namespace {

class ScaledProbe final : public Probe {
 public:
  ScaledProbe(std::unique_ptr<Probe> probe, double factor) : probe_(std::move(probe)), factor_(factor) {}
  double value(Snapshot& snapshot) const override { return factor_ * probe_->value(snapshot); }

 private:
  std::unique_ptr<Probe> probe_;
  double factor_;
};

std::unique_ptr<Probe> scaled(std::unique_ptr<Probe> probe, double factor) {
  if (factor == 1) return probe;
  return std::make_unique<ScaledProbe>(std::move(probe), factor);
}

std::unique_ptr<Probe> quantity_probe(const config::Probe& probe, const model::Model& model,
                                      std::span<const PointLocator> locators) {
  const ProbeRequest request{probe, quantity(probe.quantity), model, locators};
  if (request.quantity.variable->needs_heat && model.assembly.conduction() == nullptr)
    throw ModelError(fmt::format("'{}' is known only where [heat] computes the temperature", probe.quantity));
  return std::visit([&](const auto& support) { return make_probe(support, request); },
                    request.quantity.variable->support);
}

}  // namespace

std::vector<std::unique_ptr<Probe>> make_probes(const config::Config& config, const model::Model& model) {
  const std::vector<config::Probe>& probes = config.probes;
  std::vector<PointLocator> locators;
  if (std::ranges::any_of(probes, [](const config::Probe& probe) { return probe.at.has_value(); }))
    for (const mechanics::Body& body : model.bodies()) locators.emplace_back(body.mesh());
  std::vector<std::unique_ptr<Probe>> result(probes.size());
  model::ErrorCollector errors;
  for (std::size_t i = 0; i < probes.size(); ++i)
    if (!probes[i].expression.given())
      errors.collect(probes[i].location,
                     [&] { result[i] = scaled(quantity_probe(probes[i], model, locators), probes[i].scale); });
  errors.raise();
  // In an order in which those that an expression names exist; reading has checked that there is one.
  const std::function<void(std::size_t)> make = [&](std::size_t i) {
    if (result[i]) return;
    for (const std::size_t other : ProbeExpression::used(probes[i].expression.name, probes)) make(other);
    result[i] = scaled(expression_probe(probes[i], probes, result), probes[i].scale);
  };
  for (std::size_t i = 0; i < probes.size(); ++i) make(i);
  return result;
}

std::vector<double> probe_values(std::span<const std::unique_ptr<Probe>> probes, Snapshot& snapshot) {
  std::vector<double> values;
  for (const auto& probe : probes) values.push_back(snapshot.value(*probe));
  return values;
}

}  // namespace creepcontact::results
