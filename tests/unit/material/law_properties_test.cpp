// What every creep law must fulfil, whatever its formula: one suite over the registry.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <regex>

#include "creepcontact/base/index.hpp"
#include "creepcontact/material/registry.hpp"
#include "unit/material/with_defaults.hpp"

namespace creepcontact::material {
namespace {

struct Sample {
  /// Values that give rates of about 1e-3 at stresses of about 100, in the order of the law's keys.
  ParameterValues parameters;
  Index tensors = 0;         ///< how many of the first internal variables are tensors
  bool closed_form = false;  ///< increment() is exact
};

std::span<const double> numbers(const Eigen::VectorXd& of) {
  return {of.data(), std::size_t(of.size())};
}
std::span<double> numbers(Eigen::VectorXd& of) {
  return {of.data(), std::size_t(of.size())};
}

Function expression_rate(const std::string& text) {
  return Function::expression(text, {"q", "T", "t", "eps"});
}

Function stress_function(const std::string& text) {
  return Function::expression(text, {"q", "T", "U"});
}

const std::map<std::string, Sample> samples{
    {"norton", {{{1e-13}, {5.0}}}},
    {"garofalo", {{{1e-4}, {0.01}, {3.5}}}},
    {"kocks_mecking", {{{1e10}, {-0.06}, {-0.0432}, {2.5e-7}, {1.380649e-20}, {6e4}}}},
    {"rate_table",
     {{{50.0, 100.0, 200.0, 60.0, 150.0}, {2e-5, 3e-4, 2e-2, 1e-3, 5e-2}, {400.0, 400.0, 400.0, 600.0, 600.0}}}},
    {"time_hardening", {.parameters = {{1e-13}, {5.0}, {0.4}}, .closed_form = true}},
    {"graham_walles",
     {.parameters = {{1e-8, 1e-13, 1e-15}, {2.0, 5.0, 5.0}, {1.0 / 3, 1.0, 3.0}}, .closed_form = true}},
    {"strain_hardening", {.parameters = {{1e-13}, {5.0}, {0.4}}, .closed_form = true}},
    {"norton_bailey", {.parameters = {{1e-13}, {5.0}, {0.4}}, .closed_form = true}},
    {"ageing", {{{1e-13}, {5.0}, {0.4}}}},
    {"soderberg", {.parameters = {{1e-8}, {3.0}, {0.5}, {1e-13}, {5.0}}, .closed_form = true}},
    {"rcc_mr", {.parameters = {{1e-13}, {0.4}, {5.0}, {1e-18}, {5.5}, {1e5}, {-2.0}}, .closed_form = true}},
    {"blackburn",
     {.parameters = {{1e-3}, {0.01}, {3.0}, {0.5}, {2.0}, {3.0}, {0.01}, {2e-4}, {0.1}, {0.01}, {2.0}},
      .closed_form = true}},
    {"booker",
     {{{400.0},
       {stress_function("1e-4*q*U/400")},
       {stress_function("1e-3*q^1.5*(1 + T/1000)")},
       {stress_function("1e-7*q^2")},
       {stress_function("4e-4*q")},
       {stress_function("2e-5*q^2*U/400")},
       {stress_function("1e-8*q^2.5")},
       {stress_function("1e3*exp(-q/U)")}}}},
    {"omega",
     {{{stress_function("1e-13*q^5*(1 + T/1000)*exp(q/500)")},
       {stress_function("25 + 200/q")},
       {0.01},
       {1.0},
       {2.0},
       {0.33},
       {-0.1},
       {0.1}}}},
    {"theta_projection",
     {.parameters = {{stress_function("1e-3*q*(1 + T/1000)")},
                     {0.3},
                     {stress_function("1e-10*q^4")},
                     {stress_function("1e-3*q")}},
      .closed_form = true}},
    {"hayhurst", {{{1e-4}, {50.0}, {3e3}, {0.33}, {60.0}, {1.0}, {-280.0}, {1.0}, {0.2}, {0.01}, {1e-4}, {0.4}}}},
    {"kachanov_rabotnov", {{{1e-13}, {5.0}, {1e-12}, {4.0}, {6.0}, {0.6}}}},
    {"lemaitre", {.parameters = {{1500.0}, {8.0}, {6.0}}, .closed_form = true}},
    {"chaboche",
     {.parameters =
          {{400.0}, {6.0}, {10.0}, {30.0}, {8.0}, {900.0, 200.0}, {20.0, 3.0}, {0.01, 0.02}, {1.0, 2.5}, {0.0}},
      .tensors = 2}},
    {"anand", {{{30.0}, {2.0}, {0.3}, {60.0}, {0.02}, {900.0}, {1.3}, {250.0}}}},
    {"hereditary", {.parameters = {{1e-5, 2e-5}, {0.5, 20.0}, {3e-6, 0.0}, {1e-5}}, .tensors = 2, .closed_form = true}},
    {"expression", {{{expression_rate("1e-13*q^4.5*(1 + T/1000)*(t + 1)^-0.4*exp(-3*eps)")}}}},
    {"kelvin_voigt", {.parameters = {{1e-5}, {0.5}}, .tensors = 1, .closed_form = true}},
    {"maxwell", {.parameters = {{1e5}}, .closed_form = true}},
    {"burgers", {.parameters = {{1e5}, {1e-5}, {0.5}}, .tensors = 1, .closed_form = true}},
};

class CreepLawProperties : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const LawInfo* info = find_creep_law(GetParam());
    ASSERT_NE(info, nullptr);
    ASSERT_TRUE(samples.contains(GetParam())) << "give this law a sample at the head of this file";
    sample = samples.at(GetParam());
    ASSERT_LE(sample.parameters.size(), info->parameters.size());
    law = make_law(GetParam(), sample.parameters);
    for (const Function& parameter : law->parameters()) parameters.push_back(parameter({.T = 500.0}));
    ASSERT_EQ(law->name(), GetParam());
    internal = random(law->n_internal(), 0.01, 0.1);
    for (Index i = 0; i < sample.tensors; ++i)
      internal.segment<6>(6 * i) = tensor::deviator(internal.segment<6>(6 * i));
    Tensor6 any = random(6, -150, 150);
    volumetric = law->stress_tangent(point(any)).volumetric != 0.0;
    creep_strain = tensor::deviator(random(6, -0.01, 0.01));
  }

