/// The return of rate-independent plasticity at one point, against closed forms. E = 1000, nu = 0.5, yield stress 1.

#include "creepcontact/material/plasticity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace creepcontact::material {
namespace {

constexpr double shear = 1000.0 / 3;

/// Tension as a deviator with the von Mises stress `stress`.
Tensor6 tension(double stress) {
  return stress * (Tensor6() << 2, -1, -1, 0, 0, 0).finished() / 3;
}
Tensor6 torsion(double tau) {
  return (Tensor6() << 0, 0, 0, tensor::sqrt2 * tau, 0, 0).finished();
}
double axial(const Tensor6& deviator) {
  return 1.5 * deviator[0];
}

/// A point of an incompressible material under given strains.
class Specimen {
 public:
  explicit Specimen(const Plasticity& law, double T = 0)
      : law_(law), T_(T), constants_(law.n_constants()), back_(6 * law.n_back(), 0.0) {
    law.evaluate(T, constants_);
  }
  /// @param strain  deviator @returns the deviator of the stress
  Tensor6 strain(const Tensor6& strain) {
    std::vector<double> back(back_.size());
    const PlasticFlowStep step =
        law_.flow({stress_, p_, back_}, 2 * shear * (strain - plastic_), shear, T_, constants_, back);
    plastic_ += step.strain;
    p_ += step.accumulated;
    back_ = back;
    stress_ = 2 * shear * (strain - plastic_);
    return stress_;
  }
  /// To a strain in tension, and back and forth.
  double stretch(double strain) { return axial(this->strain(tension(strain) / (2 * shear) * 3 * shear)); }
  double p() const { return p_; }
  double yield_stress() const { return law_.yield_stress(p_, T_, constants_).stress; }
  Tensor6 relative_stress() const { return stress_ - law_.back_stress(back_, constants_); }

