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

std::string name_of(const std::vector<config::CreepMechanism>& creep, std::size_t law) {
  return fmt::format("creep[{}] ({})", law, creep[law].law);
}

std::string owner(const char* kind, const std::string& name) {
  return fmt::format("{} '{}'", kind, name);
}
std::string owner_of(const mechanics::Body& body) {
  return owner("material", body.material().name);
}

/// What has creep laws and tables.
struct Owner {
  std::string name;  ///< for messages
  std::string keys;  ///< of its table begin with this
  const std::vector<config::CreepMechanism>& creep;
};

std::vector<Owner> owners(const config::Config& config) {
  std::vector<Owner> result;
  for (const config::Material& material : config.materials)
    result.push_back({owner("material", material.name), fmt::format("materials.{}.", material.name), material.creep});
  for (const config::Gasket& gasket : config.gaskets)
    result.push_back({owner("gasket", gasket.name), fmt::format("gaskets.{}.", gasket.name), gasket.creep});
  for (std::size_t i = 0; i < config.springs.size(); ++i)
    result.push_back(
        {owner("spring", config.springs[i].name), fmt::format("springs[{}].", i), config.springs[i].creep});
  return result;
}

/// The largest or smallest value at the nodes of a pair, and its place.
PointExtreme extreme_of(const contact::Pair& pair, const std::vector<double>& values, int sign) {
  const auto found =
      std::ranges::max_element(values, {}, [=](double value) { return static_cast<double>(sign) * value; });
  const Vector3& x = pair.gasket->positions()[static_cast<std::size_t>(found - values.begin())];
  return {*found, x[0], x[1], x[2]};
}

}  // namespace

RangeMonitor::RangeMonitor(const config::Config& config)
    : temperature_error_(config.heat ? config.heat->tolerance : 0) {
  const std::vector<config::ConfiguredFunction> functions = config::functions(config);
  for (const Owner& owner : owners(config)) {
    for (const config::ConfiguredFunction& function : functions)
      if (function.key.starts_with(owner.keys))
        if (const auto range = function.value.table_range("T"))
          tables_[owner.name].push_back({function.key.substr(owner.keys.size()), *range});
    for (std::size_t i = 0; i < owner.creep.size(); ++i) {
      const config::CreepMechanism& mechanism = owner.creep[i];
      const std::string what = name_of(owner.creep, i);
      if (mechanism.temperature_range) tables_[owner.name].push_back({what, *mechanism.temperature_range, true});
      if (mechanism.stress_range) stresses_[owner.name].push_back({what, *mechanism.stress_range});
    }
  }
  for (const config::Gasket& gasket : config.gaskets)
    if (gasket.loading.size() > 1)
      tables_[owner("gasket", gasket.name)].push_back(
          {"loading", {*gasket.loading.front().T, *gasket.loading.back().T}});
  for (const config::Material& material : config.materials)
    if (material.plasticity && !material.plasticity->curve.empty()) {
      double end = std::numeric_limits<double>::infinity();
      for (const config::PlasticCurve& curve : material.plasticity->curve)
        end = std::min(end, curve.plastic_strain.back());
      if (end > 0) curves_[owner("material", material.name)] = end;  // one point is a yield stress that does not harden
    }
  // A temperature from a file may change; the field itself will tell.
  changes_in_time_ =
      config.heat ||
      (config.temperature && (!config.temperature->files.empty() || config.temperature->value.depends_on_time()));
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

void RangeMonitor::observe(const std::vector<contact::Pair>& pairs, const creep::Equilibrium& at) {
  if (stresses_.empty() && tables_.empty()) return;
  for (const contact::Pair& pair : pairs) {
    if (!pair.gasket || pair.coupling.nodes.empty()) continue;
    const contact::GasketKind& kind = pair.gasket->kind();
    const std::string of = owner(kind.is_spring ? "spring" : "gasket", kind.name);
    if (stresses_.contains(of)) {
      const auto multiplier = at.contact.multiplier.segment(pair.first_row, pair.coupling.n_rows());
      std::vector<double> stress;
      for (std::size_t node = 0; node < pair.coupling.nodes.size(); ++node)
        stress.push_back(kind.stress_per_pressure * pair.coupling.pressure(node, multiplier));
      check_stress(of, kind.is_spring ? "force" : "pressure", extreme_of(pair, stress, 1), at.time);
    }
    if (tables_.contains(of)) {
      const std::vector<double> temperatures = pair.gasket->temperatures(at.time);
      check_temperature(of, extreme_of(pair, temperatures, 1), extreme_of(pair, temperatures, -1), at.time, true);
    }
  }
}

void RangeMonitor::observe_stress(const mechanics::Body& body, const std::vector<double>& stress, double t,
                                  const Team& team) {
  const std::string owner = owner_of(body);
  if (!stresses_.contains(owner)) return;
  std::vector<double> q(stress.size() / 6);
  for (std::size_t p = 0; p < q.size(); ++p) q[p] = tensor::von_mises(tensor::view(stress, p));
  check_stress(owner, "von Mises stress", point_extreme(body, q, 1, team), t);
}

void RangeMonitor::check_stress(const std::string& owner, const char* name, const PointExtreme& largest, double t) {
  for (StressRange& of : stresses_.at(owner)) {
    of.name = name;
    of.largest = std::max(of.largest, largest[0]);
    if (of.exceeded || !(largest[0] > of.range.high * (1 + data_rounding))) continue;
    of.exceeded = true;
    log::warning(
        "{}: {}: the {} at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g}, is {:.6g}, outside the stress_range of the law "
        "({:.6g} .. {:.6g}); the law is extrapolated",
        owner, of.what, name, largest[1], largest[2], largest[3], t, largest[0], of.range.low, of.range.high);
  }
}

void RangeMonitor::observe_flow(const mechanics::Body& body, const creep::PlasticState& state, double t,
                                const Team& team) {
  const auto found = curves_.find(owner_of(body));
  if (found == curves_.end()) return;
  const PointExtreme largest = point_extreme(body, state.accumulated, 1, team);
  if (!(largest[0] > found->second * (1 + data_rounding))) return;
  log::warning(
      "{}: plasticity.curve: the plastic strain at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g}, is {:.4g}, beyond "
      "the end of the table ({:.4g}); the yield stress stays at its last value",
      found->first, largest[1], largest[2], largest[3], t, largest[0], found->second);
  curves_.erase(found);
}

void RangeMonitor::finish() const {
  for (const auto& [owner, ranges] : stresses_)
    for (const StressRange& of : ranges)
      if (of.largest < of.range.low * (1 - data_rounding))
        log::warning(
            "{}: {}: the largest {} was {:.6g}, below the stress_range of the law ({:.6g} .. {:.6g}); the law is "
            "extrapolated",
            owner, of.what, of.name, of.largest, of.range.low, of.range.high);
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
            material.name, name_of(material.creep, i), config.time.end, config.time.end / range->high, range->low,
            range->high));
  return warnings;
}