  Eigen::VectorXd random(int size, double low, double high) {
    std::uniform_real_distribution<double> uniform(low, high);
    return Eigen::VectorXd::NullaryExpr(size, [&] { return uniform(generator); });
  }

  PointState point(const Tensor6& stress) const {
    return {.stress = tensor::view(stress),
            .creep_strain = tensor::view(creep_strain),
            .internal = numbers(internal),
            .parameters = parameters,
            .time = 2.0,
            .temperature = 500.0};
  }

  Tensor6 rate(const Tensor6& stress, Eigen::VectorXd* internal_rate = nullptr) const {
    Tensor6 strain_rate = Tensor6::Zero();
    Eigen::VectorXd own(law->n_internal());
    law->rate(point(stress), {tensor::writable(strain_rate), numbers(own)});
    if (internal_rate != nullptr) *internal_rate = own;
    return strain_rate;
  }

  /// Changes of creep strain and of the internal variables.
  std::pair<Tensor6, Eigen::VectorXd> increment(const PointState& at, double duration) const {
    Tensor6 strain = Tensor6::Zero();
    Eigen::VectorXd own = Eigen::VectorXd::Zero(law->n_internal());
    law->increment(at, duration, {tensor::writable(strain), numbers(own)});
    return {strain, own};
  }

  std::mt19937 generator{7};
  Sample sample;
  bool volumetric = false;
  std::vector<double> parameters;
  std::unique_ptr<CreepLaw> law;
  Eigen::VectorXd internal;
  Tensor6 creep_strain;
};

TEST_P(CreepLawProperties, HasTheStateVariablesOfItsEntryInTheRegistry) {
  const std::vector<const StateVariable*>& listed = find_creep_law(GetParam())->state_variables;
  for (const StateVariable* variable : state_variables()) {
    std::vector<double> values(variable->width(), std::numeric_limits<double>::quiet_NaN());
    const Tensor6 stress = random(6, -150, 150);
    const bool known = law->evaluate(*variable, point(stress), values);
    EXPECT_EQ(known, std::ranges::count(listed, variable) == 1) << variable->name;
    if (known) {
      EXPECT_TRUE(std::ranges::all_of(values, [](double v) { return std::isfinite(v); })) << variable->name;
    }
  }
}

