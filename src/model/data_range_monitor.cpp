#include "creepcontact/model/data_range_monitor.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "creepcontact/base/log.hpp"
#include "creepcontact/base/tensor.hpp"
#include "point_extreme.hpp"

namespace creepcontact::model {
namespace {

constexpr double data_margin = 1e-6;  // relative, of the ends of the tests

bool is_above(double value, const std::vector<double>& range) {
  return value > range.back() + data_margin * std::abs(range.back());
}
bool is_below(double value, const std::vector<double>& range) {
  return value < range.front() - data_margin * std::abs(range.front());
}

}  // namespace

DataRangeMonitor::DataRangeMonitor(const config::Config& config) {
  for (const config::Material& material : config.materials)
    if (material.data_range) ranges_[material.name] = *material.data_range;
}

void DataRangeMonitor::observe(const std::vector<mechanics::Body>& bodies, const creep::Equilibrium& at, const Team& team) {
  if (ranges_.empty()) return;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto found = ranges_.find(bodies[b].material().name);
    if (found == ranges_.end()) continue;
    config::DataRange& range = found->second;
    // A range that has been left is emptied: one warning each.
    if (!range.stress.empty() && observe_stress(bodies[b], range.stress, at.time, at.bodies[b].stress, team))
      range.stress.clear();
    if (!range.temperature.empty() &&
        observe_temperature(bodies[b], range.temperature, at.time, at.conditions[b].temperature, team))
      range.temperature.clear();
  }
}

bool DataRangeMonitor::observe_stress(const mechanics::Body& body, const std::vector<double>& range, double t,
                                  const std::vector<double>& stress, const Team& team) {
  std::vector<double> equivalent(stress.size() / 6);
  for (std::size_t p = 0; p < equivalent.size(); ++p)
    equivalent[p] = tensor::von_mises(Tensor6(tensor::view(stress, p)));
  const PointExtreme largest = point_extreme(body, equivalent, 1, team);
  const bool above = is_above(largest[0], range);
  if (!above && !(largest[0] > 0 && is_below(largest[0], range))) return false;
  log::warning(
      "body '{}': the largest von Mises stress, {:.4g} at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g}, is {} the tests of "
      "material '{}' (data_range.stress: {:.4g} .. {:.4g}); the creep law is extrapolated",
      body.name(), largest[0], largest[1], largest[2], largest[3], t, above ? "above" : "below", body.material().name,
      range.front(), range.back());
  return true;
}

bool DataRangeMonitor::observe_temperature(const mechanics::Body& body, const std::vector<double>& range, double t,
                                       const std::vector<double>& temperature, const Team& team) {
  const bool has_temperature = team.any(!temperature.empty());
  const double reference = body.material().reference_temperature;
  for (const int sign : {1, -1}) {
    const PointExtreme worst = has_temperature ? point_extreme(body, temperature, sign, team) : PointExtreme{reference};
    if (!(sign > 0 ? is_above(worst[0], range) : is_below(worst[0], range))) continue;
    const std::string place =
        has_temperature ? fmt::format(" at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g},", worst[1], worst[2], worst[3], t)
                        : " (the reference temperature)";
    log::warning(
        "body '{}': the temperature {:.6g}{} is {} the tests of material '{}' (data_range.temperature: {:.6g} .. "
        "{:.6g}); "
        "the creep law is extrapolated",
        body.name(), worst[0], place, sign > 0 ? "above" : "below", body.material().name, range.front(), range.back());
    return true;
  }
  return false;
}

std::vector<std::string> DataRangeMonitor::time_warnings(const config::Config& config) {
  std::vector<std::string> warnings;
  for (const config::Material& material : config.materials)
    if (material.data_range && !material.data_range->time.empty() &&
        is_above(config.time.end, material.data_range->time))
      warnings.push_back(
          fmt::format("material '{}': the run ends at t = {:.6g}, {:.3g} times the longest of its tests "
                      "(data_range.time: {:.6g} .. "
                      "{:.6g}); the creep law is extrapolated",
                      material.name, config.time.end, config.time.end / material.data_range->time.back(),
                      material.data_range->time.front(), material.data_range->time.back()));
  return warnings;
}

}  // namespace creepcontact::model
