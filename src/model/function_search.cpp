#include "function_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "creepcontact/base/log.hpp"
#include "function_courses.hpp"
#include "screening.hpp"
#include "temperature_passages.hpp"
#include "vibration_turns.hpp"

namespace creepcontact::model {
namespace {

constexpr std::size_t spread_places = 12, further_places = 20, point_temperature_places = 8;
constexpr double all_screening = 3e6, most_screening = 1e6;  // evaluations of all functions, of one
constexpr double place_turn_evaluations = 2e5, place_comparisons = 3e4;
constexpr int place_phases = 11;
constexpr int level_samples = 4093;
constexpr double most_steps = 5e6;  // that bounds on steps may ask for

class FunctionSearch {
 public:
  FunctionSearch(const config::Config& config, const Bodies& bodies,
                 const std::optional<mechanics::TemperatureField>& temperature)
      : config_(config),
        bodies_(bodies),
        temperature_(temperature),
        functions_(config::functions(config)),
        key_places_(config, bodies) {
    std::erase_if(functions_, &config::ConfiguredFunction::acts_by_temperature_alone);
    for (const config::ConfiguredFunction& function : functions_) {
      const FunctionCourses courses(function, config, bodies, temperature);
      n_of_place_ += courses.changes_in_time() && courses.depends_on_place() ? 1 : 0;
    }
  }

  std::vector<SearchedFunction> run() {
    // The temperature first: others depend on it.
    for (const bool is_temperature : {true, false}) {
      for (const config::ConfiguredFunction& function : functions_)
        if (function.key.starts_with("temperature.") == is_temperature) search(function);
      if (is_temperature) {
        add_temperature_of_points();
        find_pieces();
      }
    }
    return std::move(found_);
  }

 private:
  void search(const config::ConfiguredFunction& function) {
    const FunctionCourses courses(function, config_, bodies_, temperature_);
    if (!courses.changes_in_time()) return;
    const std::shared_ptr<const Places> places = key_places_.of(function.key);
    if (places->empty()) return;  // of a material that no body has
    if (!searched_.insert({function.value.text(), places.get(), function.may_depend_on("q")}).second) return;
    SearchedFunction result{function.key, {}, {}, {}};
    if (function.value.table_range("t") || function.value.table_range("T"))
      add_places_of_table(courses, *places, result);
    else
      search(courses, *places, result);
    if (function.value.depends_on_temperature() && temperature_ && temperature_->depends_on_time()) {
      TemperaturePassages found = temperature_passages(courses, *places, pieces_);
      warn_of_missing(function, found);
      result.passages = std::move(found.times);
    }
    tell(function, result);
    found_.push_back(std::move(result));
  }

  /// A table knows its points; its courses serve to compare cycles.
  void add_places_of_table(const FunctionCourses& courses, const Places& places, SearchedFunction& result) const {
    const std::size_t n = courses.depends_on_place() ? point_temperature_places : 1;
    for (const std::size_t i : spread(places, n)) {
      result.courses.push_back(courses.at(places[i], {}));
      if (!courses.depends_on_place()) break;
    }
  }

  void search(const FunctionCourses& courses, const Places& places, SearchedFunction& result) {
    const bool of_place = courses.depends_on_place();
    SearchEffort effort;
    if (of_place) {
      effort.turn_evaluations = place_turn_evaluations;
      effort.comparisons = place_comparisons;
      effort.fewest_phases = place_phases;
    }
    const bool from_points = courses.needs_point_temperatures();
    std::vector<std::size_t> chosen = spread(places, from_points ? point_temperature_places : spread_places);
    if (!of_place) chosen.resize(1);
    std::vector<Turn> most;  // turns of the course that has most of them
    const auto add_place = [&](std::size_t i) {
      std::vector<Turn> turns = add(courses.at(places[i], courses.levels(places[i]).front()), effort, result);
      if (turns.size() > most.size()) most = std::move(turns);
    };
    for (const std::size_t i : chosen) add_place(i);
    add_levels(courses, places[chosen.front()], effort, result);
    if (of_place && !from_points && !result.events.too_many && !result.events.vibrates) {
      const double evaluations = std::min(most_screening, all_screening / static_cast<double>(n_of_place_));
      Screening screening(courses, places, config_.time.end, evaluations);
      for (std::size_t i = 0; i < further_places; ++i) {
        const std::optional<std::size_t> next = screening.next(known_times(result.events));
        if (!next) break;
        add_place(*next);
      }
    }
    settle_turns(result.events, most);
    if (result.events.vibrates && keeps_extremes()) stop_at_turns(result);
  }

