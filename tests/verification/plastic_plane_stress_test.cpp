/// Uniform states in plane stress, along ways that turn: sections and solids of all shapes against small explicit steps
/// at a point.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/plastic_point.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace plastic_plane_stress_tests {
namespace {

using namespace test;

/// Strains xx, yy, xy of three straight ways: out, around, and back in shear, so that the principal axes turn.
constexpr std::array<std::array<double, 3>, 3> ways{{{2e-3, -5e-4, 0}, {-1.2e-3, 2.2e-3, 0}, {-5e-4, -4e-4, 1e-3}}};

/// A sum over the ways up to t.
std::string course(int component) {
  return fmt::format("({}*min(t, 1) + {}*min(max(t - 1, 0), 1) + {}*max(t - 2, 0))", ways[0][component],
                     ways[1][component], ways[2][component]);
}

/// Stresses xx, yy, xy at the ends of the ways.
using Stresses = std::array<std::array<double, 3>, 3>;

struct Mesh {
  std::string name, analysis;
  int order;
  bool simplices;  ///< triangles or tetrahedra
};

const std::string law = "{ yield_stress = 1, hardening_modulus = 30, kinematic = [{ C = 150, gamma = 300 }] }";

/// @param n_steps  per way
Stresses run_strip(const Mesh& mesh, int n_steps, double tolerance = 1e-7) {
  const bool is_solid = mesh.analysis == "solid";
  std::string breakpoints = "1, 2";
  for (int i = 1; i < 3 * n_steps; ++i)
    if (i % n_steps != 0) breakpoints += fmt::format(", {:.15g}", static_cast<double>(i) / n_steps);
  std::string toml =
      (is_solid ? fmt::format("[mesh]\nfile = \"case.geo\"\norder = {}\n", mesh.order)
                : section_of(mesh.analysis, mesh.order)) +
      body("strip", 1000, 0.3) + "plasticity = " + law +
      fmt::format("\n[time]\nend = 3\noutput = [1, 2]\ntolerance = {:g}\nbreakpoints = [{}]\n", tolerance, breakpoints);
  for (const char* side : {"strip_x0", "strip_x1", "strip_y0", "strip_y1"})
    toml += fmt::format("[[supports]]\non = \"{}\"\ndisplacement = {{ x = \"{}*x + {}*y\", y = \"{}*x + {}*y\" }}\n",
                        side, course(0), course(2), course(2), course(1));
  if (is_solid) toml += support("strip_z0", "z");
  for (const char* component : {"xx", "yy", "xy"})
    toml += probe(component, fmt::format("stress_{}", component), "body = \"strip\"") +
            probe(fmt::format("{}_max", component), fmt::format("stress_{}", component),
                  "body = \"strip\"\nreduce = \"max\"");
  const std::string geo = is_solid ? boxes_geo({{"strip", {0, 0, 0}, {2, 1, 0.4}, {2, 2, 2}, !mesh.simplices}})
                                   : regions_geo({{"strip", {0, 2, 3}, {0, 1, 2}, false, mesh.simplices}});
  const Table history = run_case(toml, geo).history;
  Stresses result;
  for (int way = 0; way < 3; ++way) {
    int i = 0;
    for (const char* component : {"xx", "yy", "xy"}) {
      result[way][i] = history.at(component, way + 1);
      EXPECT_NEAR(history.at(fmt::format("{}_max", component), way + 1), result[way][i], 1e-6) << "uniform";
      ++i;
    }
  }
  return result;
}

Stresses exact() {
  PlasticPath point({1000, 0.3, 1, 30, {{150, 300}}});
  Stresses result;
  for (int way = 0; way < 3; ++way) {
    point.follow({.strain = {{Tensor6::Unit(0), ways[way][0]},
                             {Tensor6::Unit(1), ways[way][1]},
                             {Tensor6::Unit(3), tensor::sqrt2 * ways[way][2]}},
                  .free = {Tensor6::Unit(2)}},
                 4000);
    result[way] = {point.stress()[0], point.stress()[1], point.stress()[3] / tensor::sqrt2};
  }
  return result;
}

double distance(const Stresses& a, const Stresses& b) {
  double largest = 0;
  for (int way = 0; way < 3; ++way)
    for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(a[way][i] - b[way][i]));
  return largest;
}

TEST(PlasticPlaneStress, IsFollowedWithinTheTolerance) {
  const Stresses reference = exact();
  for (const double tolerance : {1e-2, 1e-3, 1e-4})
    EXPECT_LT(distance(run_strip({"quad4", "plane_stress", 1, false}, 1, tolerance), reference), tolerance);
}

class PlasticPlaneStressOf : public testing::TestWithParam<Mesh> {};

TEST_P(PlasticPlaneStressOf, IsThatOfThePoint) {
  const Stresses found = run_strip(GetParam(), 20);
  EXPECT_LT(distance(found, exact()), 2e-3);
  EXPECT_LT(distance(found, run_strip({"quad4", "plane_stress", 1, false}, 20)), 2e-6);
}

INSTANTIATE_TEST_SUITE_P(Elements, PlasticPlaneStressOf,
                         testing::Values(Mesh{"quad8", "plane_stress", 2, false}, Mesh{"tri3", "plane_stress", 1, true},
                                         Mesh{"tri6", "plane_stress", 2, true}, Mesh{"hex8", "solid", 1, false},
                                         Mesh{"hex20", "solid", 2, false}, Mesh{"tet10", "solid", 2, true}),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace plastic_plane_stress_tests
}  // namespace creepcontact
