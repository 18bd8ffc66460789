/// The direct solver of the Newton systems against the Krylov iteration: the same histories, by other work.

#include <fmt/format.h>

#include <cmath>

#include "boxes.hpp"
#include "case.hpp"
#include "rings.hpp"

namespace creepcontact::test {
namespace {

constexpr double tolerance = 1e-4;
constexpr double stress_bound = 10 * tolerance;  // errors of both runs, local maxima included

/// Both rings creep, the disc `grading` times as fast as the shaft.
std::string relaxing_fit(const std::vector<RingMesh>& rings, double grading) {
  return "[mesh]\nfile = \"case.geo\"\norder = 2\n" + body("shaft", 1.75e5, 0.3, 1e-17 / grading, 5) +
         body("disc", 1.6e5, 0.3, 1e-17, 5) + ring_supports(rings, true) +
         contact_table("shaft_outer", "disc_inner", "gap = -0.09") +
         "[time]\nend = 1e6\noutput = [10, 100, 1e3, 1e4, 1e5, 1e6]\n" +
         probe("fit", "contact_pressure", "on = \"shaft_outer\"") +
         probe("hoop", "stress_theta", "at = [60, 0, 5]\nbody = \"disc\"");
}

/// A stiff body with a curved foot sinks into a creeping one: contact grows from the middle outwards.
std::string sinking_foot() {
  std::string toml =
      "[mesh]\nfile = \"case.geo\"\norder = 1\n" + body("lower", 1e5, 0.3, 1e-12, 4) + body("upper", 2e5, 0.3) +
      support("lower_z0", "z") + "[[loads]]\non = \"upper_z1\"\npressure = 50\n" +
      contact_table("lower_z1", "upper_z0", "gap = \"2e-3*x^2\"") +
      "[time]\nend = 1e4\noutput = [10, 100, 1e3, 1e4]\n" + probe("force", "contact_force_z", "on = \"upper_z0\"") +
      probe("area", "contact_area", "on = \"lower_z1\"") +
      probe("pressure", "contact_pressure", "on = \"lower_z1\"\nreduce = \"max\"") +
      probe("sinking", "displacement_z", "on = \"upper_z1\"");
  for (const char* name : {"lower", "upper"}) {
    toml += support(std::string(name) + "_x0", "x");
    toml += support(std::string(name) + "_y0", "y");
    toml += support(std::string(name) + "_y1", "y");
  }
  return toml;
}

struct Compared {
  Outcome krylov, tangent;
};

Compared compare(const std::string& toml, const std::string& geo, const std::string& integrator) {
  const std::vector<std::string> common{"time.integrator=" + integrator, fmt::format("time.tolerance={}", tolerance)};
  std::vector<std::string> direct = common;
  direct.emplace_back("time.linear_solver=tangent");
  Compared result{run_case(toml, geo, common), run_case(toml, geo, direct)};
  EXPECT_EQ(result.krylov.summary.number("convergence_failures"), 0);
  EXPECT_EQ(result.tangent.summary.number("convergence_failures"), 0);
  EXPECT_EQ(result.tangent.summary.number("jacobian_products"), 0);
  EXPECT_LT(2 * result.tangent.summary.number("factorizations"), result.tangent.summary.number("rhs_evaluations"));
  return result;
}

void expect_equal(const Compared& runs, const std::string& probe, double bound) {
  for (const double t : runs.krylov.history.times())
    EXPECT_NEAR(runs.tangent.history.at(probe, t), runs.krylov.history.at(probe, t), bound) << probe << " at t = " << t;
}

class TangentAndKrylov : public testing::TestWithParam<const char*> {};

TEST_P(TangentAndKrylov, RelaxAShrinkFitAlike) {
  const std::vector<RingMesh> rings{{"shaft", 40, 60, 4, 8}, {"disc", 60, 120, 6, 7, 1.15}};
  for (const double grading : {5.0, 1e4}) {
    const Compared runs = compare(relaxing_fit(rings, grading), rings_geo(rings, 10), GetParam());
    for (const char* name : {"fit", "hoop"}) expect_equal(runs, name, stress_bound * runs.krylov.history.at(name, 0));
    EXPECT_LT(runs.krylov.history.at("fit", 1e6), 0.5 * runs.krylov.history.at("fit", 0)) << "it must relax";
  }
}

TEST_P(TangentAndKrylov, LetContactGrowAlike) {
  const std::vector<Box> boxes{{"lower", {0, 0, 0}, {2, 0.25, 1}, {16, 1, 8}},
                               {"upper", {0, 0, 1}, {2, 0.25, 1}, {12, 1, 4}}};
  const Compared runs = compare(sinking_foot(), boxes_geo(boxes), GetParam());
  const Table& history = runs.krylov.history;
  expect_equal(runs, "force", 1e-9 * history.at("force", 0));  // the load, whatever creeps
  expect_equal(runs, "pressure", stress_bound * history.at("pressure", 0));
  expect_equal(runs, "sinking", stress_bound * std::abs(history.at("sinking", 1e4)));
  expect_equal(runs, "area", 0.01 * history.at("area", 1e4));  // its edge is fitted to small pressures
  EXPECT_GT(history.at("area", 1e4), 1.5 * history.at("area", 0)) << "it must grow";
}

INSTANTIATE_TEST_SUITE_P(Integrators, TangentAndKrylov, testing::Values("cvode_bdf", "arkode_dirk"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace creepcontact::test
