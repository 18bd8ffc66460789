// Laws of primary and tertiary creep whose constants are published for single steels, against numbers that were
// computed independently.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../../../src/material/hardening_law.hpp"
#include "unit/material/pulled_bar.hpp"

namespace creepcontact::material {
namespace steel_curves {
namespace {

using Bar = PulledBar;

Function of_T(const std::string& text) {
  return Function::expression(text, {"T"});
}

// Grade 92, code_aster's test ssnv225a, in MPa and hours.
ParameterValues grade_92(double alpha = 0.5, double word = 0) {
  return {{of_T("5.2e7*exp(-3e5/(8.314*(T + 273)))")},
          {of_T("38.5 - 0.033*(T + 273)")},
          {3e4},
          {0.33},
          {of_T("0.035*exp(4.85e4/(8.314*(T + 273)))")},
          {1.0},
          {-280.0},
          {1.0},
          {0.0},
          {0.0},
          {of_T("9e4*exp(-2e5/(8.314*(T + 273)))")},
          {alpha},
          {word}};
}

TEST(Hayhurst, FollowsTheCurveOfCodeAster) {
  Bar bar("hayhurst", grade_92(), 600);
  for (int i = 0; i < 2000; ++i) bar.integrate(160 * (i + 0.5) / 2000, 0.05, 1);  // the load rises in 100 h
  struct Printed {
    double time, p, H1, H2, D;
  };
  double time = 100;
  for (const Printed& printed : std::initializer_list<Printed>{{100, 1.29608e-3, 0.0772226, -0.00248806, 2.58767e-4},
                                                               {500, 8.25704e-3, 0.261472, -0.0146697, 6.22759e-3},
                                                               {1000, 1.15009e-2, 0.292713, -0.0203465, 0.0136886},
                                                               {2000, 1.68407e-2, 0.316306, -0.0296912, 0.0286107}}) {
    if (printed.time > time) bar.integrate(160, printed.time - time, static_cast<int>(printed.time - time));
    time = printed.time;
    expect_relative(bar.strain(), printed.p, 5e-4);
    expect_relative(bar.internal()[0], printed.H1, 5e-4);
    expect_relative(bar.internal()[1], printed.H2, 5e-4);
    expect_relative(bar.value(damage, 160), printed.D, 5e-4);
  }
}

TEST(Hayhurst, CreepsAtAllTemperatures) {
  struct Expected {
    double T, q, t, p;
  };
  for (const Expected& e : std::initializer_list<Expected>{{600, 160, 1, 0.000360221},
                                                           {600, 160, 100, 0.0049493},
                                                           {600, 160, 4000, 0.0316482},
                                                           {600, 100, 4000, 0.00168132},
                                                           {550, 160, 1000, 0.00161632},
                                                           {650, 80, 4000, 0.00452959}})
    expect_relative(history("hayhurst", grade_92(), {.stress = e.q, .temperature = e.T}, {e.t})[0].creep_strain, e.p,
                    2e-5);
}

TEST(Hayhurst, RupturesBySofteningBeforeTheDamageIsLarge) {
  const std::shared_ptr<const CreepLaw> law = make_law("hayhurst", grade_92());
  const std::vector<double> times{1e5};
  const BarHistory bar = bar_history({&law, 1}, {.stress = 160, .temperature = 600}, times);
  ASSERT_TRUE(bar.rupture);
  EXPECT_NEAR(*bar.rupture, 6441.6, 1);
}

TEST(Hayhurst, RelaxesABar) {
  const std::vector<double> times{1, 10, 100, 1000, 1e4, 1e5};
  const auto bar = history("hayhurst", grade_92(), {.stress = 160, .temperature = 600, .young_modulus = 145000}, times);
  const std::array stresses{141.204, 121.174, 99.8987, 78.1807, 55.9748, 33.041};
  for (std::size_t i = 0; i < times.size(); ++i) expect_relative(bar[i].stress, stresses[i], 2e-5);
}

TEST(Hayhurst, HasTheClosedFormsOfItsVariables) {
  ParameterValues values = grade_92();
  values[9] = {1e-4};  // kc
  Bar bar("hayhurst", values, 600);
  bar.integrate(160, 100, 1000);
  bar.integrate(160, 900, 900);
  const std::vector<double>& z = bar.internal();
  expect_relative(z[0], 0.33 * -std::expm1(-3e4 * bar.strain() / 160), 1e-6);
  expect_relative(z[1], -280 * bar.strain() / 160, 1e-9);
  expect_relative(std::pow(1 - z[2], -3), 1 + 1e-4 * 1000, 1e-9);
  expect_relative(bar.value(damage, 160), 1000 / 67014.9, 1e-5);
}

TEST(Hayhurst, WithoutDamageItNeedsNoStressScale) {
  Bar bar("hayhurst", {{1e-10}, {10.0}, {0.0}, {0.0}, {}});
  expect_relative(bar.rate(160), 1e-10 * std::sinh(16.0), 1e-12);
  bar.integrate(160, 1, 1);
  EXPECT_EQ(bar.value(damage, 160), 0);
  ParameterValues incomplete = grade_92();
  incomplete[4] = {};
  EXPECT_THROW(Bar("hayhurst", incomplete), ParameterError);
}

TEST(Hayhurst, DamageFollowsTheTension) {
  struct Expected {
    std::array<double, 3> principal;
    double p, by_principal, by_trace;
  };
  for (const Expected& e :
       std::initializer_list<Expected>{{{160, 0, 0}, 0.00043107227, 1.4922049e-05, 1.4922049e-05},
                                       {{200, 100, 0}, 0.0016839349, 3.8677693e-05, 0.00023167735},
                                       {{100, 0, -100}, 0.0016839349, 6.4567559e-06, 1.0758091e-06},
                                       {{0, 0, -160}, 0.00043107227, 8.4828614e-07, 8.4828614e-07},
                                       {{160, 160, 0}, 0.00043107227, 1.4922049e-05, 0.0002616428},
                                       {{300, 200, 150}, 2.4696721e-05, 0.00011137343, 0.058581418}}) {
    Tensor6 stress = Tensor6::Zero();
    stress.head<3>() << e.principal[0], e.principal[1], e.principal[2];
    for (const double word : {0.0, 1.0}) {
      const auto law = make_law("hayhurst", grade_92(0.5, word));
      std::vector<double> parameters, own(4), virgin(4, 0.0);
      for (const Function& parameter : law->parameters()) parameters.push_back(parameter({.T = 600}));
      Tensor6 strain_rate = Tensor6::Zero();
      law->rate({.stress = tensor::view(stress), .internal = virgin, .parameters = parameters},
                {tensor::writable(strain_rate), own});
      expect_relative(std::sqrt(2.0 / 3) * strain_rate.norm(), e.p, 1e-7);
      expect_relative(own[3], word == 0 ? e.by_principal : e.by_trace, 1e-7);
    }
  }
}

constexpr double psi = 0.00689476;

// Types 316 and 304 from 593 to 649 degrees Celsius (hbbdata, isochronous.py), in psi, percent and hours.
ParameterValues blackburn_316() {
  return {{of_T("5.28787e-6*exp(39057.1/(T + 273.15))")},
          {of_T("-4.257e-4 + 7.733e-7*(T + 273.15)")},
          {of_T("50.1136 - 0.0482143*(T + 273.15)")},
          {of_T("1.44225e-8*exp(45475.8/(T + 273.15))")},
          {of_T("54.5625 - 0.05625*(T + 273.15)")},
          {of_T("2.86941e17 - 3.09286e14*(T + 273.15)")},
          {of_T("-0.271855 + 2.13509e-4*(T + 273.15)")},
          {of_T("6.79633e-5 - 5.33787e-8*(T + 273.15)")},
          {of_T("exp(-274.235 + 1.15598*(T - 336.85) - 0.00115945*(T - 336.85)^2)")},
          {},
          {},
          {2.5e-2},
          {3.6},
          {4000.0},
          {psi},
          {0.01},
          {67000.0},
          {1.987}};
}
ParameterValues blackburn_304() {
  return {{1.38e13},   {of_T("-3.652e-4 + 7.518e-7*(T + 273.15)")},
          {6.0},       {2.518e13},
          {5.0},       {2.518e14},
          {-0.257143}, {4.28571e-5},
          {0.0},       {of_T("-2.252e-4 + 5.407e-7*(T + 273.15)")},
          {3.5},       {0.0},
          {3.6},       {6000.0},
          {psi},       {0.01},
          {67000.0},   {1.987}};
}

TEST(Blackburn, FollowsTheCurvesOf304And316) {
  struct Expected {
    ParameterValues values;
    double T, q;
    std::array<double, 4> strains;  // after 1, 100, 1e4, 1e5 h
  };
  for (const Expected& e : std::initializer_list<Expected>{
           {blackburn_316(), 600, 150, {0.00010600105, 0.0046230984, 0.028328031, 0.20130036}},
           {blackburn_304(), 600, 150, {0.00050477124, 0.011132922, 0.10869315, 0.96386384}},
           {blackburn_304(), 650, 20, {1.878451e-09, 1.8769154e-07, 1.7330219e-05, 9.9379408e-05}},
           {blackburn_304(), 650, 100, {0.00043486655, 0.0072084875, 0.096225762, 0.89345383}},
           {blackburn_304(), 760, 40, {2.5491732e-05, 0.0012116363, 0.043784443, 0.43019055}},
           {blackburn_304(), 800, 30, {2.2021557e-05, 0.00087096817, 0.037772754, 0.37312142}}}) {
    Bar closed("blackburn", e.values, e.T);
    double time = 0;
    for (const auto& [until, strain] : {std::pair(1.0, e.strains[0]), std::pair(100.0, e.strains[1]),
                                        std::pair(1e4, e.strains[2]), std::pair(1e5, e.strains[3])}) {
      closed.grow(e.q, until - time);
      time = until;
      expect_relative(closed.strain(), strain, 1e-7);
    }
    Bar integrated("blackburn", e.values, e.T);
    integrated.integrate(e.q, 100, 1000);
    expect_relative(integrated.strain(), e.strains[1], 1e-6);
  }
}

TEST(Blackburn, HardensByStrain) {
  struct Expected {
    double from, after, to, lasting, before, end, fast, slow;
  };
  for (const Expected& e :
       std::initializer_list<Expected>{{100, 1e3, 150, 1e3, 0.00254449407, 0.0103766934, 0.00379177304, 0.00460959268},
                                       {150, 1e3, 100, 1e3, 0.0102886663, 0.0103420793, 0.00379177304, 0.00457497856},
                                       {150, 1e4, 80, 1e4, 0.028328031, 0.0284090857, 0.00379177304, 0.00531711071}}) {
    Bar bar("blackburn", blackburn_316(), 600);
    bar.grow(e.from, e.after);
    expect_relative(bar.strain(), e.before, 1e-8);
    bar.grow(e.to, e.lasting);
    expect_relative(bar.strain(), e.end, 1e-8);
    expect_relative(bar.internal()[0], e.fast, 1e-8);
    expect_relative(bar.value(hardening_strain, e.to), e.fast + e.slow, 1e-8);
  }
}

TEST(Blackburn, LittleStressHasLittleCreep) {
  for (const ParameterValues& values : {blackburn_304(), blackburn_316()}) {
    Bar bar("blackburn", values, 600);
    bar.grow(1e-30, 1e5);
    EXPECT_GE(bar.strain(), 0);
    EXPECT_LT(bar.strain(), 1e-60);
  }
}

// 2.25Cr-1Mo steel (hbbdata, isochronous.py, Model225Cr), in MPa and hours.
ParameterValues booker() {
  const auto of = [](const std::string& text) { return Function::expression(text, {"q", "T", "U"}); };
  return {{Function::table("T", {20, 50, 100, 150, 200, 250, 300, 350, 400, 450, 500, 550, 600, 621, 650},
                           {508, 486, 464, 455, 456, 462, 469, 473, 468, 452, 418, 364, 284, 300, 269})},
          {of("0.01*10^(1.0328 + 168680/((T + 273.15)*U) - 0.023772*U + 0.0079141*U*log10(q))")},
          {of("10^(7.6026 + 3.3396*log10(q) - 12323/(T + 273.15))")},
          {of("0.01*10^(6.7475 + 0.011426*q + 987.72/U*log10(q) - 13494/(T + 273.15))")},
          {of("0.01*10^(-0.051086 + 140730/((T + 273.15)*U) - 0.01*U + 0.0037345*U*log10(q))")},
          {of("10^(8.1242 + 0.0179678*q + 404.63/U*log10(q) - 11659/(T + 273.15))")},
          {of("0.01*10^(11.498 - 8.2226*U/(T + 273.15) - 20448/(T + 273.15) + 5862.4/(T + 273.15)*log10(q))")},
          {of("(1 - max(0, min(1, (T - 454)/56)))*10^(-13.528 + 6.5196*U/(T + 273.15) + 23349/(T + 273.15) - "
              "5693.8/(T + 273.15)*log10(q)) + max(0, min(1, (T - 454)/56))*10^(-11.098 - 4.0951*q/U + "
              "11965/(T + 273.15))")},
          {372.0}};
}

TEST(Booker, FollowsTheCurvesOf225Cr) {
  const std::vector<double> times{1, 100, 1e3, 1e4, 1e5};
  struct Expected {
    double T, q;
    std::array<double, 5> strains;
  };
  for (const Expected& e :
       std::initializer_list<Expected>{{427, 200, {4.915894e-06, 0.0003340797, 0.0008852518, 0.001495444, 0.006101677}},
                                       {482, 150, {1.428775e-05, 0.0004616431, 0.0009140949, 0.004411472, 0.3258877}},
                                       {500, 100, {1.857105e-06, 0.0001325029, 0.0003095084, 0.00162536, 0.03511272}},
                                       {538, 80, {5.207373e-06, 0.0002735848, 0.002004216, 0.01794551, 0.1681957}},
                                       {550, 80, {1.129416e-05, 0.000512, 0.004623329, 0.03898318, 0.3768424}},
                                       {600, 60, {0.0001081282, 0.00478696, 0.02556085, 0.2241917, 2.209213}},
                                       {649, 40, {0.000115417, 0.003406705, 0.0152208, 0.128686, 1.262753}}}) {
    const auto bar = history("booker", booker(), {.stress = e.q, .temperature = e.T}, times);
    for (std::size_t i = 0; i < times.size(); ++i) expect_relative(bar[i].creep_strain, e.strains[i], 1e-5);
  }
}

TEST(Booker, RelaxesABar) {
  const std::vector<double> times{1, 10, 100, 1e3, 1e4, 1e5};
  struct Expected {
    double T, q, E;
    std::array<double, 6> stresses;
  };
  for (const Expected& e :
       std::initializer_list<Expected>{{500, 150, 170000, {144.171, 122.547, 108.166, 87.8343, 52.404, 35.7563}},
                                       {550, 120, 165000, {103.65, 77.9492, 58.371, 34.6833, 25.9228, 19.5791}}}) {
    const auto bar = history("booker", booker(), {.stress = e.q, .temperature = e.T, .young_modulus = e.E}, times);
    for (std::size_t i = 0; i < times.size(); ++i) expect_relative(bar[i].stress, e.stresses[i], 2e-5);
  }
}

TEST(Booker, ChangesToItsSecondCurve) {
  Bar bar("booker", booker(), 500);
  bar.internal() = {1.0, 0.5};  // far beyond both limits: steady
  expect_relative(bar.rate(100), 1.454646e-07, 1e-4);
  bar.internal()[1] = 1.01;
  expect_relative(bar.rate(100), 5.885919e-07, 1e-4);
  EXPECT_EQ(bar.value(hardening_strain, 100), 1);
  Bar cold("booker", booker(), 372), warm("booker", booker(), 373);
  EXPECT_EQ(cold.rate(200), 0);
  EXPECT_GT(warm.rate(200), 0);
}

TEST(Booker, LittleStressHasLittleCreep) {
  for (const double q : {1e-3, 1e-30, 1e-45, 1e-53, 1e-150})
    for (const double eps : {0.0, 1e-6, 1.0}) {
      Bar bar("booker", booker(), 550);
      bar.internal() = {eps, 0.5};
      EXPECT_GE(bar.rate(q), 0);
      EXPECT_LT(bar.rate(q), 1e-9);
      const StressTangent c = bar.law().stress_tangent(bar.at(q));
      EXPECT_TRUE(std::isfinite(c.deviatoric) && std::isfinite(c.radial)) << q << ' ' << eps;
    }
}

}  // namespace
}  // namespace steel_curves
}  // namespace creepcontact::material
