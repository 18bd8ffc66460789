/// [temperature] and [time]

#include <array>

#include "draft.hpp"

namespace creepcontact::deck {

void make_temperature(Draft& draft) {
  if (draft.loading.temperatures.empty() && !draft.varies) return;
  Course at_rest;
  at_rest.add(0, draft.loading.initial_temperature);
  const auto temperature_of = [&](std::int64_t node) -> const Course& {
    const auto found = draft.loading.temperatures.find(node);
    return found == draft.loading.temperatures.end() ? at_rest : found->second;
  };
  const auto refuse = [&](const std::string& why) {
    draft.impossible.push_back({draft.first("TEMPERATURE"), "TEMPERATURE", why});
  };
  const Function first = temperature_of(draft.used.front()).function();
  bool same = true;
  std::set<double> times, jumps;
  for (const std::int64_t node : draft.used) {
    const Course& own = temperature_of(node);
    same = same && own.function().text() == first.text();
    double before = -1;
    for (const auto& [time, value] : own.points()) {
      times.insert(time);
      if (time == before) jumps.insert(time);
      before = time;
    }
  }
  draft.comment("temperature", "*INITIAL CONDITIONS, *TEMPERATURE");
  config::Temperature& temperature = draft.config.temperature.emplace();
  if (!draft.loading.initial_temperatures.empty())
    draft.comments.above[same ? "temperature.value" : "temperature.file"] =
        "Differences from the initial temperatures, which differ from node to node.";
  if (same) {
    temperature.value = first;
    return;
  }
  if (!jumps.empty())
    refuse(fmt::format("temperatures that differ from node to node and jump at t = {:g}", *jumps.begin()));
  std::map<std::array<double, 3>, std::string> at;  // of several nodes at one place
  for (const std::int64_t node : draft.used) {
    const Vector3& x = draft.position(node);
    const std::string own = temperature_of(node).function().text();
    if (at.try_emplace({x[0], x[1], x[2]}, own).first->second == own) continue;
    refuse(fmt::format("node {} has another temperature than one at the same place", node));
    break;
  }
  temperature.files = {draft.name + "_temperature.csv"};
  std::string table = "t,x,y,z,T\n";
  for (const double time : times)
    for (const std::int64_t node : draft.used) {
      const Vector3& x = draft.position(node);
      table += fmt::format("{:.15g},{:.15g},{:.15g},{:.15g},{:.15g}\n", time, x[0], x[1], x[2],
                           temperature_of(node).at(time));
    }
  draft.tables.emplace_back(temperature.files.front().string(), std::move(table));
}

namespace {

/// Times at which something jumps, or supports come or go.
std::set<double> sudden_times(const Loading& loading) {
  std::set<double> times;
  const auto add = [&](const Course& course) {
    for (const auto& [time, value] : course.points())
      if (course.before(time) != course.at(time)) times.insert(time);
  };
  for (const auto* conditions : {&loading.supports, &loading.forces})
    for (const auto& [node, courses] : *conditions)
      for (const auto& [direction, course] : courses) add(course);
  for (const auto& [face, course] : loading.pressures) add(course);
  for (const auto& [node, course] : loading.temperatures) add(course);
  for (const Loading::Body& load : loading.bodies) add(load.course);
  for (const auto& [node, course] : loading.heat.temperatures) add(course);
  for (const auto& [node, lock] : loading.locked) times.insert(lock.time);
  for (const auto& [key, windows] : loading.windows)
    for (const Window& window : windows)
      for (const auto& time : {window.from, window.until})
        if (time) times.insert(*time);
  return times;
}

}  // namespace

/// Puts outputs at the ends of the steps; where the next one begins with a jump, just before it.
void make_time(Draft& draft) {
  constexpr double just_before = 1e-9;  // of the time
  std::set<double> times(draft.loading.step_ends.begin(), draft.loading.step_ends.end());
  times.erase(0);
  std::set<double> sudden = sudden_times(draft.loading);
  sudden.insert(draft.changes.begin(), draft.changes.end());
  for (const double time : times) {
    const bool is_sudden = time != draft.loading.end && sudden.contains(time);
    draft.config.time.output.push_back(rounded(is_sudden ? time * (1 - just_before) : time));
  }
  const bool is_steady = draft.deck.conducts() && !draft.deck.deforms();
  if (!(draft.loading.end > 0) && !is_steady)
    draft.impossible.push_back({draft.deck.steps.back().place, "STEP", "the steps take no time"});
  draft.config.time.end = rounded(draft.loading.end);
  draft.comment("time.output", "the ends of the steps, and always 0 and the end; more: { count = 20 }");
  draft.config.output.directory = "results/" + draft.name;
}

}  // namespace creepcontact::deck
