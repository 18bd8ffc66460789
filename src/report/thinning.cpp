#include "thinning.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace creepcontact::report {
namespace {

constexpr std::size_t columns = 500;  // four points each

}  // namespace

plot::Series thinned(const plot::Series& series, bool logarithmic) {
  const std::vector<double>&x = series.x, &y = series.y;
  if (x.size() <= 4 * columns) return series;
  const auto at = [&](std::size_t i) { return logarithmic ? std::log(x[i]) : x[i]; };
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::isfinite(at(i))) {
      low = std::min(low, at(i));
      high = std::max(high, at(i));
    }
  struct Column {
    std::size_t first, lowest, highest, last;
  };
  std::vector<std::optional<Column>> all(columns);
  std::set<std::size_t> kept;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(at(i))) {
      // The start of a logarithmic axis has a place of its own.
      if (kept.empty()) kept.insert(i);
      continue;
    }
    if (!std::isfinite(y[i])) continue;
    const double share = high > low ? (at(i) - low) / (high - low) : 0;
    std::optional<Column>& column =
        all[std::min(columns - 1, static_cast<std::size_t>(share * static_cast<double>(columns)))];
    if (!column) {
      column = {i, i, i, i};
      continue;
    }
    if (y[i] < y[column->lowest]) column->lowest = i;
    if (y[i] > y[column->highest]) column->highest = i;
    column->last = i;
  }
  for (const std::optional<Column>& column : all)
    if (column) kept.insert({column->first, column->lowest, column->highest, column->last});
  plot::Series result = series;
  result.x.clear();
  result.y.clear();
  for (const std::size_t i : kept) {
    result.x.push_back(x[i]);
    result.y.push_back(y[i]);
  }
  return result;
}

bool begins_fast(const std::vector<double>& x, const std::vector<double>& y) {
  constexpr double hidden = 0.01, much = 0.3;  // of the axis; of all that the curve does
  if (x.size() < 2) return false;
  const double end = x.front() + hidden * (x.back() - x.front());
  double early = 0, all = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double change = std::abs(y[i] - y[i - 1]);
    if (!std::isfinite(change)) continue;
    all += change;
    if (x[i] <= end) early += change;
  }
  return early > much * all;
}

}  // namespace creepcontact::report
