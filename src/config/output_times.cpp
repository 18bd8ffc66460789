#include "output_times.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "creepcontact/base/overload.hpp"
#include "table.hpp"

namespace creepcontact::config {
namespace {

constexpr int max_outputs = 100'000;  // each is a row, and a file of fields

Value<OutputSeries> series_table() {
  const auto spacing = choice<Spacing>("spacing");
  const auto keys = table<OutputSeries>({
      field<OutputSeries>("first", &OutputSeries::first, number(greater(0)), "first time after 0")
          .in("time")
          .otherwise("linear: `end` / `count`; log: required"),
      field<OutputSeries>("count", &OutputSeries::count, integer(2, max_outputs), "number of times after 0",
                          Presence::required),
      field<OutputSeries>("spacing", &OutputSeries::spacing, spacing, "spacing of the times from `first` to `end`"),
  });
  return converted<OutputSeries>(
      keys, [](OutputSeries series, const Item& item, Context& context) -> std::optional<OutputSeries> {
        if (series.spacing == Spacing::logarithmic && !item.has("first")) {
          context.errors.add(item.location, "spacing \"log\" without 'first'", "a first time > 0");
          return std::nullopt;
        }
        return series;
      });
}

/// Series have times like 0.1 + 0.2 that are not the number meant: 12 digits are.
double rounded(double time) {
  return std::stod(fmt::format("{:.12g}", time));
}

std::vector<double> points(const OutputSeries& series, double end) {
  const double first = series.first.value_or(end / series.count);
  std::vector<double> times;
  for (int i = 0; i + 1 < series.count; ++i) {
    const double fraction = static_cast<double>(i) / (series.count - 1);
    const double time = series.spacing == Spacing::logarithmic ? first * std::pow(end / first, fraction)
                                                               : first + (end - first) * i / (series.count - 1);
    times.push_back(std::min(rounded(time), end));
  }
  return times;
}

}  // namespace

Value<OutputTimes> output_times() {
  const auto times = list(converted<PlacedTime>(
      number(at_least(0)),
      [](double time, const Item& item, Context&) {
        return std::optional(PlacedTime{time, item.location});
      },
      [](const PlacedTime& placed) { return placed.time; }));
  const auto series = series_table();
  Value<OutputTimes> value{.type = "a list of times, or { first, count, spacing }",
                           .read = {},
                           .keys = series.keys,
                           .brief = "list of times, or `{ first, count, spacing }`",
                           .json = [=] {
                             return schema_of_any({times.json(), series.json()});
                           }};
  value.read = [=, type = value.type](const Item& item, Context& context) -> std::optional<OutputTimes> {
    if (item.node->is_array()) {
      const auto found = times.read(item, context);
      if (found) return OutputTimes(*found);
    } else if (item.node->is_table()) {
      const auto found = series.read(item, context);
      if (found) return OutputTimes(*found);
    } else {
      context.errors.add(item.location, describe(*item.node), type);
    }
    return std::nullopt;
  };
  value.visit = [=](const OutputTimes& wanted, Visitor& to) {
    std::visit(Overload{[&](const std::vector<PlacedTime>& all) { times.visit(all, to); },
                        [&](const OutputSeries& one) { series.visit(one, to); }},
               wanted);
  };
  return value;
}

std::vector<double> resolve(const OutputTimes& times, double end, const Location& where, Context& context) {
  std::vector<double> all{0.0, end};
  const std::string allowed = Range{.min = 0, .max = end}.describe("times");
  std::visit(Overload{[&](const OutputSeries& series) {
                        if (!series.first || *series.first < end) {
                          std::ranges::copy(points(series, end), std::back_inserter(all));
                          return;
                        }
                        Location first = where;
                        first.key = join_key(where.key, "first");
                        context.errors.add(first, fmt::format("number {}", *series.first),
                                           fmt::format("before time.end = {}", end));
                      },
                      [&](const std::vector<PlacedTime>& list) {
                        for (const PlacedTime& placed : list) {
                          if (placed.time > end)
                            context.errors.add(placed.location,
                                               fmt::format("number {} is beyond time.end", placed.time), allowed);
                          all.push_back(placed.time);
                        }
                      }},
             times);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace creepcontact::config
