#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/material/registry.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {
namespace {

contact::GasketCurve curve_of(const config::GasketCurve& from) {
  return {from.closure, from.pressure};
}

contact::GasketUnloading unloading_of(const config::GasketUnloading& from) {
  contact::GasketUnloading result{from.from, from.modulus, {}};
  for (const config::GasketCurve& curve : from.curves) result.curves.push_back(curve_of(curve));
  return result;
}

contact::GasketLaw law_of(const config::Gasket& from) {
  std::vector<contact::GasketData> data;
  for (const config::GasketCurve& loading : from.loading) {
    const auto found = from.unloading.size() == 1
                           ? from.unloading.begin()
                           : std::ranges::find(from.unloading, loading.T, &config::GasketUnloading::T);
    data.push_back({loading.T.value_or(0), curve_of(loading),
                    found != from.unloading.end() ? unloading_of(*found) : contact::GasketUnloading()});
  }
  return {from.thickness, std::move(data)};
}

/// Norton's law of the strain closure/thickness with which the pressure falls as in the test, in series with the rig
/// and with the unloading gasket: dc/dt = a p^n, a = (P^(1-n) - 1) p0^(1-n) / ((n - 1) k t), 1/k = area/stiffness +
/// 1/slope.
std::shared_ptr<const material::CreepLaw> relaxation_law(const config::GasketRelaxation& test,
                                                         const contact::GasketLaw& law, double reference) {
  const double temperature = test.T.value_or(reference);
  const contact::ClosureCurve loading = law.curve(0, temperature);
  if (const double last = loading.pressure(law.last_closure()); test.pressure > last)
    throw std::invalid_argument(
        fmt::format("relaxation: the pressure of the test, {:.6g}, is beyond the loading curve, "
                    "which ends at {:.6g}",
                    test.pressure, last));
  const double largest = loading.closure(test.pressure);
  const double slope = law.curve(largest, temperature).line(largest).slope;
  const double k = 1 / (test.area / test.stiffness + 1 / slope);
  const double n = test.n;
  const double a =
      n == 1 ? -std::log(test.factor) / (k * test.time)
             : (std::pow(test.factor, 1 - n) - 1) * std::pow(test.pressure, 1 - n) / ((n - 1) * k * test.time);
  return material::find_creep_law("norton")->make_by_key(
      {{"A", {Function(a / law.thickness())}}, {"n", {Function(n)}}});
}

}  // namespace

void warn_of_gaskets(const config::Config& config, const Bodies& bodies) {
  // Relative to the largest modulus of the bodies: soft rubber on steel, and the metal itself. Beyond them units are
  // mixed.
  constexpr double softest = 1e-7, stiffest = 10;
  double modulus = 0;
  for (const mechanics::Body& body : bodies)
    modulus = std::max(modulus, body.material().young_modulus({.T = body.material().reference_temperature}));
  for (const config::Gasket& gasket : config.gaskets) {
    const std::vector<double>&closure = gasket.loading.front().closure, &pressure = gasket.loading.front().pressure;
    const double own = gasket.thickness * (pressure.back() - pressure.front()) / (closure.back() - closure.front());
    if (std::isfinite(modulus) && (own > stiffest * modulus || own < softest * modulus))
      log::warning(
          "gasket '{}': pressure over closure/thickness is about {:.3g}, and Young's modulus of the bodies up to "
          "{:.3g}; check that both are in the units of the model",
          gasket.name, own, modulus);
    double longest = gasket.relaxation ? gasket.relaxation->time : std::numeric_limits<double>::infinity();
    for (const config::CreepMechanism& mechanism : gasket.creep)
      if (mechanism.time_range) longest = std::min(longest, mechanism.time_range->high);
    if (config.time.end > longest)
      log::warning(
          "gasket '{}': its creep comes from data of up to t = {:.6g}, and the run ends at {:.6g}; how it goes on "
          "decides "
          "how much of the force is left: compare laws that agree with the data",
          gasket.name, longest, config.time.end);
  }
}

std::shared_ptr<const material::Material> creep_alone(const std::string& name,
                                                      std::vector<std::shared_ptr<const material::CreepLaw>> laws,
                                                      double reference_temperature) {
  if (laws.empty()) return nullptr;
  material::Material material;
  material.name = name;
  material.reference_temperature = reference_temperature;
  material.creep = std::move(laws);
  return std::make_shared<const material::Material>(std::move(material));
}

std::shared_ptr<const contact::GasketKind> make_gasket(const config::Gasket& from) {
  try {
    const double reference = from.reference_temperature.value_or(0);
    contact::GasketKind kind{from.name, law_of(from), from.thermal_expansion, reference};
    std::vector<std::shared_ptr<const material::CreepLaw>> laws = make_creep_laws(from.creep);
    if (from.relaxation) laws.push_back(relaxation_law(*from.relaxation, kind.law, reference));
    kind.creep = creep_alone("gasket " + from.name, std::move(laws), reference);
    return std::make_shared<const contact::GasketKind>(std::move(kind));
  } catch (const std::invalid_argument& error) {
    throw ModelError(fmt::format("gasket '{}': {}", from.name, error.what()));
  }
}

}  // namespace creepcontact::model
