#include "temperature_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "creepcontact/base/error.hpp"

namespace creepcontact::io {
namespace {

using Words = std::vector<std::string>;

constexpr std::array units_of_length{"mm", "m", "cm", "um", "in", "inch", "ft"};
constexpr std::array units_of_time{"s",  "sec",  "second", "seconds", "min", "h",
                                   "hr", "hour", "hours",  "d",       "day", "days"};
constexpr std::array units_of_temperature{"c",
                                          "k",
                                          "f",
                                          "degc",
                                          "degf",
                                          "degk",
                                          "\xC2\xB0"
                                          "c",
                                          "\xC2\xB0"
                                          "f",
                                          "\xB0"
                                          "c",
                                          "celsius",
                                          "kelvin",
                                          "fahrenheit"};
constexpr std::array names_of_time{"time", "timevalue"};
constexpr std::array names_of_temperature{"temperature", "temperatures",     "temp",  "nt",
                                          "nt11",        "nodaltemperature", "ndtemp"};
constexpr std::array words_of_coordinates{"",         "coord",    "coordinate", "coordinates",
                                          "location", "position", "pos",        "point"};

bool is_among(const auto& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

bool is_unit(std::string_view word) {
  return is_among(units_of_length, word) || is_among(units_of_time, word) || is_among(units_of_temperature, word);
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Cuts the text in brackets out of the name.
std::string cut_brackets(std::string& name) {
  const std::size_t open = name.find_first_of("[({");
  if (open == std::string::npos) return {};
  const std::size_t close = std::min(name.find_first_of("])}", open), name.size() - 1);
  std::string inside = name.substr(open + 1, close - open - 1);
  name.erase(open, close - open + 1);
  std::erase_if(inside, [](unsigned char c) { return std::isspace(c) != 0 || c == '.'; });
  return lower(inside);
}

Words words_of(const std::string& name) {
  Words words(1);
  for (const char c : name)
    if (std::string_view(" \t_:./-,").find(c) == std::string_view::npos)
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  if (words.back().empty()) words.pop_back();
  return words;
}

std::string coordinate_of(const std::string& name) {
  for (const char axis : {'x', 'y', 'z', 'r'})
    for (const char* const word : words_of_coordinates)
      if (name == axis + std::string(word) || name == word + std::string(1, axis)) return {axis};
  if (name == "radius" || name == "radial") return "r";
  // ParaView writes "Points:0", Abaqus "COORD.COOR1".
  for (const std::size_t i : {0, 1, 2})
    if (name == fmt::format("points{}", i) || name == fmt::format("coordcoor{}", i + 1)) return {"xyz"[i]};
  return {};
}

}  // namespace

PointTemperatures::Coordinates TemperatureColumns::coordinates() const {
  using enum PointTemperatures::Coordinates;
  if (x && y) return z ? xyz : xy;
  return rz;
}

std::string quantity_of(std::string_view column) {
  std::string name(column);
  std::string unit = cut_brackets(name);
  Words words = words_of(name);
  while (unit.empty() && words.size() > 1 && is_unit(lower(words.back()))) {
    unit = lower(words.back());
    words.pop_back();
  }
  while (words.size() > 1 && (lower(words.back()) == "in" || lower(words.back()) == "deg")) words.pop_back();
  if (words.empty()) return {};
  if (words.size() == 1 && lower(words[0]) == "t") {
    if (is_among(units_of_temperature, unit)) return "T";
    return is_among(units_of_time, unit) ? "t" : words[0];
  }
  std::string joined;
  for (const std::string& word : words) joined += lower(word);
  if (is_among(names_of_time, joined)) return "t";
  if (is_among(names_of_temperature, joined)) return "T";
  return coordinate_of(joined);
}

TemperatureColumns find_columns(const std::string& file, const std::vector<std::string>& names,
                                const ColumnNames& given) {
  const auto fail = [&](const std::string& what) {
    throw ModelError(fmt::format("'{}', line 1: {}; the columns are {}", file, what, fmt::join(names, ", ")));
  };
  std::map<std::string, std::size_t> found;
  for (const auto& [quantity, name] : given) {
    const auto column = std::ranges::find(names, name);
    if (column == names.end()) fail(fmt::format("no column '{}', which 'columns' names for {}", name, quantity));
    found[quantity] = static_cast<std::size_t>(column - names.begin());
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string quantity = quantity_of(names[i]);
    if (quantity.empty() || given.contains(quantity)) continue;
    if (std::ranges::any_of(given, [&](const auto& entry) { return entry.second == names[i]; })) continue;
    const auto [earlier, is_new] = found.try_emplace(quantity, i);
    if (!is_new)
      fail(fmt::format("both '{}' and '{}' may be {}; choose one by columns = {{ {} = \"...\" }}",
                       names[earlier->second], names[i], quantity, quantity));
  }
  const auto column = [&](const char* quantity) -> std::optional<std::size_t> {
    const auto at = found.find(quantity);
    return at == found.end() ? std::nullopt : std::optional(at->second);
  };
  TemperatureColumns columns{column("x"), column("y"), column("z"), column("r"), column("t")};
  if (!column("T")) fail("no column is known as the temperature T; name it by columns = { T = \"...\" }");
  if ((!columns.x || !columns.y) && (!columns.r || !columns.z))
    fail(
        "neither x and y nor r and z are among the columns; name them by columns = { x = \"...\", y = \"...\", "
        "z = \"...\" }");
  columns.T = *column("T");
  return columns;
}

}  // namespace creepcontact::io
