#include "function_courses.hpp"

#include <algorithm>
#include <array>
#include <memory>

namespace creepcontact::model {
namespace {

/// Stress over Young's modulus: what machine parts carry lies between; the middle comes first.
constexpr std::array<double, 7> elastic_strains{1e-3, 1e-6, 1e-5, 1e-4, 3e-4, 3e-3, 1e-2};
constexpr std::array<double, 3> creep_strains{1e-3, 1e-5, 1e-1};

Arguments arguments(const Place& place, const Level& level) {
  const Vector3& x = place.position;
  return {.x = x[0], .y = x[1], .z = x[2], .q = level.q, .eps = level.eps};
}

}  // namespace

bool FunctionCourses::temperature_changes() const {
  return function_.value.depends_on_temperature() && temperature_ && temperature_->depends_on_time();
}

bool FunctionCourses::changes_in_time() const {
  return function_.value.depends_on_time() || temperature_changes();
}

bool FunctionCourses::depends_on_place() const {
  if (function_.value.depends_on_position()) return true;
  return function_.value.depends_on_temperature() && temperature_ && temperature_->depends_on_position();
}

bool FunctionCourses::needs_point_temperatures() const {
  return function_.value.depends_on_temperature() && temperature_ && !config_.has_temperature_function();
}

std::vector<Level> FunctionCourses::levels(const Place& place) const {
  const material::Material& material = bodies_[place.body].material();
  const double E = material.young_modulus({.T = material.reference_temperature});
  std::vector<Level> result{{elastic_strains.front() * E, creep_strains.front()}};
  if (function_.may_depend_on("q"))
    for (std::size_t i = 1; i < elastic_strains.size(); ++i)
      result.push_back({elastic_strains[i] * E, creep_strains.front()});
  if (function_.value.depends_on_strain())
    for (std::size_t i = 1; i < creep_strains.size(); ++i)
      result.push_back({elastic_strains.front() * E, creep_strains[i]});
  return result;
}

Course FunctionCourses::temperature(const Place& place) const {
  const double reference = bodies_[place.body].material().reference_temperature;
  if (!temperature_) return [reference](double) { return reference; };
  if (config_.has_temperature_function()) {
    const Arguments at = arguments(place, {});
    return [at, value = config_.temperature->value](double t) {
      Arguments now = at;
      now.t = t;
      return value(now);
    };
  }
  // Weights of the points around the place are found once, not at each time.
  const mechanics::TemperatureField& on_body = temperature_->on(bodies_[place.body].mesh());
  const std::shared_ptr<const mechanics::TemperatureAtPositions> field = on_body.at({&place.position, 1});
  return [field, memo = std::make_shared<mechanics::TemperatureMemo>()](double t) {
    double value = 0;
    field->evaluate(t, {&value, 1}, *memo);
    return value;
  };
}

Course FunctionCourses::at(const Place& place, const Level& level) const {
  Arguments at = arguments(place, level);
  const Function value = function_.value;
  if (!value.depends_on_temperature())
    return [at, value](double t) {
      Arguments now = at;
      now.t = t;
      return value(now);
    };
  return [at, value, T = temperature(place)](double t) {
    Arguments now = at;
    now.t = t;
    now.T = T(t);
    return value(now);
  };
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): std::function frees what it holds

double FunctionCourses::at_temperature(const Place& place, const Level& level, double T) const {
  Arguments at = arguments(place, level);
  at.T = T;
  return function_.value(at);
}

}  // namespace creepcontact::model
