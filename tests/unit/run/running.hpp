#pragma once
/// Whole runs of the two blocks, and the tables they leave.

#include <cmath>
#include <sstream>

#include "creepcontact/run/run.hpp"
#include "unit/model/blocks.hpp"

namespace creepcontact::run::test {

struct Csv {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;

  explicit Csv(const std::filesystem::path& file) {
    std::istringstream text(read_text(file));
    std::string line, cell;
    std::getline(text, line);
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) columns.push_back(cell);
    while (std::getline(text, line)) {
      rows.emplace_back();
      for (std::istringstream cells(line); std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
      EXPECT_EQ(rows.back().size(), columns.size()) << line;
    }
  }

  std::vector<double> column(const std::string& name) const {
    const auto at = std::find(columns.begin(), columns.end(), name) - columns.begin();
    std::vector<double> values;
    for (const auto& row : rows) values.push_back(row.at(at));
    return values;
  }
  double sum(const std::string& name) const {
    double result = 0;
    for (const double value : column(name)) result += value;
    return result;
  }
};

inline const std::string pressure_probe = R"(
[[probes]]
name = "pressure"
quantity = "contact_pressure"
on = "upper_bottom"
)";

/// Mean pressure of the blocks, pressed with 1 and held: (0.025 / 1) d(sigma)/dt = -(2 + 1) A sigma^4
inline double relaxed_pressure(double t) {
  return std::pow(1 + 3 * (3 * 1e-3 / 0.025) * t, -1.0 / 3);
}

/// Value of a number in a summary.
inline double number_in(const std::string& json, const std::string& key) {
  const std::string begin = "\"" + key + "\": ";
  const std::size_t at = json.find(begin);
  if (at == std::string::npos) throw std::out_of_range("summary.json has no " + key);
  return std::stod(json.substr(at + begin.size()));
}

}  // namespace creepcontact::run::test