  /// Whether something keeps the largest value of what acts on it.
  bool keeps_extremes() const {
    return !config_.gaskets.empty() || std::ranges::any_of(bodies_, [](const mechanics::Body& body) {
      return body.material().plasticity != nullptr;
    });
  }

  /// What flows plastically keeps what a turn has made of it: all turns of one place, however many.
  void stop_at_turns(SearchedFunction& found) const {
    const double end = config_.time.end;
    const std::vector<double> times = turns_of_vibration(found.courses.front(), {0, end}, found.events.n_turns);
    if (times.empty()) {
      log::warning(
          "'{}' turns back about {:.2g} times: steps do not end at all turns, and plastic strain that they leave may "
          "be missed; integrate fewer periods (time.cycle with time.jump_cycles)",
          found.key, found.events.n_turns);
      return;
    }
    constexpr double apart = 1e-3;  // of the mean distance
    found.events.turns.clear();
    for (const double t : times) found.events.turns.push_back({t, apart * end / static_cast<double>(times.size())});
  }

  void add_levels(const FunctionCourses& courses, const Place& place, SearchEffort effort,
                  SearchedFunction& result) const {
    const std::vector<Level> levels = courses.levels(place);
    effort.samples = level_samples;
    effort.turn_evaluations = place_turn_evaluations;
    for (std::size_t i = 1; i < levels.size(); ++i) add_events(courses.at(place, levels[i]), effort, result);
  }

  /// @returns its turns
  std::vector<Turn> add(const Course& course, const SearchEffort& effort, SearchedFunction& result) const {
    result.courses.push_back(course);
    return add_events(course, effort, result);
  }

  std::vector<Turn> add_events(const Course& course, const SearchEffort& effort, SearchedFunction& result) const {
    const CourseEvents more = find_events(course, config_.time.end, config_.time.cycle, effort);
    CourseEvents& all = result.events;
    all.jumps.insert(all.jumps.end(), more.jumps.begin(), more.jumps.end());
    all.kinks.insert(all.kinks.end(), more.kinks.begin(), more.kinks.end());
    all.turns.insert(all.turns.end(), more.turns.begin(), more.turns.end());
    all.limits.insert(all.limits.end(), more.limits.begin(), more.limits.end());
    all.n_turns = std::max(all.n_turns, more.n_turns);
    all.vibrates = all.vibrates || more.vibrates;
    all.too_many = all.too_many || more.too_many;
    return more.turns;
  }

  static std::vector<double> known_times(const CourseEvents& events) {
    std::vector<double> times = events.jumps;
    times.insert(times.end(), events.kinks.begin(), events.kinks.end());
    for (const Turn& turn : events.turns) times.push_back(turn.time);
    std::ranges::sort(times);
    return times;
  }

  /// Stops at the turns of a pulse that moves would be too many: then steps are bounded instead. With cycles the turns
  /// of one place have to do.
  static void settle_turns(CourseEvents& events, std::vector<Turn> of_one_course) {
    std::ranges::sort(events.turns, {}, &Turn::time);
    std::vector<Turn> distinct;
    for (const Turn& turn : events.turns)
      if (distinct.empty() || turn.time > distinct.back().time + turn.error) distinct.push_back(turn);
    if (distinct.size() > 2 * of_one_course.size() + most_turns) {
      const bool has_cycles = of_one_course.size() > most_turns;
      events.vibrates = events.vibrates || !has_cycles;
      distinct = has_cycles ? std::move(of_one_course) : std::vector<Turn>();
    }
    events.turns = std::move(distinct);
    if (!events.vibrates) events.limits.clear();
  }

