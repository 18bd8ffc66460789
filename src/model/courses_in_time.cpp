#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "creepcontact/model/step_guard.hpp"
#include "function_courses.hpp"
#include "places.hpp"

namespace creepcontact::model {
namespace {

constexpr std::size_t max_places = 1000;       // of a function: a step looks at three of them
constexpr std::size_t max_point_places = 100;  // where each needs its own weights of the points of a temperature field

}  // namespace

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
  return result;
}

}  // namespace creepcontact::model
