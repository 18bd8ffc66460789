// What every creep law must fulfil, whatever its formula: one suite over the registry.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <random>

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {
namespace {

/// Parameter values that give rates of about 1e-3 at stresses of about 100, in the order of the law's keys.
const std::map<std::string, std::vector<std::vector<double>>> sample_parameters{
    {"norton", {{1e-13}, {5.0}}},
    {"garofalo", {{1e-4}, {0.01}, {3.5}}},
};

class CreepLawProperties : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const LawInfo* info = find_creep_law(GetParam());
    ASSERT_NE(info, nullptr);
    ASSERT_TRUE(sample_parameters.contains(GetParam())) << "give this law sample parameters at the head of this file";
    ParameterValues values;
    for (const std::vector<double>& value : sample_parameters.at(GetParam()))
      values.emplace_back(value.begin(), value.end());
    ASSERT_EQ(values.size(), info->parameters.size());
    law = info->make(values);
    for (const Function& parameter : law->parameters()) parameters.push_back(parameter({.T = 500.0}));
    ASSERT_EQ(law->name(), GetParam());
    internal = random(law->n_internal(), 0.01, 0.1);
    creep_strain = tensor::deviator(random(6, -0.01, 0.01));
  }

  Eigen::VectorXd random(int size, double low, double high) {
    std::uniform_real_distribution<double> uniform(low, high);
    return Eigen::VectorXd::NullaryExpr(size, [&] { return uniform(generator); });
  }

  Point point(const Tensor6& stress) const {
    return {stress.data(), creep_strain.data(), internal.data(), parameters.data(), 2.0, 500.0};
  }

  Tensor6 rate(const Tensor6& stress, Eigen::VectorXd* internal_rate = nullptr) const {
    Tensor6 strain_rate = Tensor6::Zero();
    Eigen::VectorXd own(law->n_internal());
    law->rate(point(stress), strain_rate.data(), own.data());
    if (internal_rate != nullptr) *internal_rate = own;
    return strain_rate;
  }

  std::mt19937 generator{7};
  std::vector<double> parameters;
  std::unique_ptr<CreepLaw> law;
  Eigen::VectorXd internal;
  Tensor6 creep_strain;
};

TEST_P(CreepLawProperties, RateIsDeviatoric) {
  for (int i = 0; i < 20; ++i) {
    const Tensor6 f = rate(random(6, -150, 150));
    EXPECT_GT(f.norm(), 0.0);
    EXPECT_LT(std::abs(tensor::trace(f)), 1e-12 * f.norm());
  }
}

TEST_P(CreepLawProperties, ZeroOrHydrostaticStressGivesNoRate) {
  if (law->n_internal() > 0) internal.setZero();
  creep_strain.setZero();
  EXPECT_EQ(rate(Tensor6::Zero()).norm(), 0.0);
  EXPECT_EQ(rate(100.0 * tensor::identity()).norm(), 0.0);
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
  law->rate(point(stress), twice.data(), own.data());
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
    law->derivative(point(stress), d_stress.data(), d_strain.data(), d_own.data(), exact.data(), exact_own.data());

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
  const Tensor6 no_strain = Tensor6::Zero();
  const Eigen::VectorXd no_own = Eigen::VectorXd::Zero(law->n_internal());
  for (const double size : {0.0, 1.0, 150.0}) {
    const Tensor6 stress = random(6, -size, size), d_stress = random(6, -50, 50);
    const Tensor6 s = tensor::deviator(stress), ds = tensor::deviator(d_stress);
    const Tensor6 m = s.norm() > 0 ? Tensor6(s.normalized()) : Tensor6(Tensor6::Zero());
    const StressTangent c = law->stress_tangent(point(stress));
    const Tensor6 expected = c.deviatoric * ds + c.radial * m.dot(ds) * m +
                             c.volumetric * tensor::trace(d_stress) / 3.0 * tensor::identity();
    Tensor6 exact = Tensor6::Zero();
    Eigen::VectorXd exact_own(law->n_internal());
    law->derivative(point(stress), d_stress.data(), no_strain.data(), no_own.data(), exact.data(), exact_own.data());
    EXPECT_TRUE(exact.allFinite());
    EXPECT_LE((exact - expected).norm(), 1e-12 * exact.norm());
  }
}

TEST_P(CreepLawProperties, RotatedStressGivesTheRotatedRate) {
  const auto rotate = [](const Matrix3& R, const Tensor6& a) {
    return tensor::from_matrix(R * tensor::to_matrix(a) * R.transpose());
  };
  const Tensor6 strain = creep_strain;
  for (int i = 0; i < 10; ++i) {
    const Matrix3 R = Eigen::Quaterniond(Eigen::Vector4d(random(4, -1, 1)).normalized()).toRotationMatrix();
    const Tensor6 stress = random(6, -150, 150);
    creep_strain = strain;
    const Tensor6 expected = rotate(R, rate(stress));
    creep_strain = rotate(R, strain);
    EXPECT_LT((rate(rotate(R, stress)) - expected).norm(), 1e-11 * expected.norm());
  }
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
