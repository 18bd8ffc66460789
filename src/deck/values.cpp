#include "values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <functional>

namespace creepcontact::deck {

double rounded(double number) {
  return std::strtod(fmt::format("{:.15g}", number).c_str(), nullptr);
}

std::array<double, 3> rounded(const Vector3& vector) {
  return {rounded(vector[0]), rounded(vector[1]), rounded(vector[2])};
}

Function function_of_temperature(const std::vector<std::pair<double, double>>& points) {
  if (points.size() == 1) return rounded(points.front().second);
  std::vector<double> temperatures, values;
  for (const auto& [temperature, value] : points) {
    temperatures.push_back(rounded(temperature));
    values.push_back(rounded(value));
  }
  return Function::table("T", std::move(temperatures), std::move(values));
}

Function function_of_temperature(const Table& table, std::size_t column, std::size_t of_temperature) {
  const auto value = [&](const std::vector<double>& row, std::size_t i) { return i < row.size() ? row[i] : 0.0; };
  std::vector<std::pair<double, double>> points;
  points.reserve(table.rows.size());
  for (const std::vector<double>& row : table.rows) points.emplace_back(value(row, of_temperature), value(row, column));
  return function_of_temperature(points);
}

bool is_increasing(const std::vector<double>& values) {
  return std::ranges::adjacent_find(values, std::greater_equal<>()) == values.end();
}

std::string prefix(const Place& at) {
  return at.file.empty() ? "" : at.text() + ": ";
}

}  // namespace creepcontact::deck
