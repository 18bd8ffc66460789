#pragma once
/// time.output: a list of times or a series, made into increasing times from 0 to the end.

#include <variant>

#include "creepcontact/settings/enum_names.hpp"
#include "value.hpp"

namespace creepcontact::config {

enum class Spacing { linear, logarithmic };
constexpr auto names_of(Spacing) {
  return std::to_array<settings::EnumName<Spacing>>({{"log", Spacing::logarithmic}, {"linear", Spacing::linear}});
}

struct OutputSeries {
  std::optional<double> first;  ///< not given: linear only, end / count
  int count = 2;
  Spacing spacing = Spacing::linear;
};

struct PlacedTime {
  double time = 0;
  Location location;
};

using OutputTimes = std::variant<std::vector<PlacedTime>, OutputSeries>;

Value<OutputTimes> output_times();

/// Times from 0 to `end`, increasing, each once. Reports times beyond the end.
std::vector<double> resolve(const OutputTimes& times, double end, const Location& where, Context& context);

}  // namespace creepcontact::config
