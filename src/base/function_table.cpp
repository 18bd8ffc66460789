/// Tables in t, periodic or not, and in T, p or gap.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "function_definition.hpp"

namespace creepcontact {
namespace {

const std::string table_variables[] = {"t", "T", "p", "gap"};

std::string written(const std::string& variable, const std::vector<double>& abscissae,
                    const std::vector<double>& values, std::optional<double> period) {
  return fmt::format("{{ {} = {}, values = {}{} }}", variable, abscissae, values,
                     period ? fmt::format(", period = {}", *period) : "");
}

class Table final : public Function::Definition {
 public:
  Table(const std::string& variable, std::vector<double> abscissae, std::vector<double> values,
        std::optional<double> period)
      : Definition(written(variable, abscissae, values, period)),
        variable_(variable),
        argument_(known_variable(variable)),
        abscissae_(std::move(abscissae)),
        values_(std::move(values)),
        period_(period) {
    variables.insert(variable);
  }

  double value(const Arguments& at) const override {
    const double s = at.*argument_;
    return interpolate(period_ && s >= 0 ? std::fmod(s, *period_) : s);
  }

  std::vector<double> breakpoints(double end) const override {
    std::vector<double> points;
    if (variable_ != "t") return points;
    std::unique_copy(abscissae_.begin(), abscissae_.end(), std::back_inserter(points));
    if (!period_) return points;
    if (points.back() < *period_) points.push_back(*period_);  // where it begins again
    const std::size_t n_points = points.size();
    const auto n_periods = static_cast<std::size_t>(std::isfinite(end) ? end / *period_ : 0);
    for (std::size_t k = 1; k <= n_periods; ++k)
      for (std::size_t i = 1; i < n_points; ++i)
        if (const double time = repetition(static_cast<double>(k), points[i]); time <= end) points.push_back(time);
    return points;
  }

  std::optional<double> period() const override { return period_; }
  std::optional<Interval> table_range(const std::string& variable) const override {
    if (variable != variable_) return std::nullopt;
    return Interval{abscissae_.front(), abscissae_.back()};
  }

 private:
  double interpolate(double s) const {
    // The negation sends a NaN to the first branch instead of past the end.
    if (!(s >= abscissae_.front())) return std::isnan(s) ? s : values_.front();
    if (s >= abscissae_.back()) return values_.back();
    const auto i =
        static_cast<std::size_t>(std::upper_bound(abscissae_.begin(), abscissae_.end(), s) - abscissae_.begin());
    const double weight = (s - abscissae_[i - 1]) / (abscissae_[i] - abscissae_[i - 1]);
    return (1 - weight) * values_[i - 1] + weight * values_[i];
  }

  /// The first double at which the value is that of `point` or after it, k periods on: a jump lies exactly there.
  double repetition(double k, double point) const {
    if (point == *period_) {
      k += 1;
      point = 0;
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto phase = [&](double t) { return std::fma(-k, *period_, t); };  // exact where it matters
    double t = k * *period_ + point;
    while (phase(t) < point) t = std::nextafter(t, infinity);
    while (phase(std::nextafter(t, 0.0)) >= point) t = std::nextafter(t, 0.0);
    return t;
  }

  std::string variable_;
  double Arguments::*argument_;
  std::vector<double> abscissae_, values_;
  std::optional<double> period_;
};

void check_period(const std::string& variable, const std::vector<double>& abscissae, double period) {
  if (const std::string mistake = Function::period_error(variable, abscissae, period); !mistake.empty())
    throw std::invalid_argument(mistake);
}

}  // namespace

std::size_t Function::misplaced_point(const std::string& variable, const std::vector<double>& abscissae) {
  for (std::size_t i = 1; i < abscissae.size(); ++i) {
    const bool jump = variable == "t" && abscissae[i] == abscissae[i - 1] && (i < 2 || abscissae[i - 2] < abscissae[i]);
    if (!(abscissae[i] > abscissae[i - 1]) && !jump) return i;
  }
  return abscissae.size();
}

std::string Function::period_error(const std::string& variable, const std::vector<double>& abscissae, double period) {
  if (variable != "t") return fmt::format("a table in {} cannot have a period; only a table in t can repeat", variable);
  if (abscissae.front() != 0)
    return fmt::format("the first point is {}; a table with a period must begin at t = 0", abscissae.front());
  if (!(period > 0) || !std::isfinite(period)) return fmt::format("the period {} is not positive", period);
  if (abscissae.back() > period)
    return fmt::format("the last point {} lies beyond the period {}; all points must lie within one period",
                       abscissae.back(), period);
  return {};
}

Function Function::table(const std::string& variable, std::vector<double> abscissae, std::vector<double> values,
                         std::optional<double> period) {
  if (std::ranges::find(table_variables, variable) == std::end(table_variables))
    throw std::invalid_argument(
        fmt::format("the variable of a table must be one of {}, not '{}'", fmt::join(table_variables, ", "), variable));
  if (abscissae.empty()) throw std::invalid_argument(fmt::format("the table in {} has no points", variable));
  if (abscissae.size() != values.size())
    throw std::invalid_argument(
        fmt::format("the table has {} points in {} but {} values", abscissae.size(), variable, values.size()));
  const auto finite = [](double number) { return std::isfinite(number); };
  if (!std::all_of(abscissae.begin(), abscissae.end(), finite) || !std::all_of(values.begin(), values.end(), finite))
    throw std::invalid_argument(fmt::format("the table in {} contains a number that is not finite", variable));
  if (const std::size_t i = misplaced_point(variable, abscissae); i < abscissae.size())
    throw std::invalid_argument(fmt::format("the points of the table in {} must increase: {} follows {} (entry {}){}",
                                            variable, abscissae[i], abscissae[i - 1], i + 1,
                                            variable == "t" ? "; for a jump, give the same time twice" : ""));
  if (period) check_period(variable, abscissae, *period);
  if (std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); }))
    return values.front();
  return Function(std::make_shared<Table>(variable, std::move(abscissae), std::move(values), period));
}

}  // namespace creepcontact
