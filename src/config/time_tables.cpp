/// [time]

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "output_times.hpp"
#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

constexpr double max_steps = 1e9;  // of a fixed length
constexpr double max_cycles = 1e6;

struct TimeKeys : Time {
  OutputTimes wanted;
};

Value<settings::StepChoice> time_step() {
  using Mode = settings::StepMode;
  std::vector<std::string> words;
  for (const auto& [name, mode] : names_of(Mode{})) words.emplace_back(name);
  const Value<WordOrNumber> given = words_or_number(words, greater(0));
  Value<settings::StepChoice> value{
      .type = given.type, .read = {}, .brief = given.brief, .words = given.words, .json = given.json};
  value.read = [=](const Item& item, Context& context) -> std::optional<settings::StepChoice> {
    const auto found = given.read(item, context);
    if (!found) return std::nullopt;
    for (const auto& [name, mode] : names_of(Mode{}))
      if (name == found->word) return mode;
    return found->number;
  };
  value.visit = [=](const settings::StepChoice& step, Visitor& to) {
    const std::string word(settings::name_of(step.mode));
    given.visit(word.empty() ? WordOrNumber{{}, step.length} : WordOrNumber{word, 0}, to);
  };
  return value;
}

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// A table of the integrator, in whatever case, with ARKODE's prefix or without.
void check_table(const Time& time, const Vocabulary& vocabulary, const Location& where, Context& context) {
  if (time.table.empty()) return;
  const auto found = vocabulary.tables.find(time.integrator);
  if (found == vocabulary.tables.end()) {
    std::vector<std::string> names;
    for (const auto& [name, tables] : vocabulary.tables) names.push_back(name);
    context.errors.add(where, fmt::format("integrator \"{}\" has no Butcher tables; remove 'table', or choose {}",
                                          time.integrator, fmt::join(names, " or ")));
    return;
  }
  const std::string prefix = "arkode_";
  std::string wanted = in_lower_case(time.table);
  if (wanted.starts_with(prefix)) wanted.erase(0, prefix.size());
  if (std::find(found->second.begin(), found->second.end(), wanted) == found->second.end())
    context.errors.add_unknown(where, fmt::format("{} has no table '{}'", time.integrator, time.table), wanted,
                               found->second);
}

void check_cycles(const Time& time, const Item& item, Context& context) {
  if (!time.cycle) {
    for (const std::string& key : given_keys(item, {"stop_when_steady", "jump_cycles", "jump_tolerance"}))
      context.errors.add(item.child(key).location, "has no effect without cycles", "with time.cycle, their period");
    return;
  }
  if (!(time.end > 0)) return;
  const double cycles = time.end / *time.cycle;
  if (cycles < 1)
    context.errors.add(item.child("cycle").location,
                       fmt::format("no cycle of {} ends before time.end = {}", *time.cycle, time.end),
                       "a period that is not longer than the run");
  if (cycles > max_cycles)
    context.errors.add(
        item.child("cycle").location,
        fmt::format("{:.6g} cycles of {} up to time.end = {}", cycles, *time.cycle, time.end),
        fmt::format("at most {:.0e} cycles; check that the period has the unit of time.end", max_cycles));
}

std::optional<Time> make_time(TimeKeys keys, const Vocabulary& vocabulary, const Item& item, Context& context) {
  keys.location = item.location;
  std::sort(keys.breakpoints.begin(), keys.breakpoints.end());
  if (keys.end > 0)
    keys.output = resolve(keys.wanted, keys.end, item.child("output").location, context);
  else if (item.has("end"))
    keys.output = {0};
  check_table(keys, vocabulary, item.child("table").location, context);
  if (const double steps = keys.end / keys.step.length;
      keys.step.mode == settings::StepMode::fixed && steps > max_steps)
    context.errors.add(item.child("step").location,
                       fmt::format("{:.6g} steps of {} up to time.end = {}", steps, keys.step.length, keys.end),
                       fmt::format("at most {:.0e} steps; check that the step has the unit of time.end", max_steps));
  check_cycles(keys, item, context);
  return Time(std::move(keys));
}

/// Leaves out the times that are always among the outputs.
TimeKeys keys_of_time(const Time& time) {
  std::vector<PlacedTime> further;
  for (const double t : time.output)
    if (t != 0 && t != time.end) further.push_back({t, {}});
  return TimeKeys{time, further};
}

}  // namespace