void RangeMonitor::observe_temperature(const mechanics::Body& body, const mechanics::BodyConditions& at,
                                       const Team& team) {
  const std::string owner = owner_of(body);
  if (!tables_.contains(owner)) return;
  const bool has_temperature = team.any(!at.temperature.empty());
  const PointExtreme reference{body.material().reference_temperature};
  check_temperature(owner, has_temperature ? point_extreme(body, at.temperature, 1, team) : reference,
                    has_temperature ? point_extreme(body, at.temperature, -1, team) : reference, at.time,
                    has_temperature);
}

void RangeMonitor::check_temperature(const std::string& owner, const PointExtreme& hottest, const PointExtreme& coldest,
                                     double t, bool has_temperature) {
  const auto found = tables_.find(owner);
  std::erase_if(found->second, [&](const Range& table) {
    const double margin = (table.of_law ? data_rounding : point_rounding) *
                              std::max(std::abs(table.range.low), std::abs(table.range.high)) +
                          temperature_error_ * (table.range.high - table.range.low);
    const bool above = hottest[0] > table.range.high + margin;
    if (!above && !(coldest[0] < table.range.low - margin)) return false;
    const PointExtreme& worst = above ? hottest : coldest;
    std::string where = "the reference temperature";
    if (has_temperature)
      where = fmt::format("the temperature at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g},", worst[1], worst[2], worst[3], t);
    log::warning("{}: {}: {} is {:.6g}, outside {} ({:.6g} .. {:.6g}); {}", owner, table.what, where, worst[0],
                 table.of_law ? "the temperature_range of the law" : "its table", table.range.low, table.range.high,
                 table.of_law ? "the law is extrapolated" : "the end value is used");
    return true;
  });
  if (found->second.empty()) tables_.erase(found);
}

}  // namespace creepcontact::model
