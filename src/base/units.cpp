#include "creepcontact/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

#include "creepcontact/base/unit_system.hpp"

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

struct Unit {
  std::string_view word;
  UnitScale scale;
};
using Units = std::vector<Unit>;

const Units& units_of(Dimension dimension) {
  constexpr double day = 86400, year = 365.25 * day, inch = 0.0254, pound = 4.4482216152605,
                   psi = pound / (inch * inch);
  constexpr double celsius = 273.15, fahrenheit = 459.67 / 1.8;
  static const Units times{{"s", {1}},        {"sec", {1}},      {"second", {1}},  {"seconds", {1}}, {"minute", {60}},
                           {"minutes", {60}}, {"ms", {1e-3}},    {"min", {60}},    {"h", {3600}},    {"hr", {3600}},
                           {"hour", {3600}},  {"hours", {3600}}, {"d", {day}},     {"day", {day}},   {"days", {day}},
                           {"a", {year}},     {"yr", {year}},    {"year", {year}}, {"years", {year}}};
  static const Units lengths{{"mm", {1e-3}}, {"m", {1}},     {"cm", {1e-2}},   {"um", {1e-6}},     {"µm", {1e-6}},
                             {"km", {1e3}},  {"in", {inch}}, {"inch", {inch}}, {"inches", {inch}}, {"ft", {12 * inch}}};
  static const Units forces{
      {"N", {1}},       {"kN", {1e3}},   {"MN", {1e6}},          {"mN", {1e-3}},     {"uN", {1e-6}},   {"µN", {1e-6}},
      {"lbf", {pound}}, {"lb", {pound}}, {"kip", {1e3 * pound}}, {"kgf", {9.80665}}, {"tf", {9806.65}}};
  static const Units stresses{{"Pa", {1}},      {"kPa", {1e3}},    {"MPa", {1e6}},       {"GPa", {1e9}},
                              {"bar", {1e5}},   {"psi", {psi}},    {"ksi", {1e3 * psi}}, {"Msi", {1e6 * psi}},
                              {"N/mm2", {1e6}}, {"N/mm^2", {1e6}}, {"N/mm²", {1e6}},     {"N/m2", {1}},
                              {"N/m^2", {1}},   {"N/m²", {1}}};
  static const Units temperatures{
      {"degC", {1, celsius}},          {"°C", {1, celsius}},          {"C", {1, celsius}},         {"K", {1}},
      {"degF", {1 / 1.8, fahrenheit}}, {"°F", {1 / 1.8, fahrenheit}}, {"F", {1 / 1.8, fahrenheit}}};
  static const Units none;
  switch (dimension) {
    case Dimension::time:
      return times;
    case Dimension::length:
      return lengths;
    case Dimension::force:
      return forces;
    case Dimension::stress:
      return stresses;
    case Dimension::temperature:
      return temperatures;
    default:
      return none;
  }
}

}  // namespace

std::vector<std::string> unit_words(const std::string& units) {
  std::vector<std::string> result(1);
  for (const char letter : units) {
    const bool separates = std::string_view(",;-").find(letter) != std::string_view::npos;
    if (separates || std::isspace(static_cast<unsigned char>(letter))) {
      if (!result.back().empty()) result.emplace_back();
    } else {
      result.back() += letter;
    }
  }
  if (result.back().empty()) result.pop_back();
  return result;
}

Dimension dimension_of(const std::string& name) {
  const auto found = std::ranges::find(names, name, &std::pair<std::string_view, Dimension>::first);
  return found == names.end() ? Dimension::none : found->second;
}

std::string name_of(Dimension dimension) {
  const auto found = std::ranges::find(names, dimension, &std::pair<std::string_view, Dimension>::second);
  return found == names.end() ? "value" : std::string(found->first);
}

std::optional<UnitScale> unit_scale(Dimension dimension, const std::string& unit) {
  const Units& units = units_of(dimension);
  const auto found = std::ranges::find(units, unit, &Unit::word);
  return found == units.end() ? std::nullopt : std::optional(found->scale);
}

std::vector<std::string> known_units(Dimension dimension) {
  std::vector<std::string> result;
  for (const Unit& unit : units_of(dimension)) result.emplace_back(unit.word);
  return result;
}

std::string unit_of(Dimension dimension, const std::string& units) {
  if (dimension == Dimension::moment || dimension == Dimension::energy) {
    const std::string force = unit_of(Dimension::force, units), length = unit_of(Dimension::length, units);
    return force.empty() || length.empty() ? "" : force + "·" + length;
  }
  const Dimension of_word = dimension == Dimension::area ? Dimension::length : dimension;
  for (const std::string& word : unit_words(units)) {
    if (!unit_scale(of_word, word)) continue;
    if (dimension == Dimension::area) return word + "²";
    return word == "degC" ? "°C" : word == "degF" ? "°F" : word;
  }
  return "";
}

std::string with_unit(double value, Dimension dimension, const std::string& units) {
  const std::string unit = unit_of(dimension, units);
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

}  // namespace creepcontact
