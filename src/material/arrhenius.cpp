#include "arrhenius.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "creepcontact/base/error.hpp"

namespace creepcontact::material {

std::vector<ParameterInfo> with_arrhenius(std::vector<ParameterInfo> own) {
  const double any = -std::numeric_limits<double>::infinity();
  own.push_back({.key = "activation_energy",
                 .description = "activation energy Q in A exp(-Q/(R (T - absolute_zero))) [energy/mol]",
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

Function arrhenius(Function A, const Function& Q, const Function& R, const Function& absolute_zero) {
  if (Q.is_zero()) return A;
  const std::string text =
      fmt::format("({})*exp(-({})/({}*(T - ({}))))", A.text(), Q.text(), R.text(), absolute_zero.text());
  return Function::composed(text, {std::move(A), Q, R, absolute_zero, Function::expression("T", {"T"})},
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

}  // namespace creepcontact::material
