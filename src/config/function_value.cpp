/// Function values: a number, an expression, or a table in t, T, p or gap.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "table.hpp"
#include "value.hpp"

namespace creepcontact::config {
namespace {

constexpr double max_repeated = 1e6;  // times at which steps end

/// What one key allows.
struct Allowed {
  std::vector<std::string> variables;
  Range range;

  bool has(const std::string& variable) const {
    return std::find(variables.begin(), variables.end(), variable) != variables.end();
  }
  std::vector<std::string> table_variables() const {
    std::vector<std::string> names;
    for (const char* name : {"t", "T", "p", "gap"}) {
      if (has(name)) names.emplace_back(name);
    }
    return names;
  }
  /// "function of T, > 0"; @param what  "function" or "functions"; without variables "number"
  std::string brief(const std::string& what, const std::string& constant) const {
    if (variables.empty()) return range.describe(constant);
    const std::string text = fmt::format("{} of {}", what, fmt::join(variables, ", "));
    const std::string bounds = range.describe("");
    return bounds.empty() ? text : text + ',' + bounds;
  }
  std::string describe() const {
    std::string text = range.describe();
    if (!variables.empty()) text += fmt::format(", an expression in {}", fmt::join(variables, ", "));
    for (const std::string& name : table_variables())
      text += fmt::format(", a table {{ {} = [...], values = [...] }}", name);
    return text;
  }
  Json json() const {
    std::vector<Json> alternatives{range.json(), {{"type", "string"}, {"description", "an expression"}}};
    for (const std::string& name : table_variables()) {
      Json table = schema_of_table();
      table["properties"] = {{name, schema_of_list(Range{}.json())}, {"values", schema_of_list(range.json())}};
      if (name == "t") table["properties"]["period"] = greater(0).json();
      table["required"] = Json::array({name, "values"});
      alternatives.push_back(std::move(table));
    }
    return schema_of_any(std::move(alternatives));
  }
};

std::optional<Function> read_expression(const Item& item, const std::string& written, const Allowed& allowed,
                                        Context& context) {
  try {
    const Function function = Function::expression(written, allowed.variables);
    if (!function.is_constant() || (std::isfinite(function({})) && allowed.range.contains(function({})))) {
      return function;
    }
    context.errors.add(item.location, fmt::format("expression '{}' is {}", written, function({})), allowed.describe());
  } catch (const std::invalid_argument& error) {
    context.errors.add(item.location, fmt::format("expression '{}': {}", written, error.what()), allowed.describe());
  }
  return std::nullopt;
}

bool increasing(const Item& item, const std::string& variable, const std::vector<double>& abscissae, Context& context) {
  const std::size_t i = Function::misplaced_point(variable, abscissae);
  if (i == abscissae.size()) return true;
  context.errors.add(item.element(i).location,
                     fmt::format("{} follows {}: the points of a table must increase{}", abscissae[i], abscissae[i - 1],
                                 variable == "t" ? "; for a jump, give the same time twice" : ""));
  return false;
}

std::optional<Function> read_points(const Item& item, const Allowed& allowed, Context& context) {
  std::vector<std::string> keys = allowed.table_variables();
  if (keys.empty()) {
    context.errors.add(item.location, describe(*item.node), allowed.describe());
    return std::nullopt;
  }
  const std::vector<std::string> variables = keys;
  keys.emplace_back("values");
  if (allowed.has("t")) keys.emplace_back("period");
  bool right = known_keys_only(item, keys, context);
  const auto given = std::find_if(variables.begin(), variables.end(), [&](const auto& name) { return item.has(name); });
  if (given == variables.end() || !item.has("values")) {
    // a mistyped key has been named already
    if (right) context.errors.add(item.location, "a table without points or values", allowed.describe());
    return std::nullopt;
  }
  if (std::all_of(variables.begin(), variables.end(), [&](const auto& name) { return item.has(name); }) &&
      variables.size() > 1) {
    context.errors.add(item.location, "a table in both t and T", allowed.describe());
    return std::nullopt;
  }
  const Item points = item.child(*given);
  const auto abscissae = list(number()).read(points, context);
  const auto values = list(number(allowed.range)).read(item.child("values"), context);
  if (!abscissae || !values || !right) return std::nullopt;
  if (abscissae->size() != values->size() || abscissae->empty()) {
    context.errors.add(item.location, fmt::format("{} points and {} values", abscissae->size(), values->size()),
                       "as many values as points, at least one");
    return std::nullopt;
  }
  if (!increasing(points, *given, *abscissae, context)) return std::nullopt;
  std::optional<double> period;
  if (const Item item_period = item.child("period"); item_period.node) {
    period = number(greater(0)).read(item_period, context);
    if (!period) return std::nullopt;
    if (const std::string mistake = Function::period_error(*given, *abscissae, *period); !mistake.empty()) {
      context.errors.add(item_period.location, mistake);
      return std::nullopt;
    }
    const auto n_points = static_cast<double>(abscissae->size());
    if (const double periods = context.end / *period; !(periods * n_points <= max_repeated)) {
      context.errors.add(
          item_period.location,
          fmt::format("{} points repeat {:.6g} times up to time.end = {}", n_points, periods, context.end),
          fmt::format("at most {} points in all; check that the period has the unit of time.end", max_repeated));
      return std::nullopt;
    }
  }
  return Function::table(*given, *abscissae, *values, period);
}

std::optional<Function> read_function(const Item& item, const Allowed& allowed, Context& context) {
  if (const auto* string = item.node->as_string()) return read_expression(item, string->get(), allowed, context);
  if (item.node->is_table()) return read_points(item, allowed, context);
  const auto found = item.node->is_number() ? item.node->value<double>() : std::nullopt;
  if (found && std::isfinite(*found) && allowed.range.contains(*found)) return Function(*found);
  context.errors.add(item.location, describe(*item.node), allowed.describe());
  return std::nullopt;
}

}  // namespace

Value<Function> function(const std::vector<std::string>& variables, Range range) {
  const Allowed allowed{variables, range};
  Value<Function> value{.type = allowed.describe(),
                        .read = {},
                        .brief = allowed.brief("function", "number"),
                        .plural = allowed.brief("functions", "numbers"),
                        .json = [allowed] { return allowed.json(); }};
  value.read = [allowed](const Item& item, Context& context) { return read_function(item, allowed, context); };
  value.visit = [variables](const Function& one, Visitor& to) { to.function(one, variables); };
  return value;
}

}  // namespace creepcontact::config