Value<Time> time_table(const Vocabulary& vocabulary) {
  const auto linear_solver = choice<settings::LinearSolver>("linear solver");
  auto integrator = choice("integrator", vocabulary.integrators);
  integrator.brief = "integrator; see `creepcontact list integrators`";
  const auto keys = table<TimeKeys>({
      field<TimeKeys>("end", &TimeKeys::end, number(at_least(0)),
                      "end of the run, which starts at t = 0; 0: only the state at the start", Presence::required)
          .in("time"),
      field<TimeKeys>("integrator", &TimeKeys::integrator, integrator, "method of time integration"),
      field<TimeKeys>("tolerance", &TimeKeys::tolerance, number({.min = 0, .max = 0.5, .open_min = true}),
                      "allowed relative error of the stress; the Euler schemes use it with `step = \"adaptive\"` only"),
      field<TimeKeys>("linear_solver", &TimeKeys::linear_solver, linear_solver,
                      "`auto`, `cvode_bdf`, `arkode_dirk`: GMRES, which needs only the elastic factorisation, or a "
                      "factorised tangent stiffness"),
      field<TimeKeys>("output", &TimeKeys::wanted, output_times(),
                      "times at which results are written; 0 and `end` are always included")
          .in("time"),
      field<TimeKeys>("stop_at_output", &TimeKeys::stop_at_output, boolean(),
                      "steps end at the output times; otherwise results are interpolated within the steps"),
      field<TimeKeys>(
          "step", &TimeKeys::step, time_step(),
          "Euler schemes: a fixed step; `\"stable\"`: the stable step times `step_factor` (with fixed-point iterations "
          "at most 0.8 of the longest step for which they converge); `\"adaptive\"`: chosen to meet `tolerance`")
          .in("time"),
      field<TimeKeys>("step_factor", &TimeKeys::step_factor, number(at_least(1e-6)),
                      "Euler schemes with `step = \"stable\"`: length of the steps in stable steps"),
      field<TimeKeys>("beta", &TimeKeys::beta, number({.min = 0.5, .max = 1}),
                      "`beta_euler`: 0.5 trapezoidal rule, 1 implicit Euler"),
      field<TimeKeys>("inner", &TimeKeys::inner, choice<settings::InnerIteration>("inner iteration"),
                      "`beta_euler`: inner iterations; Newton's converge for steps of any length"),
      field<TimeKeys>("inner_tolerance", &TimeKeys::inner_tolerance, number(greater(0)),
                      "`beta_euler`: largest change of creep strain in the last inner iteration; the remaining errors "
                      "add up over many short steps if `residual_correction` < 1"),
      field<TimeKeys>("inner_anderson", &TimeKeys::inner_anderson, integer(0, 100),
                      "`beta_euler`: depth of Anderson acceleration of the fixed-point iterations (3 to 5 is enough); "
                      "0: plain iterations, as in Stankevich 2012"),
      field<TimeKeys>("residual_correction", &TimeKeys::residual_correction, number({.min = 0, .max = 1}),
                      "`beta_euler`: fraction of the nodal-force residual that the next step corrects"),
      field<TimeKeys>("table", &TimeKeys::table, name("a Butcher table of ARKODE"),
                      "`arkode_erk`, `arkode_dirk`: which method")
          .otherwise("the integrator's own"),
      field<TimeKeys>(
          "breakpoints", &TimeKeys::breakpoints, list(number(at_least(0))),
          "further times at which steps must end; jumps and kinks of tables and expressions are found automatically")
          .in("time"),
      field<TimeKeys>("cycle", &TimeKeys::cycle, number(greater(0)),
                      "period of the loads: each cycle from t = 0 on is reported in `cycles.csv`")
          .in("time")
          .otherwise("no cycles"),
      field<TimeKeys>("stop_when_steady", &TimeKeys::stop_when_steady, number({.min = 0, .max = 1, .open_min = true}),
                      "the run ends with the first cycle that repeats the one before it: to within this share of the "
                      "stress, and of the range of every probe")
          .otherwise("goes on to `end`"),
      field<TimeKeys>("jump_cycles", &TimeKeys::jump_cycles, boolean(),
                      "cycles whose changes vary smoothly are skipped by extrapolation; outputs still are where "
                      "they were asked for"),
      field<TimeKeys>("jump_tolerance", &TimeKeys::jump_tolerance, number({.min = 0, .max = 0.5, .open_min = true}),
                      "allowed relative error of the stress by a jump over cycles"),
  });
  return converted<Time>(
      keys,
      [vocabulary](TimeKeys read, const Item& item, Context& context) {
        return make_time(std::move(read), vocabulary, item, context);
      },
      keys_of_time);
}

}  // namespace creepcontact::config
