#include "toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace creepcontact::deck {

std::string toml_string(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') {
      result += fmt::format("\\u{:04X}", static_cast<unsigned char>(c));
      continue;
    }
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string toml_key(const std::string& text) {
  const bool bare = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
  return bare ? text : toml_string(text);
}

std::string toml_vector(const Vector3& vector) {
  return fmt::format("[{:.15g}, {:.15g}, {:.15g}]", vector[0], vector[1], vector[2]);
}

std::string function_of_temperature(const std::vector<std::pair<double, double>>& points) {
  std::string temperatures, values;
  for (const auto& [temperature, value] : points) {
    temperatures += fmt::format("{}{:.15g}", temperatures.empty() ? "" : ", ", temperature);
    values += fmt::format("{}{:.15g}", values.empty() ? "" : ", ", value);
  }
  if (points.size() == 1) return values;
  return fmt::format("{{ T = [{}], values = [{}] }}", temperatures, values);
}

std::string function_of_temperature(const Table& table, std::size_t column, std::size_t of_temperature) {
  const auto value = [&](const std::vector<double>& row, std::size_t i) { return i < row.size() ? row[i] : 0.0; };
  std::vector<std::pair<double, double>> points;
  points.reserve(table.rows.size());
  for (const std::vector<double>& row : table.rows) points.emplace_back(value(row, of_temperature), value(row, column));
  return function_of_temperature(points);
}

std::string prefix(const Place& at) {
  return at.file.empty() ? "" : at.text() + ": ";
}

}  // namespace creepcontact::deck