/// The constants of a law in other units.
ParameterValues converted(const LawInfo& law, const ParameterValues& values, const UnitChange& change) {
  ParameterValues result = values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const UnitPowers& dimension = law.parameters[i].dimension;
    for (std::size_t k = 0; k < values[i].size(); ++k) {
      const auto other = [&](std::size_t place) {
        const std::vector<Function>& of = values[place];
        return of.empty() ? 1.0 : of.at(of.size() > 1 ? k : 0)({});
      };
      const Function& old = values[i][k];
      const double times = factor(dimension, change, other), plus = dimension.is_temperature() ? change.zero : 0.0;
      if (old.is_constant()) {
        result[i][k] = times * old({}) + plus;
        continue;
      }
      const auto replaced = [](const std::string& text, const char* name, double by, double zero) {
        return std::regex_replace(text, std::regex(fmt::format("\\b{}\\b", name)),
                                  fmt::format("(({} - {})/{})", name, zero, by));
      };
      std::string text = replaced(replaced(old.text(), "q", change.stress, 0.0), "U", change.stress, 0.0);
      text = replaced(replaced(text, "t", change.time, 0.0), "T", change.degree, change.zero);
      result[i][k] = Function::expression(fmt::format("({})*{}", text, times), law.parameters[i].variables);
    }
  }
  return result;
}

TEST_P(CreepLawProperties, DimensionsOfConstantsGiveTheSameRatesInOtherUnits) {
  const UnitChange change{.stress = 0.5, .time = 3.0, .length = 7.0, .degree = 1.8, .zero = 32.0};
  const LawInfo& info = *find_creep_law(GetParam());
  ParameterValues values = sample.parameters;
  for (std::size_t i = values.size(); i < info.parameters.size(); ++i) {
    values.push_back(info.parameters[i].fallback.value());
    if (info.is_activation_energy(i)) values.back() = {2e4};
  }
  // Rates of creep strain and internal variables.
  const auto rates = [&](const ParameterValues& constants, PointState at, double T) {
    const std::unique_ptr<CreepLaw> made = info.make(constants);
    std::vector<double> at_point;
    for (const Function& parameter : made->parameters()) at_point.push_back(parameter({.T = T}));
    at.parameters = at_point;
    at.temperature = T;
    std::pair<Tensor6, Eigen::VectorXd> found{Tensor6::Zero(), Eigen::VectorXd::Zero(made->n_internal())};
    made->rate(at, {tensor::writable(found.first), numbers(found.second)});
    return found;
  };
  for (int i = 0; i < 20; ++i) {
    const Tensor6 stress = random(6, -150, 150), other_stress = change.stress * stress;
    const auto [expected, expected_own] = rates(values, point(stress), 500.0);
    PointState at = point(other_stress);
    at.time *= change.time;
    const auto [found, found_own] = rates(converted(info, values, change), at, change.degree * 500.0 + change.zero);
    const double times = law->is_isochronous() ? 1.0 : change.time;
    EXPECT_GT(expected.norm(), 0.0);
    EXPECT_LE((times * found - expected).norm(), 1e-10 * expected.norm());
    EXPECT_LE((times * found_own - expected_own).norm(), 1e-10 * expected_own.norm());
  }
}

TEST_P(CreepLawProperties, RateIsDeviatoric) {
  for (int i = 0; i < 20; ++i) {
    const Tensor6 f = rate(random(6, -150, 150));
    EXPECT_GT(f.norm(), 0.0);
    if (!volumetric) {
      EXPECT_LT(std::abs(tensor::trace(f)), 1e-12 * f.norm());
    }
  }
}

TEST_P(CreepLawProperties, ZeroOrHydrostaticStressGivesNoRate) {
  if (law->n_internal() > 0) internal.setZero();
  creep_strain.setZero();
  EXPECT_EQ(rate(Tensor6::Zero()).norm(), 0.0);
  if (!volumetric) {
    EXPECT_EQ(rate(100.0 * tensor::identity()).norm(), 0.0);
  }
  const StressTangent c = law->stress_tangent(point(Tensor6::Zero()));
  EXPECT_TRUE(std::isfinite(c.deviatoric) && std::isfinite(c.radial) && std::isfinite(c.volumetric));
}

