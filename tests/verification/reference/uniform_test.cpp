// The closed forms against their published numbers.
#include <gtest/gtest.h>

#include <vector>

#include "verification/reference/relaxation.hpp"

namespace creepcontact::reference {
namespace {

struct Published {
  double time, value;
};

template <typename Form>
void compare(const std::vector<Published>& table, double half_digit, Form form) {
  for (const auto& [time, value] : table) EXPECT_NEAR(form(time), value, half_digit) << "t = " << time;
}

TEST(Uniform, Nafems1B) {
  compare({{0.1, 133.75}, {1, 79.04}, {5, 53.12}, {10, 44.69}, {50, 29.90}, {100, 25.15}, {500, 16.82}, {1000, 14.14}},
          0.0051, [](double t) { return held_uniaxial(nafems, 200, t); });
}

TEST(Uniform, Nafems3A) {
  EXPECT_NEAR(shear_creep_rate(nafems, 200), 0.135, 1e-15);
}

TEST(Uniform, Nafems3B) {
  const double s0 = nafems.young_modulus * 1e-3 / (1 + nafems.poisson_ratio);
  compare({{0.1, 77.48}, {1, 44.23}, {5, 29.62}, {10, 24.91}, {50, 16.66}, {100, 14.01}, {500, 9.37}, {1000, 7.88}},
          0.0051, [&](double t) { return held_shear(nafems, s0, t); });
}

TEST(Uniform, Nafems5A) {
  const auto end = plane_strain_creep(nafems, 200, 100, 1000);
  EXPECT_NEAR(end.creep_x, 0.13212, 0.51e-5);
  EXPECT_NEAR(end.creep_y, -0.13182, 0.51e-5);
  EXPECT_NEAR(end.creep_z, -0.0003, 1e-9);
  EXPECT_NEAR(end.sigma_z, 150, 1e-4);
}

TEST(Uniform, Nafems5B) {
  compare({{0.1, 315.44}, {1000, 257.88}}, 0.0051, [](double t) { return held_triaxial(nafems, 1e-3, t); });
}

TEST(Uniform, Nafems10B) {
  const double s0 = nafems.young_modulus * 1e-3 / (1 + nafems.poisson_ratio);
  compare({{50, 27.16}, {100, 24.91}, {500, 20.37}, {1000, 18.68}}, 0.0051,
          [&](double t) { return held_shear_time_hardening(nafems, s0, t); });
  compare({{0, s0}, {50, 36.63}, {100, 34.02}, {500, 28.61}, {1000, 26.54}}, 0.0051,
          [&](double t) { return held_shear_strain_hardening(nafems, s0, t); });
}

TEST(Uniform, BoltOfVm132) {
  const NortonMaterial steel{30e6, 0.3, 4.8e-30, 7};
  compare({{190, 974.98}, {420, 949.71}, {690, 925.03}, {880, 910.06}, {950, 904.95}}, 0.0051,
          [&](double t) { return held_uniaxial(steel, 1000, t); });
}

TEST(Uniform, AlikeBlocksInSeriesRelaxLikeOne) {
  const Bar one{30, 2e5, 3.125e-14}, two{70, 2e5, 3.125e-14};
  EXPECT_NEAR(blocks_in_series(one, two, 5, 200, 100), held_uniaxial(nafems, 200, 100), 1e-10);
}

TEST(Uniform, BlocksInSeriesAgreeWithTheIntegratedEquation) {
  const Bar one{30, 2e5, 3.125e-14}, two{50, 1e5, 1e-13};
  const double factor = (30 * 3.125e-14 + 50 * 1e-13) / (30 / 2e5 + 50 / 1e5);
  StiffIntegrator integrator([&](const Eigen::VectorXd& s) { return Eigen::VectorXd(-factor * s.array().pow(5)); },
                             [&](const Eigen::VectorXd& s) { return Eigen::MatrixXd(-5 * factor * s.array().pow(4)); },
                             Eigen::VectorXd::Constant(1, 150.0), 1e-10);
  for (const double t : {1.0, 100.0, 1e4})
    EXPECT_NEAR(integrator.advance(t)[0] / blocks_in_series(one, two, 5, 150, t), 1.0, 1e-7) << t;
  EXPECT_LT(integrator.steps(), 200);
}

}  // namespace
}  // namespace creepcontact::reference
