#include "study_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "creepcontact/base/error.hpp"

namespace creepcontact::study {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Times in a file of another program may have fewer digits.
constexpr double same_time = 1e-9;

std::optional<std::size_t> row_at(const std::vector<double>& times, double time) {
  const auto nearest = std::min_element(times.begin(), times.end(),
                                        [&](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
  if (nearest == times.end() || std::abs(*nearest - time) > same_time * std::abs(time)) return std::nullopt;
  return nearest - times.begin();
}

}  // namespace

ReferenceHistory::ReferenceHistory(io::CsvTable table, std::string name,
                                   const std::vector<config::Reference>& quantities)
    : table_(std::move(table)) {
  std::vector<std::string> wanted{"time"};
  for (const config::Reference& quantity : quantities) wanted.push_back(quantity.name);
  std::string missing, found;
  for (const std::string& column : table_.names) found += (found.empty() ? "" : ", ") + column;
  for (const std::string& column : wanted)
    if (table_.column(column) == nullptr) missing += (missing.empty() ? "'" : ", '") + column + "'";
  if (!missing.empty()) throw ConfigError(fmt::format("{}: there is no column {} (found: {})", name, missing, found));
  if (table_.rows() == 0) throw ConfigError(fmt::format("{}: there are no rows", name));
}

ReferenceHistory::Points ReferenceHistory::points(const std::string& quantity,
                                                  const std::vector<double>& run_times) const {
  if (expressions_.empty()) return {*table_.column("time"), *table_.column(quantity)};
  Points result{run_times, {}};
  for (const double time : run_times) result.values.push_back(expressions_.at(quantity)({.t = time}));
  return result;
}

ReferenceHistory::Error ReferenceHistory::error(const io::CsvTable& history, const std::string& quantity,
                                                config::ErrorNorm norm, bool whole) const {
  const std::vector<double>& run_times = *history.column("time");
  const std::vector<double>& run_values = *history.column(quantity);
  const bool final_only = norm == config::ErrorNorm::final;
  const Points reference = points(quantity, run_times);
  double largest = 0, scale = 0;
  std::size_t compared = 0;
  for (std::size_t i = final_only ? reference.times.size() - 1 : 0; i < reference.times.size(); ++i) {
    const double time = reference.times[i], value = reference.values[i];
    if (!std::isfinite(value))
      return {not_known, fmt::format("the reference of '{}' is {} at t = {}", quantity, value, time)};
    scale = std::max(scale, std::abs(value));
    const auto row = row_at(run_times, time);
    if (!row && whole) return {not_known, fmt::format("no output at t = {}, where the reference has one", time)};
    if (!row) continue;
    if (!std::isfinite(run_values[*row]))
      return {not_known, fmt::format("'{}' is {} at t = {}", quantity, run_values[*row], time)};
    largest = std::max(largest, std::abs(run_values[*row] - value));
    ++compared;
  }
  if (compared == 0) return {not_known, "ended before the reference's output times"};
  if (scale == 0)
    return {not_known, fmt::format("the reference of '{}' is zero, so there is no relative error", quantity)};
  return {largest / scale, {}};
}

}  // namespace creepcontact::study