TEST_P(CreepLawProperties, CreepDissipates) {
  if (law->n_internal() > 0) internal.setZero();
  for (int i = 0; i < 50; ++i) {
    const Tensor6 stress = random(6, -150, 150);
    EXPECT_GE(stress.dot(rate(stress)), 0.0);
  }
}

TEST_P(CreepLawProperties, RateIsAddedToWhatIsThere) {
  const Tensor6 stress = random(6, -150, 150);
  Tensor6 twice = rate(stress);
  Eigen::VectorXd own(law->n_internal());
  law->rate(point(stress), {tensor::writable(twice), numbers(own)});
  EXPECT_LT((twice - 2 * rate(stress)).norm(), 1e-14 * twice.norm());
}

TEST_P(CreepLawProperties, DerivativeIsTheLimitOfCentralDifferences) {
  for (int i = 0; i < 20; ++i) {
    const Tensor6 stress = random(6, -150, 150), strain = creep_strain;
    const Eigen::VectorXd own = internal;
    const Tensor6 d_stress = random(6, -50, 50), d_strain = random(6, -1e-3, 1e-3);
    const Eigen::VectorXd d_own = random(law->n_internal(), -1e-2, 1e-2);
    Tensor6 exact = Tensor6::Zero();
    Eigen::VectorXd exact_own(law->n_internal());
    law->derivative(point(stress), {tensor::view(d_stress), tensor::view(d_strain), numbers(d_own)},
                    {tensor::writable(exact), numbers(exact_own)});

    const double h = 1e-5;
    Eigen::VectorXd plus_own, minus_own;
    creep_strain = strain + h * d_strain;
    internal = own + h * d_own;
    const Tensor6 plus = rate(stress + h * d_stress, &plus_own);
    creep_strain = strain - h * d_strain;
    internal = own - h * d_own;
    const Tensor6 minus = rate(stress - h * d_stress, &minus_own);
    creep_strain = strain;
    internal = own;
    EXPECT_LT((exact - (plus - minus) / (2 * h)).norm(), 1e-7 * exact.norm());
    if (law->n_internal() > 0) {
      EXPECT_LT((exact_own - (plus_own - minus_own) / (2 * h)).norm(), 1e-7 * exact_own.norm() + 1e-14);
    }
  }
}

TEST_P(CreepLawProperties, StressTangentIsTheDerivativeInTheStress) {
  const Eigen::VectorXd no_own = Eigen::VectorXd::Zero(law->n_internal());
  for (const double size : {0.0, 1.0, 150.0}) {
    const Tensor6 stress = random(6, -size, size);
    Tensor6 d_stress = random(6, -50, 50);
    if (law->uses_mean_stress()) d_stress = tensor::deviator(d_stress);  // for the rest the tangent has no place
    const Tensor6 s = law->is_coaxial() ? tensor::deviator(stress) : rate(stress), ds = tensor::deviator(d_stress);
    const Tensor6 m = s.norm() > 0 ? Tensor6(s.normalized()) : Tensor6(Tensor6::Zero());
    const StressTangent c = law->stress_tangent(point(stress));
    const Tensor6 expected = c.deviatoric * ds + c.radial * m.dot(ds) * m +
                             c.volumetric * tensor::trace(d_stress) / 3.0 * tensor::identity();
    Tensor6 exact = Tensor6::Zero();
    Eigen::VectorXd exact_own(law->n_internal());
    law->derivative(point(stress), {.stress = tensor::view(d_stress), .internal = numbers(no_own)},
                    {tensor::writable(exact), numbers(exact_own)});
    EXPECT_TRUE(exact.allFinite());
    EXPECT_LE((exact - expected).norm(), 1e-12 * exact.norm());
  }
}

TEST_P(CreepLawProperties, RateAndTangentAreTheSameAtOnce) {
  for (const double size : {0.0, 1.0, 150.0}) {
    const Tensor6 stress = random(6, -size, size);
    Eigen::VectorXd own(law->n_internal()), own_at_once(law->n_internal());
    const Tensor6 alone = rate(stress, &own);
    Tensor6 at_once = Tensor6::Zero();
    const StressTangent a = law->stress_tangent(point(stress));
    const StressTangent b = law->rate_and_tangent(point(stress), {tensor::writable(at_once), numbers(own_at_once)});
    EXPECT_EQ(at_once, alone);
    EXPECT_EQ(own_at_once, own);
    EXPECT_EQ(a.deviatoric, b.deviatoric);
    EXPECT_EQ(a.radial, b.radial);
    EXPECT_EQ(a.volumetric, b.volumetric);
  }
}

