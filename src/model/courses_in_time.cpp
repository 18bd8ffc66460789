#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>

#include "creepcontact/model/step_guard.hpp"
#include "function_courses.hpp"
#include "heat_stops.hpp"
#include "places.hpp"

namespace creepcontact::model {
namespace {

constexpr std::size_t max_places = 1000;       // of a function: a step looks at three of them
constexpr std::size_t max_point_places = 100;  // where each needs its own weights of the points of a temperature field

}  // namespace

std::vector<CoursesInTime> heat_courses(const config::Config& config, const std::vector<Vector3>& places, double T) {
  std::vector<CoursesInTime> result;
  for (const config::ConfiguredFunction& function : config::functions(config)) {
    if (!function.acts_by_temperature_alone() || !function.value.depends_on_time()) continue;
    CoursesInTime& made = result.emplace_back(CoursesInTime{.key = function.key, .at_places = {}});
    for (const Vector3& x : places) {
      made.at_places.emplace_back([value = function.value, x, T](double t) {
        return value({.x = x[0], .y = x[1], .z = x[2], .t = t, .T = T});
      });
      if (!function.value.depends_on_position()) break;
    }
  }
  return result;
}

std::vector<CoursesInTime> courses_in_time(const config::Config& config, const Model& model) {
  KeyPlaces key_places(config, model.bodies());
  std::vector<CoursesInTime> result;
  for (const config::ConfiguredFunction& function : config::functions(config)) {
    if (function.acts_by_temperature_alone()) continue;
    const FunctionCourses courses(function, config, model.bodies(), model.temperature);
    if (!courses.changes_in_time()) continue;
    const std::shared_ptr<const Places> places = key_places.of(function.key);
    if (places->empty()) continue;
    CoursesInTime& made = result.emplace_back(CoursesInTime{.key = function.key, .at_places = {}});
    const std::size_t n_levels = courses.levels(places->front()).size();
    const std::size_t most = courses.needs_point_temperatures() ? max_point_places : max_places;
    const std::size_t n = courses.depends_on_place() ? std::max(n_levels, std::min(places->size(), most)) : n_levels;
    for (std::size_t i = 0; i < n; ++i) {
      const Place& place = (*places)[i * places->size() / n];
      made.at_places.push_back(courses.at(place, courses.levels(place)[i % n_levels]));
    }
  }
  if (config.has_coupled_heat()) {
    std::vector<Vector3> places;
    for (const mechanics::Body& body : model.bodies())
      std::ranges::copy(some_places(body.mesh()), std::back_inserter(places));
    const std::vector<double>& start = model.assembly.heat()->start;
    std::ranges::move(heat_courses(config, places, start.empty() ? 0 : start.front()), std::back_inserter(result));
  }
  return result;
}

}  // namespace creepcontact::model