  /// The field knows its times.
  void add_temperature_of_points() {
    if (!temperature_ || config_.has_temperature_function() || !temperature_->depends_on_time()) return;
    const config::ConfiguredFunction none{config_.heat ? "heat" : "temperature.file", {}, {}};
    const FunctionCourses courses(none, config_, bodies_, temperature_);
    const std::shared_ptr<const Places> places = key_places_.of(none.key);
    SearchedFunction result{none.key, {}, {}, {}};
    for (const std::size_t i : spread(*places, point_temperature_places))
      // What is computed is smooth between its kinks, and turns where nothing else does.
      if (config_.heat && keeps_extremes())
        add(courses.temperature((*places)[i]), {}, result);
      else
        result.courses.push_back(courses.temperature((*places)[i]));
    found_.push_back(std::move(result));
  }

  /// Between which the temperature is taken to be monotonous.
  void find_pieces() {
    const double end = config_.time.end;
    pieces_ = {0, end};
    for (const SearchedFunction& temperature : found_) {
      for (const double t : known_times(temperature.events)) pieces_.push_back(t);
      const CourseEvents& events = temperature.events;
      if (!events.vibrates || temperature.courses.empty()) continue;
      const std::vector<double> turns = turns_of_vibration(temperature.courses.front(), {0, end}, events.n_turns);
      pieces_.insert(pieces_.end(), turns.begin(), turns.end());
      has_all_pieces_ = has_all_pieces_ && !turns.empty();
    }
    if (temperature_)
      for (const double t : temperature_->breakpoints(end)) pieces_.push_back(t);
    std::erase_if(pieces_, [end](double t) { return t < 0 || t > end; });
    std::ranges::sort(pieces_);
    pieces_.erase(std::unique(pieces_.begin(), pieces_.end()), pieces_.end());
  }

  void warn_of_missing(const config::ConfiguredFunction& function, const TemperaturePassages& passages) const {
    if (has_all_pieces_ && passages.missing == 0) return;
    if (!has_all_pieces_ && passages.times.empty()) return;
    log::warning(
        "'{}' ({}): the temperature passes its points, kinks or jumps so often that steps do not end at all of them, "
        "and "
        "creep there may be missed{}; integrate fewer cycles (time.cycle with time.jump_cycles), or smooth the "
        "function "
        "of T",
        function.key, function.value.text(),
        passages.missing > 0 && std::isfinite(passages.missing)
            ? fmt::format(" (each changes the value by up to {:.2g} %)", 100 * passages.missing)
            : "");
  }

  void tell(const config::ConfiguredFunction& function, SearchedFunction& result) const {
    CourseEvents& events = result.events;
    if (events.too_many)
      log::warning(
          "'{}' ({}) has too many kinks or jumps in time to find them all; list the important times in "
          "time.breakpoints, or use a table with a period, or {}",
          function.key, function.value.text(),
          config_.time.cycle
              ? fmt::format("correct time.cycle = {:g}, with which it does not repeat", *config_.time.cycle)
              : "say with time.cycle that it repeats");
    if (!events.vibrates) return;
    const double n_steps = StepLimits(events.limits).n_steps();
    if (n_steps > most_steps) {
      log::warning(
          "'{}' ({}) turns back about {:.2g} times: to follow it would take {:.2g} steps, so steps are not bounded, "
          "and "
          "the mean of what it does may be wrong; replace it by its mean, or integrate fewer periods (time.cycle with "
          "time.jump_cycles)",
          function.key, function.value.text(), events.n_turns, n_steps);
      events.limits.clear();
      return;
    }
    log::info("'{}' turns back about {:.0f} times: bounds on the steps follow it, which takes {:.0f} steps or more",
              function.key, events.n_turns, n_steps);
  }

  const config::Config& config_;
  const Bodies& bodies_;
  const std::optional<mechanics::TemperatureField>& temperature_;
  std::vector<config::ConfiguredFunction> functions_;
  KeyPlaces key_places_;
  int n_of_place_ = 0;
  std::set<std::tuple<std::string, const Places*, bool>> searched_;
  std::vector<double> pieces_;
  bool has_all_pieces_ = true;
  std::vector<SearchedFunction> found_;
};

}  // namespace

std::vector<SearchedFunction> search_functions(const config::Config& config, const Bodies& bodies,
                                               const std::optional<mechanics::TemperatureField>& temperature) {
  return FunctionSearch(config, bodies, temperature).run();
}

}  // namespace creepcontact::model