 private:
  const Plasticity& law_;
  double T_;
  std::vector<double> constants_, back_;
  Tensor6 stress_ = Tensor6::Zero(), plastic_ = Tensor6::Zero();
  double p_ = 0;
};

Plasticity perfect() {
  return {1.0, 0.0, {}};
}

TEST(Plasticity, HardensAlongItsTable) {
  const Plasticity law({{0, {0, 0.001, 0.005}, {1, 1.2, 1.5}}}, {});
  Specimen bar(law);
  EXPECT_NEAR(bar.stretch(0.004), 1.325581395, 1e-9);
  EXPECT_NEAR(bar.p(), 0.002674418605, 1e-12);
  EXPECT_NEAR(bar.stretch(0.02), 1.5, 1e-12) << "constant beyond the end of the table";
}

TEST(Plasticity, NothingFlowsBelowTheYieldStress) {
  const Plasticity law(1.0, 10.0, {{5.0, 2.0}});
  Specimen bar(law);
  EXPECT_DOUBLE_EQ(bar.stretch(0), 0);
  EXPECT_DOUBLE_EQ(bar.stretch(0.00099), 0.99);
  EXPECT_DOUBLE_EQ(bar.stretch(-0.00099), -0.99);
  EXPECT_EQ(bar.p(), 0);
}

TEST(Plasticity, TablesAreLinearInTheTemperature) {
  const Plasticity law({{100, {0}, {1}}, {200, {0, 0.01}, {0.5, 0.7}}}, {});
  std::vector<double> none(law.n_constants());
  EXPECT_DOUBLE_EQ(law.yield_stress(0.005, 50, none).stress, 1);
  EXPECT_DOUBLE_EQ(law.yield_stress(0.005, 150, none).stress, 0.8);
  EXPECT_DOUBLE_EQ(law.yield_stress(0.005, 150, none).slope, 10);
  EXPECT_DOUBLE_EQ(law.yield_stress(0.005, 300, none).stress, 0.6);
  EXPECT_TRUE(law.depends_on_temperature());
}

TEST(Plasticity, ModulusAndPragerOnAStraightPathAreExactInOneStep) {
  const double H = 1000.0 / 99;
  for (const Plasticity& law : {Plasticity(1.0, H, {}), Plasticity(1.0, 0.0, {{H, 0.0}})}) {
    Specimen bar(law);
    EXPECT_NEAR(bar.stretch(0.004), (0.004 - 0.001) * 1000 * H / (1000 + H) + 1, 1e-12);
    const double top = bar.stretch(0.004);
    EXPECT_NEAR(bar.stretch(0.0039), top - 0.1, 1e-12) << "unloading is elastic";
  }
}

TEST(Plasticity, AReversalPassesTheElasticRange) {
  const double H = 100;
  const Plasticity prager(1.0, 0.0, {{H, 0.0}});
  Specimen bar(prager);
  const double top = bar.stretch(0.004);
  const double yields_at = 0.004 - 2 * 1.0 / 1000;
  EXPECT_NEAR(bar.stretch(0.001), top - 2 - (yields_at - 0.001) * 1000 * H / (1000 + H), 1e-12);
}

// Krieg and Krieg, J. Pressure Vessel Technol. 99 (1977): tau/k = tanh(G gamma/k)
TEST(Plasticity, TensionThenTorsionIsOfSecondOrder) {
  const Plasticity law = perfect();
  const double k = 1 / std::sqrt(3.0), twist = 2 * k / shear;
  const auto error = [&](int n) {
    Specimen tube(law);
    tube.stretch(0.001);
    Tensor6 stress = Tensor6::Zero();
    for (int i = 1; i <= n; ++i) stress = tube.strain(tension(0.0015) + torsion(0.5 * twist * i / n));
    return std::abs(stress[3] / tensor::sqrt2 / k - std::tanh(2.0));
  };
  EXPECT_LT(error(8), 1e-3);
  EXPECT_NEAR(std::log2(error(32) / error(64)), 2, 0.2);
  EXPECT_LT(error(64), 2e-5);
}

TEST(Plasticity, ArmstrongFrederickLoopIsExactInOneStepPerHalfCycle) {
  const Plasticity law(0.7, 0.0, {{300, 1000}});
  Specimen bar(law);
  double stress = 0, p = 0, flow = 0;
  for (int i = 0; i < 40; ++i) {
    stress = bar.stretch(i % 2 == 0 ? 0.003 : -0.003);
    flow = bar.p() - p;
    p = bar.p();
  }
  EXPECT_NEAR(std::abs(stress), 0.9894300390, 1e-9);
  EXPECT_NEAR(1000 * flow / 2, 2.010570, 1e-6);
}

TEST(Plasticity, StressStaysOnTheYieldSurfaceAndFlowDissipates) {
  const Plasticity law({{0, {0, 0.002, 0.01}, {1, 1.1, 1.3}}}, {{200, 50}, {30, 0}});
  Specimen point(law);
  double p = 0;
  for (int i = 0; i < 200; ++i) {
    const double a = 0.3 * i;
    const Tensor6 strain = 0.004 * std::cos(a) * tension(1.5) + 0.003 * std::sin(1.7 * a) * torsion(1);
    point.strain(strain);
    const double size = std::sqrt(1.5) * point.relative_stress().norm();
    EXPECT_LE(size, point.yield_stress() * (1 + 1e-12));
    if (point.p() > p) {
      EXPECT_NEAR(size, point.yield_stress(), 1e-11);
    }
    EXPECT_GE(point.p(), p);
    p = point.p();
  }
  EXPECT_GT(p, 0.05);
}

/// The yield stress falls by heat while the strain reverses, in one step: from outside the new surface through it and
/// out on the other side.
TEST(Plasticity, AReversalWhileTheYieldStressFallsEndsOnTheSurface) {
  const Plasticity law(Function::table("T", {0, 100}, {1, 0.5}), 0.0, {});
  std::vector<double> constants(law.n_constants());
  law.evaluate(100, constants);
  for (const double trial : {-0.6, -0.8, -2.0}) {
    const PlasticFlowStep step =
        law.flow({.stress_deviator = tension(1), .back = {}}, tension(trial), shear, 100, constants, {});
    EXPECT_NEAR(axial(tension(trial) - 2 * shear * step.strain), -0.5, 1e-9) << trial;
    EXPECT_LE(step.accumulated, (0.5 - trial) / 1000) << trial << ": down to 0.5 in tension, and from -0.5 on";
  }
}

TEST(Plasticity, BackStressesThatAreNotGivenAreZero) {
  const Plasticity law(0.7, 0.0, {{300, 1000}});
  std::vector<double> constants(law.n_constants()), of_none(6), of_zeros(6);
  law.evaluate(0, constants);
  const std::vector<double> zeros(6);
  const PlasticFlowStep none = law.flow({}, tension(2), shear, 0, constants, of_none);
  EXPECT_EQ(none.strain, law.flow({.back = zeros}, tension(2), shear, 0, constants, of_zeros).strain);
  EXPECT_EQ(of_none, of_zeros);
  EXPECT_GT(none.accumulated, 0);
}

TEST(Plasticity, WrongConstantsAreRefused) {
  std::vector<double> into(4);
  EXPECT_THROW(Plasticity(Function::expression("500 - T", {"T"}), 0.0, {}).evaluate(500, into), std::invalid_argument);
  EXPECT_THROW(Plasticity(1.0, -1.0, {}).evaluate(0, into), std::invalid_argument);
  EXPECT_THROW(Plasticity(1.0, 0.0, {{1.0, -2.0}}).evaluate(0, into), std::invalid_argument);
}

}  // namespace
}  // namespace creepcontact::material
