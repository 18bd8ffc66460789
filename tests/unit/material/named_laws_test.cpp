// Numbers of the laws that are known by their names: curves at constant stress against their formulas, steps of the
// stress, rupture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "../../../src/material/hardening_law.hpp"
#include "creepcontact/material/registry.hpp"
#include "support/says.hpp"
#include "unit/material/pulled_bar.hpp"

namespace creepcontact::material {
namespace named_laws {
namespace {

using Bar = PulledBar;

Function of(const std::string& text) {
  return Function::expression(text, {"q", "T"});
}

constexpr double strain_word = 0, time_word = 1;  // of norton_bailey's key `hardening`

TEST(NortonBailey, BothHardeningsAreEqualAtConstantStress) {
  Bar strain("norton_bailey", {{1e-13}, {5.0}, {0.4}, {strain_word}});
  Bar time("norton_bailey", {{1e-13}, {5.0}, {0.4}, {time_word}});
  for (Bar* bar : {&strain, &time}) {
    bar->grow(120, 10);
    EXPECT_NEAR(bar->strain(), 1e-13 * std::pow(120, 5) * std::pow(10, 0.4), 1e-13);
    bar->integrate(120, 30, 200);
    EXPECT_NEAR(bar->strain(), 1e-13 * std::pow(120, 5) * std::pow(40, 0.4), 1e-9 * bar->strain());
  }
}

TEST(NortonBailey, TheyDifferAtAStepOfTheStress) {
  const double A = 1e-13, n = 5, m = 0.4;
  Bar strain("norton_bailey", {{A}, {n}, {m}, {strain_word}}), time("norton_bailey", {{A}, {n}, {m}, {time_word}});
  for (Bar* bar : {&strain, &time}) {
    bar->grow(80, 100);
    bar->grow(120, 100);
  }
  const double before = A * std::pow(80, n) * std::pow(100, m), after = A * std::pow(120, n);
  EXPECT_NEAR(time.strain(), before + after * (std::pow(200, m) - std::pow(100, m)), 1e-12);
  const double shift = std::pow(before / after, 1 / m);  // when material under 120 has the strain
  EXPECT_NEAR(strain.strain(), after * std::pow(shift + 100, m), 1e-12);
  EXPECT_GT(strain.strain(), 1.2 * time.strain());
}

TEST(NortonBailey, HardensByStrainUnlessSaid) {
  const LawInfo* info = find_creep_law("norton_bailey");
  const auto& hardening = info->parameters.at(3);
  EXPECT_EQ(hardening.key, "hardening");
  EXPECT_EQ(hardening.words.at(static_cast<std::size_t>(hardening.fallback->at(0)({}))), "strain");
  EXPECT_EQ(Bar("norton_bailey", {{1e-13}, {5.0}, {0.4}}).internal().size(), 1u);
  EXPECT_TRUE(Bar("norton_bailey", {{1e-13}, {5.0}, {1.4}, {time_word}}).internal().empty());
  EXPECT_THROW(Bar("norton_bailey", {{1e-13}, {5.0}, {1.4}}), ParameterError);
}

TEST(Soderberg, FollowsItsCurve) {
  const double C = 1e-8, p = 3, r = 0.05, A = 1e-14, n = 5;
  const auto curve = [=](double q, double t) {
    return C * std::pow(q, p) * (1 - std::exp(-r * t)) + A * std::pow(q, n) * t;
  };
  Bar closed("soderberg", {{C}, {p}, {r}, {A}, {n}}), integrated("soderberg", {{C}, {p}, {r}, {A}, {n}});
  closed.grow(120, 30);
  integrated.integrate(120, 30, 100);
  EXPECT_NEAR(closed.strain(), curve(120, 30), 1e-13 * curve(120, 30));
  EXPECT_NEAR(integrated.strain(), curve(120, 30), 1e-8 * curve(120, 30));
}

TEST(Soderberg, PrimaryCreepDoesNotRecover) {
  Bar bar("soderberg", {{1e-8}, {3.0}, {0.05}, {1e-14}, {5.0}});
  bar.grow(120, 1e4);
  EXPECT_NEAR(bar.value(hardening_strain, 0), 1e-8 * std::pow(120, 3), 1e-12);
  EXPECT_NEAR(bar.rate(60), 1e-14 * std::pow(60, 5), 1e-20);
  const double before = bar.strain();
  bar.grow(150, 1e4);  // the limit is higher
  EXPECT_NEAR(bar.strain() - before, 1e-8 * (std::pow(150, 3) - std::pow(120, 3)) + 1e-10 * std::pow(150, 5), 1e-9);
}

TEST(ThetaProjection, FollowsItsCurve) {
  const ParameterValues theta{
      {of("2e-5*q*(1 + (T - 500)/1000)")}, {of("1e-3*q")}, {of("1e-4*exp(q/100)")}, {of("1e-4*q")}};
  const double q = 150, t = 40;
  const double expected = 2e-5 * q * (1 - std::exp(-1e-3 * q * t)) + 1e-4 * std::exp(1.5) * std::expm1(1e-4 * q * t);
  Bar closed("theta_projection", theta), integrated("theta_projection", theta);
  closed.grow(q, t);
  integrated.integrate(q, t, 400);
  EXPECT_NEAR(closed.strain(), expected, 1e-14);
  EXPECT_NEAR(integrated.strain(), expected, 1e-9 * expected);
}

TEST(ThetaProjection, GoesOnFromTheStrainReached) {
  const ParameterValues theta{{of("2e-5*q")}, {0.1}, {of("1e-6*q")}, {0.01}};
  Bar bar("theta_projection", theta);
  bar.grow(100, 50);
  const double e1 = 2e-3 * (1 - std::exp(-5.0)), e3 = 1e-4 * std::expm1(0.5);
  EXPECT_NEAR(bar.rate(150), 0.1 * (3e-3 - e1) + 0.01 * (1.5e-4 + e3), 1e-15);
  EXPECT_NEAR(bar.rate(80), 0.01 * (8e-5 + e3), 1e-15);  // primary creep is over at this stress
}

TEST(RccMr, FollowsItsCurve) {
  // Primary creep up to t_fp = 1e7 100^-2 = 1000, where both rates are equal
  const double C1 = 1e-13, C2 = 0.4, n1 = 5, n = 5.5, C3 = 1e7, n3 = -2;
  const double primary = C1 * std::pow(100, n1), secondary = C2 * primary * std::pow(1000, C2 - 1);
  Bar bar("rcc_mr", {{C1}, {C2}, {n1}, {secondary / std::pow(100, n)}, {n}, {C3}, {n3}});
  bar.grow(100, 400);
  EXPECT_NEAR(bar.strain(), primary * std::pow(400, C2), 1e-15);
  EXPECT_NEAR(bar.rate(100), C2 * primary * std::pow(400, C2 - 1), 1e-15);
  bar.grow(100, 1600);
  EXPECT_NEAR(bar.strain(), primary * std::pow(1000, C2) + secondary * 1000, 1e-14);
  EXPECT_NEAR(bar.rate(100), secondary, 1e-18);
}

TEST(RccMr, AfterAnEarlyEndOfPrimaryCreepTheRateFallsSteeply) {
  const double C1 = 1e-13, C2 = 0.4, n1 = 5, C = 2e-17, n = 5.5, C3 = 1e7, n3 = -2;
  const double primary = C1 * std::pow(100, n1), secondary = C * std::pow(100, n);
  const double end_rate = C2 * primary * std::pow(1000, C2 - 1);
  ASSERT_GT(end_rate, 3 * secondary);
  const ParameterValues values{{C1}, {C2}, {n1}, {C}, {n}, {C3}, {n3}};
  Bar bar("rcc_mr", values), integrated("rcc_mr", values);
  for (Bar* each : {&bar, &integrated}) each->grow(100, 1000);
  EXPECT_NEAR(bar.rate(100), end_rate, 1e-9 * end_rate);
  bar.grow(100, 100);
  integrated.integrate(100, 100, 1000);
  EXPECT_NEAR(integrated.strain(), bar.strain(), 1e-9 * bar.strain());
  EXPECT_NEAR(integrated.rate(100), bar.rate(100), 1e-6 * bar.rate(100));
  bar.grow(100, 2900);
  EXPECT_NEAR(bar.rate(100), secondary, 1e-18);
  const double formula = primary * std::pow(1000, C2) + secondary * 3000;
  EXPECT_GT(bar.strain(), formula);
  EXPECT_NEAR(bar.strain(), formula, 0.04 * formula);
}

TEST(RccMr, PrimaryCreepGoesOnWhereTheStressRises) {
  const ParameterValues values{{1e-13}, {0.4}, {5.0}, {5e-17}, {5.5}, {1e7}, {-2.0}};
  Bar bar("rcc_mr", values);
  bar.grow(100, 1000 * (1 + 1e-9));
  const double reached = bar.strain(), after = 1e-13 * std::pow(130, 5);
  EXPECT_NEAR(bar.rate(130), 0.4 * after * std::pow(reached / after, 1 - 2.5), 1e-6 * bar.rate(130));
  EXPECT_NEAR(bar.rate(90), 5e-17 * std::pow(90, 5.5), 1e-20);
}

TEST(RccMr, WithoutAnEndOfPrimaryCreepTheRateIsContinuous) {
  const double C1 = 1e-13, C2 = 0.4, n1 = 5, C = 1e-15, n = 5.5;
  Bar bar("rcc_mr", {{C1}, {C2}, {n1}, {C}, {n}});
  const double primary = C1 * std::pow(100, n1), secondary = C * std::pow(100, n);
  const double end = std::pow(C2 * primary / secondary, 1 / (1 - C2));
  bar.grow(100, 0.999999 * end);
  EXPECT_NEAR(bar.rate(100), secondary, 1e-5 * secondary);
  EXPECT_GT(bar.rate(100), secondary);
  bar.grow(100, end);
  EXPECT_NEAR(bar.rate(100), secondary, 1e-15 * secondary);
  EXPECT_NEAR(bar.strain(), primary * std::pow(end, C2) + 0.999999 * secondary * end, 1e-9 * bar.strain());
  Bar without_secondary("rcc_mr", {{C1}, {C2}, {n1}, {0.0}, {n}});
  without_secondary.grow(100, 1e9);
  EXPECT_NEAR(without_secondary.strain(), primary * std::pow(1e9, C2), 1e-12 * without_secondary.strain());
  Bar without_primary("rcc_mr", {{0.0}, {C2}, {n1}, {C}, {n}});
  without_primary.grow(100, 10);
  EXPECT_NEAR(without_primary.strain(), 10 * secondary, 1e-18);
}

TEST(RccMr, TheTimeExponentIsANumberInItsRange) {
  try {
    Bar("rcc_mr", {{1e-13}, {1.2}, {5.0}, {1e-16}, {5.5}});
    FAIL() << "accepted";
  } catch (const ParameterError& error) {
    EXPECT_EQ(error.key(), "C2");
    EXPECT_TRUE(creepcontact::test::says(error.what(), {"1.2", "(0, 1]"}));
  }
}

TEST(Omega, FollowsItsCurveUpToRupture) {
  // t_r = 1/(omega rate0) = 1/(40 1e-20 100^8) = 250 at 100
  const ParameterValues values{{of("1e-20*q^8")}, {40.0}};
  const double rupture = 1 / (40 * 1e-20 * std::pow(100, 8));
  EXPECT_DOUBLE_EQ(rupture, 250);
  for (const double part : {0.1, 0.5, 0.9, 0.99}) {
    Bar bar("omega", values);
    bar.integrate(100, part * rupture, 4000);
    EXPECT_NEAR(bar.strain(), -std::log(1 - part) / 40, 1e-7 * bar.strain());
    EXPECT_NEAR(bar.value(damage, 100), part, 1e-7);
    EXPECT_NEAR(1 / bar.value(remaining_life, 100), (1 - part) * rupture, 1e-5 * (1 - part) * rupture);
    EXPECT_NEAR(bar.rate(100), 1e-20 * std::pow(100, 8) * std::exp(40 * bar.strain()), 1e-6 * bar.rate(100));
  }
}

TEST(Omega, RemainingLifeIsThatAtThePresentStress) {
  Bar bar("omega", {{of("1e-20*q^8")}, {of("20 + 2000/q")}});
  bar.integrate(100, 50, 500);
  const double eps = bar.strain();
  EXPECT_NEAR(1 / bar.value(remaining_life, 120),
              std::exp(-(20 + 2000.0 / 120) * eps) / ((20 + 2000.0 / 120) * 1e-20 * std::pow(120, 8)), 1e-7);
  EXPECT_EQ(bar.value(remaining_life, 0), 0);  // the reciprocal: it lives forever
}

TEST(Omega, IsActivatedByTemperature) {
  const double Q = 400e3, R = 8.314462618;
  Bar bar("omega", {{of("1e5*q^8")}, {40.0}, {0.0}, {0.0}, {1.0}, {0.33}, {0.0}, {0.0}, {Q}});
  EXPECT_NEAR(bar.rate(100), 1e21 * std::exp(-Q / (R * 773.15)), 1e-12 * bar.rate(100));
}

/// The polynomials of API 579-1 in log10 of the stress in ksi mean nothing far below their range.
TEST(Omega, BelowTheSmallestStressTheRateIsProportional) {
  const Function rate0 = of("10^(-20 + 5*(log10(q/6.895) - 1)^2)");
  Bar without("omega", {{rate0}, {40.0}}), with("omega", {{rate0}, {40.0}, {20.0}});
  EXPECT_GT(without.rate(1e-6), 1e100);
  EXPECT_NEAR(with.rate(1e-6), with.rate(20.0) * 1e-6 / 20, 1e-12 * with.rate(1e-6));
  EXPECT_EQ(with.rate(30.0), without.rate(30.0));
}

TEST(Omega, ANegativeRateIsNoNumber) {
  EXPECT_TRUE(std::isnan(Bar("omega", {{of("1e-9*(q - 50)")}, {40.0}}).rate(40)));
}

TEST(Activation, MultipliesTheRateOfEveryLaw) {
  const double Q = 200e3, R = 8.314462618, factor = std::exp(-Q / (R * 773.15));
  const std::map<std::string, ParameterValues> laws{
      {"norton", {{1.0}, {3.0}}},
      {"garofalo", {{1.0}, {0.01}, {3.0}}},
      {"time_hardening", {{1.0}, {3.0}, {1.0}}},
      {"strain_hardening", {{1.0}, {3.0}, {1.0}}},
      {"norton_bailey", {{1.0}, {3.0}, {1.0}, {time_word}}},
      {"graham_walles", {{1.0, 2.0}, {3.0, 4.0}, {1.0, 1.0}}},
      {"ageing", {{1.0}, {3.0}, {1.0}}},
      {"soderberg", {{1.0}, {3.0}, {1.0}, {1.0}, {3.0}}},
      {"rcc_mr", {{1.0}, {1.0}, {3.0}, {1.0}, {3.0}, {0.0}, {0.0}}},
      {"blackburn",
       {{1.0}, {0.01}, {3.0}, {1.0}, {1.0}, {1.0}, {0.0}, {1e-3}, {0.0}, {}, {}, {0.0}, {3.6}, {0.0}, {1.0}, {1.0}}},
      {"kachanov_rabotnov", {{1.0}, {3.0}, {0.0}, {3.0}, {3.0}, {0.0}, {0.0}}},
      {"omega", {{1.0}, {40.0}, {0.0}, {0.0}, {1.0}, {0.33}, {0.0}, {0.0}}},
      {"anand", {{1.0}, {2.0}, {0.5}, {60.0}, {0.0}, {0.0}, {1.0}, {250.0}}},
      {"hereditary", {{1.0}, {2.0}, {}, {1.0}}},
      {"kelvin_voigt", {{1.0}, {2.0}}},
      {"maxwell", {{3.0}}},
      {"burgers", {{3.0}, {1.0}, {2.0}}}};
  for (const LawInfo& law : creep_laws()) {
    const bool is_activated =
        std::ranges::find(law.parameters, "activation_energy", &ParameterInfo::key) != law.parameters.end();
    // Others take functions of the temperature, the absolute temperature itself, or resistances (chaboche, lemaitre).
    static const std::set<std::string> others{"expression",    "theta_projection", "chaboche", "lemaitre",
                                              "kocks_mecking", "rate_table",       "hayhurst", "booker"};
    const bool by_functions = others.contains(law.name);
    EXPECT_NE(is_activated, by_functions) << law.name;
    if (!is_activated) continue;
    ASSERT_TRUE(laws.contains(law.name)) << law.name;
    ParameterValues with = laws.at(law.name);
    Bar cold(law.name, with);
    with.push_back({Q});
    Bar bar(law.name, with);
    cold.wait(1);
    bar.wait(1);
    EXPECT_GT(bar.rate(50), 0) << law.name;
    EXPECT_NEAR(bar.rate(50), factor * cold.rate(50), 1e-12 * bar.rate(50)) << law.name;
  }
}

TEST(KachanovRabotnov, DamageHasAnActivationEnergyOfItsOwn) {
  const double Q = 300e3, R = 8.314462618;
  Bar bar("kachanov_rabotnov", {{1e-13}, {5.0}, {1.0}, {4.0}, {6.0}, {0.0}, {Q}});
  EXPECT_NEAR(bar.rate(100), 1e-3, 1e-12);
  EXPECT_NEAR(1 / bar.value(remaining_life, 100), 1 / (7 * std::exp(-Q / (R * 773.15)) * 1e8), 1e-3);
}

}  // namespace
}  // namespace named_laws
}  // namespace creepcontact::material
