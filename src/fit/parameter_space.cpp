#include "parameter_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "unit_expression.hpp"

namespace creepcontact::fit {
namespace {

constexpr double largest_exponent = 1e3;  // of parameters without unit
constexpr double largest_scaled = 1e12;   // of the others
constexpr double smallest_exponent = 1e-3;

double median(std::vector<double> values) {
  if (values.empty()) return 1;
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

/// 0.01 of strain at the rate counts as the time of a rate.
double time_of(const Test& test, const Reading& reading) {
  if (test.kind == TestKind::rupture) return reading.value;
  if (test.kind == TestKind::rate && std::isnan(reading.time)) return 0.01 / reading.value;
  return reading.time;
}

}  // namespace

ParameterSpace::ParameterSpace(const LawChoice& choice, const TestData& data) : choice_(choice) {
  std::vector<double> stresses, times, temperatures;
  for (const Test& test : data.tests) {
    stresses.push_back(std::log(test.stress));
    temperatures.push_back(test.temperature);
    for (const Reading& reading : test.readings)
      if (time_of(test, reading) > 0) times.push_back(std::log(time_of(test, reading)));
  }
  stress_ = std::exp(median(stresses));
  time_ = std::exp(median(times));
  for (std::size_t i = 0; i < choice.info->parameters.size(); ++i)
    if (choice.info->parameters[i].key == "gas_constant") thermal_energy_ = choice.held[i].front()({});
  if (data.has_temperature) {
    const auto [coldest, hottest] = std::ranges::minmax(temperatures);
    const double a = coldest - choice.temperature_at_zero, b = hottest - choice.temperature_at_zero;
    if (a > 0) {
      temperature_ = choice.temperature_at_zero + 2 / (1 / a + 1 / b);
      thermal_energy_ *= 2 / (1 / a + 1 / b);
    }
  }
  find_activated();
}

bool ParameterSpace::has_dimension(std::size_t i) const {
  const std::string unit = unit_in(parameter(i).description);
  return unit_uses(unit, "stress") || unit_uses(unit, "time");
}

void ParameterSpace::find_activated() {
  for (std::size_t i = 0; i < size(); ++i) {
    const auto energy = std::ranges::find(choice_.fitted, parameter(i).energy);
    activated_by_.emplace_back();
    if (energy != choice_.fitted.end()) activated_by_.back() = energy - choice_.fitted.begin();
  }
}

double ParameterSpace::activation(std::size_t i, const Eigen::VectorXd& fitted) const {
  if (!activated_by_[i]) return 1;
  const double exponent = fitted[static_cast<Eigen::Index>(*activated_by_[i])] / thermal_energy_;
  return std::exp(parameter(i).activation == material::Activation::time ? exponent : -exponent);
}

double ParameterSpace::unit(std::size_t i, const Eigen::VectorXd& fitted) const {
  if (is_energy(i)) return thermal_energy_;
  const auto word = [&](const std::string& name) -> std::optional<double> {
    if (name == "stress") return stress_;
    if (name == "time") return time_;
    for (std::size_t k = 0; k < size(); ++k)
      if (parameter(k).key == name) return fitted[static_cast<Eigen::Index>(k)];
    for (std::size_t k = 0; k < choice_.info->parameters.size(); ++k)
      if (choice_.info->parameters[k].key == name && !choice_.held[k].empty()) return choice_.held[k].front()({});
    return std::nullopt;
  };
  return unit_value(unit_in(parameter(i).description), word).value_or(1);
}

Eigen::VectorXd ParameterSpace::values(const Eigen::VectorXd& x) const {
  Eigen::VectorXd fitted = Eigen::VectorXd::Ones(x.size());
  for (int pass = 0; pass < 2; ++pass)  // exponents, and then what has them in its unit
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      fitted[i] = (is_logarithmic(k) ? std::exp(x[i]) : x[i]) * unit(k, fitted) / activation(k, fitted);
      if (is_logarithmic(k)) fitted[i] = std::min(fitted[i], parameter(k).maximum);  // but for rounding
    }
  return fitted;
}

Eigen::MatrixXd ParameterSpace::slopes(const Eigen::VectorXd& x) const {
  constexpr double step = 1e-5;
  Eigen::MatrixXd result(x.size(), x.size());
  const auto observed = [&](const Eigen::VectorXd& at) {
    Eigen::VectorXd value = values(at);
    for (Eigen::Index i = 0; i < x.size(); ++i)
      if (is_logarithmic(static_cast<std::size_t>(i))) value[i] = std::log(value[i]);
    return value;
  };
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    Eigen::VectorXd high = x, low = x;
    high[j] += step;
    low[j] -= step;
    result.col(j) = (observed(high) - observed(low)) / (2 * step);
  }
  return result;
}

material::ParameterValues ParameterSpace::all_values(const Eigen::VectorXd& fitted) const {
  material::ParameterValues all = choice_.held;
  for (std::size_t i = 0; i < size(); ++i) all[choice_.fitted[i]] = {fitted[static_cast<Eigen::Index>(i)]};
  return all;
}

std::shared_ptr<const material::CreepLaw> ParameterSpace::law(const Eigen::VectorXd& x) const {
  return choice_.info->make(all_values(values(x)));
}

Eigen::VectorXd ParameterSpace::bounds(bool low) const {
  Eigen::VectorXd result(static_cast<Eigen::Index>(size()));
  for (std::size_t i = 0; i < size(); ++i) {
    const double most = has_dimension(i) ? largest_scaled : largest_exponent;
    double& bound = result[static_cast<Eigen::Index>(i)];
    if (!is_logarithmic(i))
      bound = low ? std::max(parameter(i).minimum, -most) : std::min(parameter(i).maximum, most);
    else if (has_dimension(i))
      bound = low ? -std::log(most) : std::log(most);
    else
      bound = std::log(low ? std::max(parameter(i).minimum, smallest_exponent) : std::min(parameter(i).maximum, most));
  }
  return result;
}

Eigen::VectorXd ParameterSpace::lowest_guess(double strain) const {
  Eigen::VectorXd result(static_cast<Eigen::Index>(size()));
  for (std::size_t i = 0; i < size(); ++i) {
    double& guess = result[static_cast<Eigen::Index>(i)];
    if (!is_logarithmic(i))
      guess = -1;
    else if (is_energy(i))
      guess = std::log(15);
    else if (has_dimension(i))
      guess = std::log(0.1 * strain);
    else
      guess = std::log(parameter(i).maximum <= 1 ? 0.1 * parameter(i).maximum : std::max(parameter(i).minimum, 0.5));
  }
  return result.cwiseMax(lower());
}

Eigen::VectorXd ParameterSpace::highest_guess() const {
  Eigen::VectorXd result(static_cast<Eigen::Index>(size()));
  for (std::size_t i = 0; i < size(); ++i) {
    double& guess = result[static_cast<Eigen::Index>(i)];
    if (!is_logarithmic(i))
      guess = 1;
    else if (is_energy(i))
      guess = std::log(60);
    else
      guess = std::log(has_dimension(i) ? 10 : std::min(parameter(i).maximum, 12.0));
  }
  return result.cwiseMin(upper());
}

std::size_t ParameterSpace::amplitude() const {
  for (std::size_t i = 0; i < size(); ++i)
    if (has_dimension(i)) return i;
  return size();
}

}  // namespace creepcontact::fit
