#include "rate_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "arrhenius.hpp"
#include "lists.hpp"

namespace creepcontact::material {
namespace {

constexpr double min_low_exponent = 1;  // below the first test: the rate per stress stays finite

}  // namespace

std::vector<RateTable::Test> RateTable::sorted_tests(const ParameterValues& values) {
  std::vector<NamedList> lists{{"stress", &values[stress]}, {"rate", &values[rate]}};
  const bool one_temperature = values[T].empty();
  if (!one_temperature) lists.emplace_back("T", &values[T]);
  require_one_length(lists);
  const double zero = values[RateTable::absolute_zero].at(0)({});
  std::vector<Test> tests;
  for (std::size_t i = 0; i < values[stress].size(); ++i) {
    tests.push_back({values[stress][i]({}), values[rate][i]({}), one_temperature ? zero + 1 : values[T][i]({})});
    if (!(tests.back().temperature > zero))
      throw ParameterError("T", fmt::format("the number {}", tests.back().temperature),
                           fmt::format("temperatures above absolute_zero, {}", zero));
  }
  const auto order = [](const Test& test) { return std::tuple(test.temperature, test.stress); };
  std::ranges::sort(tests, {}, order);
  std::size_t n_here = 1;  // tests at the temperature of test i
  for (std::size_t i = 0; i < tests.size(); ++i, ++n_here) {
    const std::string here = one_temperature ? "" : fmt::format(" at T = {}", tests[i].temperature);
    const bool last = i + 1 == tests.size() || tests[i + 1].temperature != tests[i].temperature;
    if (last && n_here < 2)
      throw ParameterError("stress", fmt::format("one test{}", here), "at least two tests per temperature");
    if (last) {
      n_here = 0;
      continue;
    }
    if (tests[i + 1].stress == tests[i].stress)
      throw ParameterError("stress", fmt::format("{} twice{}", tests[i].stress, here),
                           "one rate per stress and temperature, such as the geometric mean of several tests");
    if (!(tests[i + 1].rate > tests[i].rate))
      throw ParameterError("rate",
                           fmt::format("{} at the stress {} after {} at {}{}", tests[i + 1].rate, tests[i + 1].stress,
                                       tests[i].rate, tests[i].stress, here),
                           "rates that increase with the stress; leave out a test that scatters");
  }
  return tests;
}

ParameterValues RateTable::at_points(const std::vector<Test>& tests) {
  std::vector<double> temperatures, numbers;
  for (const Test& test : tests) {
    if (!temperatures.empty() && temperatures.back() == test.temperature) continue;
    numbers.push_back(static_cast<double>(numbers.size()));
    temperatures.push_back(test.temperature);
  }
  return {{Function::table("T", temperatures, numbers)}};
}

RateTable::RateTable(const ParameterValues& values) : RateTable(values, sorted_tests(values)) {}

RateTable::RateTable(const ParameterValues& values, std::vector<Test> tests)
    : FlowLaw(at_points(tests)), absolute_zero_(values[RateTable::absolute_zero].at(0)({})) {
  for (const Test& test : tests) {
    const double above_zero = test.temperature - absolute_zero_;
    if (curves_.empty() || curves_.back().temperature != above_zero) curves_.push_back({above_zero, {}, {}});
    curves_.back().stress.push_back(std::log(test.stress));
    curves_.back().rate.push_back(std::log(test.rate));
  }
}

std::pair<double, double> RateTable::Curve::at(double log_stress) const {
  const auto next = std::upper_bound(stress.begin() + 1, stress.end() - 1, log_stress);
  const std::size_t i = next - stress.begin();
  double exponent = (rate[i] - rate[i - 1]) / (stress[i] - stress[i - 1]);
  if (log_stress < stress.front()) exponent = std::max(exponent, min_low_exponent);
  return {rate[i - 1] + exponent * (log_stress - stress[i - 1]), exponent};
}

EquivalentRate RateTable::equivalent_rate(double q, const PointState& at) const {
  const double log_stress = std::log(q);
  const double number = at.parameters[place];
  const auto j = static_cast<std::size_t>(number);
  auto [value, exponent] = curves_[j].at(log_stress);
  if (number > static_cast<double>(j)) {
    const Curve& warmer = curves_[j + 1];
    const double low = 1 / curves_[j].temperature;
    const double weight = (low - 1 / (at.temperature - absolute_zero_)) / (low - 1 / warmer.temperature);
    const auto [above, exponent_above] = warmer.at(log_stress);
    value += weight * (above - value);
    exponent += weight * (exponent_above - exponent);
  }
  const double f = std::exp(value);
  return {f, exponent * f / q};
}

LawInfo rate_table_info() {
  using Law = RateTable;
  return {
      "rate_table", "ln(rate) linear in ln(q) and in 1/(T - absolute_zero) between measured rates", "yours",
      law_table(Row<Law::stress>{{.key = "stress",
                                  .description = "stresses of the creep tests, at least two per temperature [stress]",
                                  .dimension = unit::stress,
                                  .list = true,
                                  .variables = {}}},
                Row<Law::rate>{{.key = "rate",
                                .description = "steady rates of these tests, which increase with the stress [1/time]",
                                .dimension = unit::per_time,
                                .list = true,
                                .variables = {}}},
                Row<Law::T>{{.key = "T",
                             .description = "temperatures of these tests, one per test; not given: the rates do not "
                                            "depend on the temperature",
                             .dimension = unit::temperature,
                             .minimum = -std::numeric_limits<double>::infinity(),
                             .strict = false,
                             .list = true,
                             .fallback = std::vector<Function>{},
                             .variables = {}}},
                Row<Law::absolute_zero>{absolute_zero_key()}),
      construct<Law>};
}

}  // namespace creepcontact::material
