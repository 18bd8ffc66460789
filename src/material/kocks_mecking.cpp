#include "kocks_mecking.hpp"

#include <fmt/format.h>

#include <cmath>

#include "arrhenius.hpp"
#include "creepcontact/base/error.hpp"

namespace creepcontact::material {
namespace {

using KM = KocksMecking;

double number_of(const ParameterValues& values, KM::Constant constant) {
  return values[constant].at(0)({});
}

void check_kocks_mecking(const ParameterValues& values) {
  if (values[KM::A].at(0).is_zero()) throw ParameterError("A", "the number 0", "values < 0");
  // Metals are well within, wrong units are factors of 145 and more away. Tables give their nearest value here.
  constexpr double smallest = 2e3, largest = 2e6;
  const double mu = values[KM::shear_modulus].at(0)({.T = number_of(values, KM::absolute_zero) + 1000});
  const double b = number_of(values, KM::burgers), k = number_of(values, KM::boltzmann);
  const double degrees = mu * b * b * b / k;
  if (mu > 0.0 && !(degrees >= smallest && degrees <= largest))
    throw ParameterError(
        "burgers",
        fmt::format("{}, with which shear_modulus burgers^3/boltzmann is {:.3g} degrees ({:g} {:g}^3/{:g})", b, degrees,
                    mu, b, k),
        fmt::format("values in one system of units, which give {:g} to {:g} degrees; in N and mm a Burgers vector is "
                    "about 2.5e-7 and boltzmann 1.380649e-20, in N and m 2.5e-10 and 1.380649e-23",
                    smallest, largest));
}

/// F(T).
Function energy_ratio(const ParameterValues& values) {
  const double b = number_of(values, KM::burgers), zero = number_of(values, KM::absolute_zero);
  const double degrees = b * b * b / number_of(values, KM::boltzmann);  // per stress
  const Function& mu = values[KM::shear_modulus].at(0);
  return Function::composed(
      fmt::format("-({})*{:.17g}/(T - ({:.17g}))", mu.text(), degrees, zero), {mu, Function::expression("T", {"T"})},
      [degrees, zero](const std::vector<double>& of) { return -of[0] * degrees / absolute_temperature(of[1], zero); });
}

ParameterValues at_points(const ParameterValues& values) {
  check_kocks_mecking(values);
  const Function &rate0 = values[KM::rate0].at(0), &A = values[KM::A].at(0), &B = values[KM::B].at(0);
  const Function F = energy_ratio(values);
  const Function log_factor =
      Function::composed(fmt::format("ln({}) + ({})*({})", rate0.text(), B.text(), F.text()), {rate0, B, F},
                         [](const std::vector<double>& of) { return std::log(of[0]) + of[1] * of[2]; });
  const Function exponent =
      Function::composed(fmt::format("({})*({})", A.text(), F.text()), {A, F}, [](const std::vector<double>& of) {
        if (!(of[0] < 0.0))
          throw ModelError(
              fmt::format("creep law 'kocks_mecking': A is {} at one of the temperatures of the model; it "
                          "must be < 0 at all of them, so that the rate grows with the stress",
                          of[0]));
        return of[0] * of[1];
      });
  return {{log_factor}, {exponent}, {values[KM::shear_modulus].at(0)}};
}

}  // namespace

KocksMecking::KocksMecking(const ParameterValues& values) : FlowLaw(at_points(values)) {}

EquivalentRate KocksMecking::equivalent_rate(double q, const PointState& at) const {
  const double n = at.parameters[exponent];
  const double f = std::exp(at.parameters[log_factor] + n * std::log(q / at.parameters[modulus]));
  return {f, n * f / q};
}

LawInfo kocks_mecking_info() {
  const double any = -std::numeric_limits<double>::infinity();
  return {"kocks_mecking", "rate = rate0 exp(B F) (q/mu)^(A F), F = -mu b^3/(k (T - absolute_zero))",
          "U. F. Kocks, H. Mecking, 2003; M. C. Messner and others, NEML",
          law_table(Row<KM::rate0>{{.key = "rate0",
                                    .description = "reference rate, not one that occurs [1/time]",
                                    .dimension = unit::per_time}},
                    Row<KM::A>{{.key = "A",
                                .description = "slope of the normalised activation energy k (T - absolute_zero) "
                                               "ln(rate0/rate)/(mu b^3) over ln(q/mu), < 0 [-]",
                                .dimension = unit::none,
                                .minimum = any,
                                .strict = false,
                                .maximum = 0.0}},
                    Row<KM::B>{{.key = "B",
                                .description = "this energy at q = mu, of either sign [-]",
                                .dimension = unit::none,
                                .minimum = any,
                                .strict = false}},
                    Row<KM::burgers>{{.key = "burgers",
                                      .description = "Burgers vector b [length]",
                                      .dimension = unit::length,
                                      .variables = {}}},
                    Row<KM::boltzmann>{
                        {.key = "boltzmann",
                         .description = "Boltzmann's constant k [stress length^3/degree]; the default is for N, mm and "
                                        "degrees Celsius or kelvin; N and m: 1.380649e-23",
                         .dimension = unit::stress * unit::pow(unit::length, 3.0) / unit::degree,
                         .fallback = {{1.380649e-20}},
                         .variables = {}}},
                    Row<KM::shear_modulus>{
                        {.key = "shear_modulus",
                         .description =
                             "shear modulus mu with which A and B were fitted, not that of the elasticity [stress]",
                         .dimension = unit::stress}},
                    Row<KM::absolute_zero>{absolute_zero_key()}),
          construct<KM>};
}

}  // namespace creepcontact::material
