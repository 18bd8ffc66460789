#include "arrhenius.hpp"

#include <fmt/format.h>

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
                              const double zero = values[3], T = values[4];
                              if (!(T > zero))
                                throw ModelError(
                                    fmt::format("temperature {} is not above absolute zero, {}: creep with an "
                                                "activation_energy needs 'absolute_zero' in the unit of your "
                                                "temperatures (-273.15 for degrees Celsius, 0 for kelvin)",
                                                T, zero));
                              return values[0] * std::exp(-values[1] / (values[2] * (T - zero)));
                            });
}

}  // namespace

std::vector<ParameterInfo> with_arrhenius(std::vector<ParameterInfo> own, const std::string& of) {
  const double any = -std::numeric_limits<double>::infinity();
  own.push_back(
      {.key = "activation_energy",
       .description = "activation energy Q: exp(-Q/(R (T - absolute_zero))) multiplies " + of + " [energy/mol]",
       .strict = false,
       .fallback = {{0.0}}});
  own.push_back({.key = "gas_constant",
                 .description = "gas constant R [energy/(mol degree)]",
                 .fallback = {{8.314462618}},
                 .variables = {}});
  own.push_back({.key = "absolute_zero",
                 .description = "absolute zero in your unit of temperature: -273.15 for degrees Celsius, 0 for kelvin",
                 .minimum = any,
                 .strict = false,
                 .fallback = {{-273.15}},
                 .variables = {}});
  return own;
}

ParameterValues activated(ParameterValues values, std::initializer_list<std::size_t> numbers,
                          std::optional<std::size_t> energy) {
  const std::size_t first = values.size() - 3;  // wraps if there are too few, so that at() throws
  const Function Q = values.at(energy.value_or(first)).at(0), R = values.at(first + 1).at(0),
                 zero = values.at(first + 2).at(0);
  if (Q.is_zero()) return values;
  for (const std::size_t number : numbers)
    for (Function& value : values.at(number)) value = activated_function(value, Q, R, zero);
  return values;
}

}  // namespace creepcontact::material
