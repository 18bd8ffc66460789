#include "creepcontact/results/probe_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "creepcontact/base/units.hpp"
#include "creepcontact/results/quantities.hpp"

namespace creepcontact::results {
namespace {

using Course = io::SummaryProbe::Course;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::string region_of(const config::Probe& probe) {
  return probe.on.given() ? "surface" : "body";
}

/// The unit as a word of the configuration; empty if it does not follow from them.
std::string unit_of_values(const config::Probe& probe, const OutputVariable& variable, const std::string& units) {
  if (probe.scale != 1) return "";
  const bool is_integral = probe.reduce == config::Reduce::sum && !variable.is_sum() && !variable.is<OnCrossSection>();
  if (!is_integral) return unit_of(variable.dimension, units);
  return variable.dimension == Dimension::stress && probe.on.given() ? unit_of(Dimension::force, units) : "";
}

io::SummaryProbe described(const config::Probe& probe, const std::string& units) {
  io::SummaryProbe result;
  if (probe.expression.given()) {
    result.label = probe.name;
    result.expression = probe.expression.name;
    result.unit = probe.unit.value_or("");
    return result;
  }
  const OutputVariable& variable = *quantity(probe.quantity).variable;
  result.quantity = probe.quantity;
  result.label = variable.label;
  result.dimension = variable.dimension;
  if (probe.reduce == config::Reduce::sum) result.integrated_over = region_of(probe);
  result.unit = probe.unit.value_or(unit_of_values(probe, variable, units));
  return result;
}

/// @param margin  by which a value must go beyond the extremes to be one
void widen(Course& course, double time, double value, double margin) {
  if (!(course.min - margin <= value)) {
    course.min = value;
    course.t_min = time;
  }
  if (!(course.max + margin >= value)) {
    course.max = value;
    course.t_max = time;
  }
}

}  // namespace

std::string ProbeRecord::unit_of(const config::Probe& probe, const std::string& units) {
  return described(probe, units).unit.value_or("");
}

void ProbeRecord::output(double time, std::span<const double> values) {
  for (std::size_t i = 0; i < courses_.size(); ++i) {
    const double value = values[i];
    if (!courses_[i])
      courses_[i] = Course{.start = value, .end = value, .min = unknown, .max = unknown, .t_min = time, .t_max = time};
    Course& course = *courses_[i];
    course.end = value;
    if (std::isfinite(value)) widen(course, time, value, 0);
  }
}

void ProbeRecord::observe(double time, std::span<const double> values, double tolerance) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!courses_[i] || !std::isfinite(values[i])) continue;
    Course& course = *courses_[i];
    const double known = std::isnan(course.min) ? 0 : std::max(std::abs(course.min), std::abs(course.max));
    widen(course, time, values[i], tolerance * std::max(known, std::abs(values[i])));
  }
}

void ProbeRecord::fill(const config::Config& config, io::Summary& summary) const {
  for (std::size_t i = 0; i < config.probes.size(); ++i) {
    io::SummaryProbe& probe = summary.probes[config.probes[i].name];
    probe = described(config.probes[i], config.units);
    probe.course = courses_[i];
  }
}

void ProbeRecord::save(creep::Memory& memory) const {
  memory.save("probes.courses", courses_);
}

void ProbeRecord::restore(const creep::Memory& memory) {
  std::vector<std::optional<Course>> courses;
  memory.restore("probes.courses", courses);
  if (courses.size() == courses_.size()) courses_ = std::move(courses);
}

}  // namespace creepcontact::results
