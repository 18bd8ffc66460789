#include "creepcontact/base/units.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

namespace creepcontact {
namespace {

constexpr std::array<std::pair<std::string_view, Dimension>, 8> names{{{"time", Dimension::time},
                                                                       {"length", Dimension::length},
                                                                       {"area", Dimension::area},
                                                                       {"force", Dimension::force},
                                                                       {"moment", Dimension::moment},
                                                                       {"energy", Dimension::energy},
                                                                       {"stress", Dimension::stress},
                                                                       {"temperature", Dimension::temperature}}};

using Words = std::vector<std::string_view>;

Words known_units(Dimension dimension) {
  switch (dimension) {
    case Dimension::time:
      return {"s", "ms", "min", "h", "hr", "hour", "hours", "d", "day", "days", "a", "yr", "year", "years"};
    case Dimension::length:
    case Dimension::area:
      return {"mm", "m", "cm", "um", "µm", "km", "in", "ft"};
    case Dimension::force:
      return {"N", "kN", "MN", "mN", "uN", "µN", "lbf", "lb", "kip", "kgf", "tf"};
    case Dimension::stress:
      return {"Pa", "kPa", "MPa", "GPa", "bar", "psi", "ksi", "Msi", "N/mm2", "N/mm^2", "N/m2", "N/m^2"};
    case Dimension::temperature:
      return {"degC", "°C", "C", "K", "degF", "°F", "F"};
    default:
      return {};
  }
}

std::vector<std::string> words(const std::string& units) {
  std::vector<std::string> result(1);
  for (char c : units) {
    if (c == ',' || c == ';' || std::isspace(static_cast<unsigned char>(c))) {
      if (!result.back().empty()) result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

}  // namespace

Dimension dimension_of(const std::string& name) {
  const auto found = std::ranges::find(names, name, &std::pair<std::string_view, Dimension>::first);
  return found == names.end() ? Dimension::none : found->second;
}

std::string name_of(Dimension dimension) {
  const auto found = std::ranges::find(names, dimension, &std::pair<std::string_view, Dimension>::second);
  return found == names.end() ? "value" : std::string(found->first);
}

std::string unit_of(Dimension dimension, const std::string& units) {
  if (dimension == Dimension::moment || dimension == Dimension::energy) {
    const std::string force = unit_of(Dimension::force, units), length = unit_of(Dimension::length, units);
    return force.empty() || length.empty() ? "" : force + "·" + length;
  }
  const Words known = known_units(dimension);
  for (const std::string& word : words(units)) {
    if (std::ranges::count(known, word) == 0) continue;
    if (dimension == Dimension::area) return word + "²";
    return word == "degC" ? "°C" : word == "degF" ? "°F" : word;
  }
  return "";
}

}  // namespace creepcontact
