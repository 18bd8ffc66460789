#include "creepcontact/model/range_monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "creepcontact/base/log.hpp"
#include "creepcontact/config/configured.hpp"
#include "creepcontact/mechanics/point_extreme.hpp"

namespace creepcontact::model {
namespace {

using mechanics::point_extreme, mechanics::PointExtreme, mechanics::point_rounding;

constexpr double data_rounding = 1e-6;  // ranges of data are written with six digits

std::string name_of(const config::Material& material, std::size_t law) {
  return fmt::format("creep[{}] ({})", law, material.creep[law].law);
}

}  // namespace

RangeMonitor::RangeMonitor(const config::Config& config) {
  for (const config::ConfiguredFunction& function : config::functions(config))
    for (const config::Material& material : config.materials)
      if (const std::string table = fmt::format("materials.{}.", material.name); function.key.starts_with(table))
        if (const auto range = function.value.table_range("T"))
          tables_[material.name].push_back({function.key.substr(table.size()), *range});
  for (const config::Material& material : config.materials)
    for (std::size_t i = 0; i < material.creep.size(); ++i) {
      const config::CreepMechanism& mechanism = material.creep[i];
      const std::string what = name_of(material, i);
      if (mechanism.temperature_range) tables_[material.name].push_back({what, *mechanism.temperature_range, true});
      if (mechanism.stress_range) stresses_[material.name].push_back({what, *mechanism.stress_range});
    }
  for (const config::Material& material : config.materials)
    if (material.plasticity && !material.plasticity->curve.empty()) {
      double end = std::numeric_limits<double>::infinity();
      for (const config::PlasticCurve& curve : material.plasticity->curve)
        end = std::min(end, curve.plastic_strain.back());
      if (end > 0) curves_[material.name] = end;  // one point is a yield stress that does not harden
    }
  // A temperature from a file may change; the field itself will tell.
  changes_in_time_ =
      config.temperature && (!config.temperature->files.empty() || config.temperature->value.depends_on_time());
}

void RangeMonitor::observe(double t, const std::vector<mechanics::Body>& bodies, const creep::Equilibrium& at,
                           const Team& team) {
  if (!stresses_.empty())
    for (std::size_t b = 0; b < bodies.size(); ++b) observe_stress(bodies[b], at.bodies[b].stress, t, team);
  for (std::size_t b = 0; !curves_.empty() && b < at.plastic.bodies.size(); ++b)
    observe_flow(bodies[b], at.plastic.bodies[b], t, team);
  if (tables_.empty() || time_ == t || (time_ && !changes_in_time_)) return;
  time_ = t;
  for (std::size_t b = 0; b < bodies.size(); ++b) observe_temperature(bodies[b], at.conditions[b], team);
}

void RangeMonitor::observe_stress(const mechanics::Body& body, const std::vector<double>& stress, double t,
                                  const Team& team) {
  const auto found = stresses_.find(body.material().name);
  if (found == stresses_.end()) return;
  std::vector<double> q(stress.size() / 6);
  for (std::size_t p = 0; p < q.size(); ++p) q[p] = tensor::von_mises(tensor::view(stress, p));
  const PointExtreme largest = point_extreme(body, q, 1, team);
  for (StressRange& of : found->second) {
    of.largest = std::max(of.largest, largest[0]);
    if (of.exceeded || !(largest[0] > of.range.high * (1 + data_rounding))) continue;
    of.exceeded = true;
    log::warning(
        "material '{}': {}: the von Mises stress at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g}, is {:.6g}, outside the "
        "stress_range of the law ({:.6g} .. {:.6g}); the law is extrapolated",
        found->first, of.what, largest[1], largest[2], largest[3], t, largest[0], of.range.low, of.range.high);
  }
}

void RangeMonitor::observe_flow(const mechanics::Body& body, const creep::PlasticState& state, double t,
                                const Team& team) {
  const auto found = curves_.find(body.material().name);
  if (found == curves_.end()) return;
  const PointExtreme largest = point_extreme(body, state.accumulated, 1, team);
  if (!(largest[0] > found->second * (1 + data_rounding))) return;
  log::warning(
      "material '{}': plasticity.curve: the plastic strain at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g}, is {:.4g}, beyond "
      "the end of the table ({:.4g}); the yield stress stays at its last value",
      found->first, largest[1], largest[2], largest[3], t, largest[0], found->second);
  curves_.erase(found);
}

void RangeMonitor::finish() const {
  for (const auto& [material, ranges] : stresses_)
    for (const StressRange& of : ranges)
      if (of.largest < of.range.low * (1 - data_rounding))
        log::warning(
            "material '{}': {}: the largest von Mises stress was {:.6g}, below the stress_range of the law ({:.6g} .. "
            "{:.6g}); the law is extrapolated",
            material, of.what, of.largest, of.range.low, of.range.high);
}

std::vector<std::string> RangeMonitor::time_warnings(const config::Config& config) {
  std::vector<std::string> warnings;
  for (const config::Material& material : config.materials)
    for (std::size_t i = 0; i < material.creep.size(); ++i)
      if (const auto& range = material.creep[i].time_range;
          range && config.time.end > range->high * (1 + data_rounding))
        warnings.push_back(fmt::format(
            "material '{}': {}: the run ends at t = {:.6g}, {:.3g} times the end of the time_range of the law "
            "({:.6g} .. {:.6g}); the law is extrapolated",
            material.name, name_of(material, i), config.time.end, config.time.end / range->high, range->low,
            range->high));
  return warnings;
}

void RangeMonitor::observe_temperature(const mechanics::Body& body, const mechanics::BodyConditions& at,
                                       const Team& team) {
  const auto found = tables_.find(body.material().name);
  if (found == tables_.end()) return;
  const bool has_temperature = team.any(!at.temperature.empty());
  const double reference = body.material().reference_temperature;
  const PointExtreme hottest = has_temperature ? point_extreme(body, at.temperature, 1, team) : PointExtreme{reference};
  const PointExtreme coldest =
      has_temperature ? point_extreme(body, at.temperature, -1, team) : PointExtreme{reference};
  std::erase_if(found->second, [&](const Range& table) {
    const double margin = (table.of_law ? data_rounding : point_rounding) *
                          std::max(std::abs(table.range.low), std::abs(table.range.high));
    const bool above = hottest[0] > table.range.high + margin;
    if (!above && !(coldest[0] < table.range.low - margin)) return false;
    const PointExtreme& worst = above ? hottest : coldest;
    std::string where = "the reference temperature";
    if (has_temperature)
      where = fmt::format("the temperature at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g},", worst[1], worst[2], worst[3],
                          at.time);
    log::warning("material '{}': {}: {} is {:.6g}, outside {} ({:.6g} .. {:.6g}); {}", found->first, table.what, where,
                 worst[0], table.of_law ? "the temperature_range of the law" : "its table", table.range.low,
                 table.range.high, table.of_law ? "the law is extrapolated" : "the end value is used");
    return true;
  });
  if (found->second.empty()) tables_.erase(found);
}

}  // namespace creepcontact::model
