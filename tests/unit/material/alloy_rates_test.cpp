// Secondary creep of alloys: laws of rates, against numbers that were computed independently.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"
#include "unit/material/pulled_bar.hpp"

namespace creepcontact::material {
namespace alloy_rates {
namespace {

using creepcontact::test::message_of;
using creepcontact::test::says;
using Bar = PulledBar;

Function of_T(const std::string& text) {
  return Function::expression(text, {"T"});
}

double rate(const std::string& name, const ParameterValues& values, double q, double T) {
  return Bar(name, values, T).rate(q);
}

double exponent(const std::string& name, const ParameterValues& values, double q, double T) {
  const double h = 1e-7;
  return std::log(rate(name, values, q * (1 + h), T) / rate(name, values, q, T)) / std::log1p(h);
}

// Alloy 316H at 600 degrees Celsius, in MPa, mm and hours (srlife).
const ParameterValues alloy_316h{{1.5e11}, {-0.24831433}, {-0.49196147}, {2.019e-7}, {1.38064e-20}, {57633.587786}};

TEST(KocksMecking, GivesTheRatesOf316H) {
  constexpr double n = 9.770506677;
  for (const auto& [q, f] : {std::pair(50.0, 4.660961723e-11), std::pair(100.0, 4.070906418e-08),
                             std::pair(150.0, 2.138907194e-06), std::pair(200.0, 3.555549273e-05)}) {
    expect_relative(rate("kocks_mecking", alloy_316h, q, 600), f, 1e-8);
    EXPECT_NEAR(exponent("kocks_mecking", alloy_316h, q, 600), n, 1e-5);
  }
}

TEST(KocksMecking, TheModulusIsATableInTheTemperature) {
  const ParameterValues alloy_230{
      {1.0e13},
      {-0.0935},
      {-0.03291},
      {2.53e-7},
      {1.38064e-20},
      {Function::table("T", {400, 500, 600, 700, 800, 900},
                       {72137.4046, 69847.3282, 67175.5725, 64122.1374, 60687.0229, 56870.229})}};
  expect_relative(rate("kocks_mecking", alloy_230, 150, 750), 0.000318301, 1e-5);
  expect_relative(rate("kocks_mecking", alloy_230, 200, 700), 9.8966263e-05, 1e-7);
}

TEST(KocksMecking, RelaxesABarOf316H) {
  const std::vector<double> times{100, 1000, 10000, 100000};
  const auto bar =
      history("kocks_mecking", alloy_316h, {.stress = 150, .temperature = 600, .young_modulus = 151000}, times);
  const std::array stresses{132.912914, 106.668677, 82.4730334, 63.4641954};
  for (std::size_t i = 0; i < times.size(); ++i) expect_relative(bar[i].stress, stresses[i], 1e-5);
}

TEST(KocksMecking, WantsOneSystemOfUnits) {
  ParameterValues in_metres = alloy_316h;
  in_metres[3] = {2.019e-10};
  EXPECT_TRUE(says(message_of<ParameterError>([&] { make_law("kocks_mecking", in_metres); }),
                   {"burgers", "2.019e-10", "degrees", "2000", "2.5e-7", "1.380649e-20"}));
  in_metres[4] = {1.38064e-23};
  in_metres[5] = {57633.587786e6};
  EXPECT_NEAR(rate("kocks_mecking", in_metres, 100e6, 600), 4.070906418e-08, 1e-16);
}

TEST(KocksMecking, WantsANegativeAAndATemperatureAboveAbsoluteZero) {
  ParameterValues flat = alloy_316h;
  flat[1] = {0.0};
  EXPECT_TRUE(says(message_of<ParameterError>([&] { make_law("kocks_mecking", flat); }), {"A", "0", "< 0"}));
  flat[1] = {of_T("T - 600")};
  EXPECT_LT(0, rate("kocks_mecking", flat, 100, 599));
  EXPECT_TRUE(says(message_of<ModelError>([&] { Bar("kocks_mecking", flat, 601); }), {"A is 1", "< 0"}));
  EXPECT_TRUE(says(message_of<ModelError>([&] { Bar("kocks_mecking", alloy_316h, -300); }),
                   {"-300", "absolute zero", "'absolute_zero'"}));
}

// 316L(N), FZKA 7065 (Rieth and others, 2004), Table 7, in MPa and hours.
const ParameterValues alloy_316ln{{80.0, 100.0, 120.0, 150.0, 170.0, 40.0, 60.0, 80.0, 100.0},
                                  {19e-6, 102e-6, 293e-6, 1653e-6, 3680e-6, 10e-6, 60e-6, 318e-6, 1760e-6},
                                  {700.0, 700.0, 700.0, 700.0, 700.0, 750.0, 750.0, 750.0, 750.0}};

TEST(RateTable, InterpolatesTheRatesOf316LN) {
  struct Expected {
    double T, q, f, n;
  };
  for (const Expected& e : std::initializer_list<Expected>{{700, 100, 0.000102, 5.7876},
                                                           {700, 90, 4.61309459e-05, 7.5312},
                                                           {700, 60, 2.17679595e-06, 7.5312},
                                                           {700, 200, 0.0104030068, 6.3942},
                                                           {750, 70, 0.000146637488, 5.797},
                                                           {725, 90, 0.00019712191, 7.6012},
                                                           {725, 30, 1.94567342e-07, 5.9361},
                                                           {690, 90, 4.61309459e-05, 7.5312},
                                                           {780, 90, 0.000784610069, 7.6678}}) {
    expect_relative(rate("rate_table", alloy_316ln, e.q, e.T), e.f, 1e-8);
    EXPECT_NEAR(exponent("rate_table", alloy_316ln, e.q, e.T), e.n, 1e-4);
  }
}

TEST(RateTable, TestsComeInAnyOrderAndAtOneTemperatureWithoutT) {
  const ParameterValues mixed{{100.0, 60.0, 80.0, 40.0}, {102e-6, 60e-6, 19e-6, 10e-6}, {700.0, 750.0, 700.0, 750.0}};
  expect_relative(rate("rate_table", mixed, 90, 700), 4.61309459e-05, 1e-8);
  const ParameterValues one{{100.0, 80.0}, {102e-6, 19e-6}};
  EXPECT_EQ(make_law("rate_table", one)->parameters()[0].depends_on_temperature(), false);
  EXPECT_EQ(make_law("rate_table", mixed)->parameters()[0].depends_on_temperature(), true);
  for (const double T : {20.0, 900.0}) expect_relative(rate("rate_table", one, 90, T), 4.61309459e-05, 1e-8);
}

TEST(RateTable, RatesThatHardlyRiseAreLinearBelowTheFirstTest) {
  const ParameterValues flat{{50.0, 100.0, 200.0}, {1e-6, 1.1e-6, 1e-4}};
  EXPECT_NEAR(exponent("rate_table", flat, 70, 500), std::log(1.1) / std::log(2), 1e-5);
  expect_relative(rate("rate_table", flat, 5, 500), 1e-7, 1e-12);
}

TEST(RateTable, NamesTheTestThatCannotBe) {
  const auto message = [](const ParameterValues& values) {
    return message_of<ParameterError>([&] { make_law("rate_table", values); });
  };
  EXPECT_TRUE(says(message({{100.0, 80.0}, {1e-6, 2e-6}}), {"rate", "1e-06", "100", "2e-06", "80", "increase"}));
  EXPECT_TRUE(says(message({{100.0, 80.0}, {1e-6}}), {"rate", "1", "'stress'", "2"}));
  EXPECT_TRUE(says(message({{100.0, 80.0}, {2e-6, 1e-6}, {500.0}}), {"T", "1", "'stress'", "2"}));
  EXPECT_TRUE(says(message({{100.0, 80.0, 60.0}, {2e-6, 1e-6, 1e-7}, {500.0, 500.0, 550.0}}),
                   {"stress", "one test", "550", "two"}));
  EXPECT_TRUE(says(message({{80.0, 80.0}, {2e-6, 1e-6}}), {"stress", "80 twice", "one rate"}));
  EXPECT_TRUE(says(message({{100.0, 80.0}, {2e-6, 1e-6}, {-300.0, -300.0}}), {"T", "-300", "absolute_zero"}));
}

}  // namespace
}  // namespace alloy_rates
}  // namespace creepcontact::material
