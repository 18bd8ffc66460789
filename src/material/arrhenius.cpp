#include "arrhenius.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

#include "creepcontact/base/error.hpp"

namespace creepcontact::material {
namespace {

Function activated_function(const Function& A, const Function& Q, const Function& R, const Function& absolute_zero) {
  const std::string text =
      fmt::format("({})*exp(-({})/({}*(T - ({}))))", A.text(), Q.text(), R.text(), absolute_zero.text());
  return Function::composed(text, {A, Q, R, absolute_zero, Function::expression("T", {"T"})},
                            [](const std::vector<double>& values) {
                              const double above_zero = absolute_temperature(values[4], values[3]);
                              return values[0] * std::exp(-values[1] / (values[2] * above_zero));
                            });
}

/// "A", "A and B", "A, B and C"
std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return fmt::format("{}", fmt::join(names, ""));
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

/// The name of the constant in the description of its activation energy.
std::string activated_name(const ParameterInfo& constant) {
  if (constant.activation == Activation::time) return fmt::format("1/`{}`", constant.key);
  return (constant.list ? "all of " : "") + constant.key;
}

}  // namespace

ParameterInfo absolute_zero_key() {
  return {.key = "absolute_zero",
          .description = "absolute zero in your unit of temperature: -273.15 for degrees Celsius, 0 for kelvin",
          .dimension = unit::temperature,
          .minimum = -std::numeric_limits<double>::infinity(),
          .strict = false,
          .fallback = {{-273.15}},
          .variables = {}};
}

double absolute_temperature(double T, double absolute_zero) {
  if (!(T > absolute_zero))
    throw ModelError(fmt::format(
        "temperature {} is not above absolute zero, {}: creep that depends on the absolute temperature "
        "needs 'absolute_zero' in the unit of your temperatures (-273.15 for degrees Celsius, 0 for kelvin)",
        T, absolute_zero));
  return T - absolute_zero;
}

Function inverse(const Function& of) {
  return Function::composed(fmt::format("1/({})", of.text()), {of},
                            [](const std::vector<double>& values) { return 1.0 / values[0]; });
}

std::vector<ParameterInfo> with_arrhenius(std::vector<ParameterInfo> own) {
  const std::size_t energy = own.size() + activation_energy;
  std::vector<std::string> names;
  for (ParameterInfo& constant : own) {
    if (constant.activation == Activation::none || constant.energy) continue;
    constant.energy = energy;
    names.push_back(activated_name(constant));
  }
  own.push_back({.key = "activation_energy",
                 .description = "activation energy Q: exp(-Q/(R (T - absolute_zero))) multiplies " + listed(names) +
                                " [energy/mol]",
                 .dimension = unit::none,
                 .strict = false,
                 .fallback = {{0.0}}});
  own.push_back({.key = "gas_constant",
                 .description = "gas constant R [energy/(mol degree)]",
                 .dimension = unit::per_degree,
                 .fallback = {{8.314462618}},
                 .variables = {}});
  own.push_back(absolute_zero_key());
  return own;
}

Function activation_factor(const ParameterValues& values, std::size_t n_constants) {
  const auto value = [&](ArrheniusConstant constant) { return values.at(n_constants + constant).at(0); };
  const Function Q = value(activation_energy);
  return Q.is_zero() ? Function(1.0) : activated_function(1.0, Q, value(gas_constant), value(absolute_zero));
}

ParameterValues activated(ParameterValues values, const std::vector<ParameterInfo>& table) {
  const std::size_t n_constants = table.size() - n_arrhenius_constants;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Activation kind = table[i].activation;
    if (kind != Activation::rate && kind != Activation::time) continue;
    const Function Q = values.at(table[i].energy.value()).at(0);
    if (Q.is_zero()) continue;
    const Function R = values.at(n_constants + gas_constant).at(0), zero = values.at(n_constants + absolute_zero).at(0);
    for (Function& value : values.at(i))
      value = kind == Activation::rate ? activated_function(value, Q, R, zero)
                                       : inverse(activated_function(inverse(value), Q, R, zero));
  }
  return values;
}

}  // namespace creepcontact::material
