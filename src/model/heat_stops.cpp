#include "heat_stops.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "course_events.hpp"
#include "creepcontact/config/configured.hpp"
#include "repetition.hpp"

namespace creepcontact::model {
namespace {

constexpr std::size_t places_of_body = 5;
constexpr std::size_t most_turns_of_heat = 1000;  // of a function, at each of which a step ends
constexpr double same_stop = 1e-11;               // relative
constexpr double fewest_repeated = 3;             // periods, for which it is worth to know
constexpr double comparisons_of_heat = 5e6;
constexpr int fewest_phases_of_heat = 50;  // in each period

/// Those within the run, each once.
std::vector<double> stops_within(std::vector<double> times, double end) {
  std::ranges::sort(times);
  std::vector<double> result;
  for (const double t : times)
    if (t > 0 && t < end && (result.empty() || t > result.back() * (1 + same_stop))) result.push_back(t);
  return result;
}

/// @param longest  period of the tables; 0: none has one
std::optional<heat::Repeats> find_repeats(const std::vector<CoursesInTime>& all, std::optional<double> cycle,
                                          double longest, double end) {
  std::vector<Course> courses;
  for (const CoursesInTime& function : all) std::ranges::copy(function.at_places, std::back_inserter(courses));
  if (courses.empty()) return std::nullopt;
  double period = cycle.value_or(longest);
  if (!cycle)
    for (const Course& course : courses) period = std::max(period, find_period(course, end).value_or(0));
  if (!(period > 0)) return std::nullopt;
  heat::Repeats result{period, period};
  const double comparisons = comparisons_of_heat / static_cast<double>(courses.size());
  for (const Course& course : courses) {
    if (end - result.from < fewest_repeated * period) return std::nullopt;
    const std::optional<Repetition> found = Repetition::find(course, end, period, comparisons, fewest_phases_of_heat);
    if (!found) return std::nullopt;
    for (const Interval& other : found->different(end)) result.from = std::max(result.from, other.high);
  }
  if (end - result.from < fewest_repeated * period) return std::nullopt;
  return result;
}

}  // namespace

std::vector<Vector3> some_places(const mesh::Mesh& mesh) {
  std::vector<Vector3> result;
  for (std::size_t i = 0; i < places_of_body; ++i)
    result.push_back(mesh.nodes[i * (mesh.n_cell_nodes() - 1) / (places_of_body - 1)]);
  return result;
}

std::vector<Vector3> some_places(const BodyMeshes& meshes) {
  std::vector<Vector3> result;
  for (const mesh::Mesh& mesh : meshes) std::ranges::copy(some_places(mesh), std::back_inserter(result));
  return result;
}

HeatStops::HeatStops(const config::Config& config, const std::vector<Vector3>& places, double T, double end)
    : end_(end), guard_(heat_courses(config, places, T), end, config.heat->tolerance) {
  std::vector<double> kinks = config.time.breakpoints, turns;
  std::vector<StepLimit> limits;
  double longest_period = 0;
  for (const config::ConfiguredFunction& function : config::functions(config)) {
    if (!function.acts_by_temperature_alone() || !function.value.depends_on_time() || !(end > 0)) continue;
    if (function.value.table_range("t")) {
      std::ranges::copy(function.value.breakpoints(end), std::back_inserter(kinks));
      longest_period = std::max(longest_period, function.value.period().value_or(0));
      continue;
    }
    for (const Vector3& x : places) {
      const CourseEvents events =
          find_events([&](double t) { return function.value({.x = x[0], .y = x[1], .z = x[2], .t = t, .T = T}); }, end,
                      config.time.cycle, {});
      for (const auto* found : {&events.jumps, &events.kinks}) std::ranges::copy(*found, std::back_inserter(kinks));
      if (events.vibrates || events.turns.size() > most_turns_of_heat)
        std::ranges::copy(events.limits, std::back_inserter(limits));
      else
        for (const Turn& turn : events.turns) turns.push_back(turn.time);
      if (!function.value.depends_on_position()) break;
    }
  }
  kinks_ = stops_within(std::move(kinks), end);
  turns_ = stops_within(std::move(turns), end);
  limits_ = StepLimits(limits);
  repeats_ = find_repeats(guard_.courses(), config.time.cycle, longest_period, end);
}

std::vector<double> HeatStops::kinks_and_turns() const {
  std::vector<double> result = kinks_;
  std::ranges::copy(turns_, std::back_inserter(result));
  return stops_within(std::move(result), end_);
}

std::function<double(double, double, double, double)> HeatStops::end_of_step() const {
  return [this](double from, double to, double begin, double last) {
    if (const auto turn = std::ranges::upper_bound(turns_, from); turn != turns_.end()) to = std::min(to, *turn);
    to = std::min(to, limits_.latest_end(from));
    for (std::size_t i = 0; i < guard_.courses().size(); ++i)
      if (const std::optional<StepGuard::Finding> found = guard_.examine(i, from, to, {begin, last}))
        to = std::min(to, found->time);
    return to;
  };
}

}  // namespace creepcontact::model
