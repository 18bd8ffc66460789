#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "creepcontact/material/life_fraction.hpp"
#include "creepcontact/material/registry.hpp"
#include "ordered_values.hpp"

namespace creepcontact::material {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

class RuptureExpression final : public RuptureData {
 public:
  explicit RuptureExpression(Function time) : time_(std::move(time)) {}
  LifeRate rate(double stress, double temperature) const override {
    const double step = 3e-6;  // relative; errors of the central difference and of rounding are 1e-10
    const auto inverse = [&](double q) {
      const double time = time_({.T = temperature, .q = q});
      return time > 0.0 ? 1.0 / time : no_number;
    };
    return {inverse(stress), (inverse(stress * (1 + step)) - inverse(stress * (1 - step))) / (2 * step * stress)};
  }

 private:
  Function time_;
};

class LarsonMillerData final : public RuptureData {
 public:
  explicit LarsonMillerData(LarsonMiller data) : data_(std::move(data)) {
    for (const double stress : data_.stress) logarithm_.push_back(std::log10(stress));
  }
  LifeRate rate(double stress, double temperature) const override {
    const double above_zero = temperature - data_.absolute_zero;
    if (!(above_zero > 0.0)) return {no_number, no_number};
    const double x = std::log10(stress);
    // The piece that x is in; the first or last one beyond the ends.
    const auto next = std::upper_bound(logarithm_.begin() + 1, logarithm_.end() - 1, x);
    const std::size_t i = next - logarithm_.begin();
    const double slope = (data_.parameter[i] - data_.parameter[i - 1]) / (logarithm_[i] - logarithm_[i - 1]);
    const double P = data_.parameter[i - 1] + slope * (x - logarithm_[i - 1]);
    const double value = data_.time_unit * std::pow(10.0, data_.constant - P / above_zero);
    return {value, -value * slope / (above_zero * stress)};
  }

 private:
  LarsonMiller data_;
  std::vector<double> logarithm_;  // of the stress
};

}  // namespace

std::shared_ptr<const RuptureData> rupture_expression(Function rupture_time) {
  return std::make_shared<RuptureExpression>(std::move(rupture_time));
}

std::shared_ptr<const RuptureData> larson_miller(LarsonMiller data) {
  if (data.stress.size() < 2)
    throw ParameterError("stress", fmt::format("{} values", data.stress.size()), "at least two values");
  if (data.parameter.size() != data.stress.size())
    throw ParameterError("parameter", fmt::format("{} values", data.parameter.size()),
                         fmt::format("as many values as 'stress' has: {}", data.stress.size()));
  require_order("stress", data.stress, true);
  require_order("parameter", data.parameter, false, "values that decrease as the stress increases");
  if (!(data.stress.front() > 0.0))
    throw ParameterError("stress", fmt::format("the number {}", data.stress.front()), "numbers > 0");
  return std::make_shared<LarsonMillerData>(std::move(data));
}

}  // namespace creepcontact::material