TEST_P(CreepLawProperties, RotatedStressGivesTheRotatedRate) {
  const auto rotate = [](const Matrix3& R, const Tensor6& a) {
    return tensor::from_matrix(R * tensor::to_matrix(a) * R.transpose());
  };
  const Tensor6 strain = creep_strain;
  const Eigen::VectorXd own = internal;
  for (int i = 0; i < 10; ++i) {
    const Matrix3 R = Eigen::Quaterniond(Eigen::Vector4d(random(4, -1, 1)).normalized()).toRotationMatrix();
    const Tensor6 stress = random(6, -150, 150);
    creep_strain = strain;
    internal = own;
    const Tensor6 expected = rotate(R, rate(stress));
    creep_strain = rotate(R, strain);
    for (Index k = 0; k < sample.tensors; ++k) internal.segment<6>(6 * k) = rotate(R, own.segment<6>(6 * k));
    EXPECT_LT((rate(rotate(R, stress)) - expected).norm(), 1e-11 * expected.norm());
  }
}

TEST_P(CreepLawProperties, AShortIncrementIsTheRateTimesTheDuration) {
  if (law->is_isochronous()) GTEST_SKIP() << "has no rate";
  const Tensor6 stress = random(6, -150, 150);
  Eigen::VectorXd own_rate;
  const Tensor6 strain_rate = rate(stress, &own_rate);
  const double duration = 1e-6;
  const auto [strain, own] = increment(point(stress), duration);
  EXPECT_LT((strain - duration * strain_rate).norm(), 1e-5 * strain.norm());
  EXPECT_LE((own - duration * own_rate).norm(), 1e-5 * own.norm());
}

TEST_P(CreepLawProperties, TwoIncrementsAreOne) {
  if (!sample.closed_form) GTEST_SKIP() << "has no closed form";
  const Tensor6 stress = random(6, -150, 150);
  for (const bool virgin : {true, false}) {
    if (virgin) internal.setZero();
    if (!virgin) internal = random(law->n_internal(), 1e-4, 1e-3);
    PointState at = point(stress);
    at.time = virgin ? 0.0 : 2.0;
    const auto [whole, own_whole] = increment(at, 0.7);
    const auto [first, own_first] = increment(at, 0.1);
    EXPECT_TRUE(whole.allFinite());
    EXPECT_GT(whole.norm(), 0.0);
    const Eigen::VectorXd before = internal;
    internal += own_first;
    at.time += 0.1;
    const auto [second, own_second] = increment(at, 0.6);
    internal = before;
    EXPECT_LT((first + second - whole).norm(), 1e-12 * whole.norm());
    EXPECT_LE((own_first + own_second - own_whole).norm(), 1e-12 * own_whole.norm());
  }
}

TEST_P(CreepLawProperties, ASingularStartGrowsWithItsExponent) {
  internal.setZero();
  const Tensor6 stress = random(6, -150, 150);
  PointState at = point(stress);
  at.time = 0;
  const double exponent = law->start_exponent(at);
  ASSERT_GT(exponent, 0.0);
  ASSERT_LE(exponent, 1.0);
  if (exponent == 1.0) return;
  const double begin = increment(at, 1e-18).first.norm(), later = increment(at, 1e-16).first.norm();
  EXPECT_NEAR(std::log(later / begin) / std::log(100.0), exponent, 1e-6);
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const LawInfo& law : creep_laws()) result.push_back(law.name);
  return result;
}
INSTANTIATE_TEST_SUITE_P(All, CreepLawProperties, testing::ValuesIn(names()),
                         [](const auto& law) { return law.param; });

TEST(CreepLawRegistry, DescribesEveryLaw) {
  for (const LawInfo& law : creep_laws()) {
    EXPECT_EQ(find_creep_law(law.name), &law);
    EXPECT_FALSE(law.formula.empty() || law.source.empty() || law.parameters.empty()) << law.name;
    EXPECT_THROW(law.make({}), std::out_of_range) << law.name;
  }
  EXPECT_EQ(find_creep_law("nortno"), nullptr);
}

}  // namespace
}  // namespace creepcontact::material
