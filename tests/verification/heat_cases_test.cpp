/// Conduction of heat against NAFEMS T2, T3 and T4 (The Standard NAFEMS Benchmarks, 1990), its balance over time, and
/// the undershoot after a jump.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "creepcontact/heat/history.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/sections.hpp"

namespace creepcontact {
namespace heat_cases {
namespace {

using namespace test;
using heat::Conduction;
using heat::Definition;
using heat::History;
using Kind = heat::SurfaceFlow::Kind;
using enum CellType;

double at_place(const Conduction& problem, const mesh::Mesh& mesh, std::span<const double> T, const Vector3& x) {
  const std::vector<double> nodes = problem.at_nodes(0, T);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if ((mesh.nodes[i] - x).norm() < 1e-9) return nodes[i];
  ADD_FAILURE() << "no node there";
  return 0;
}

mesh::Section plane() {
  mesh::Section section;
  section.analysis = settings::Analysis::plane_strain;
  return section;
}

heat::SurfaceFlow film(const mesh::Mesh& mesh, const std::string& on, const Function& h, const Function& fluid) {
  return {Kind::film, 0, mesh::boundary_faces(mesh, on), h, fluid};
}

/// A bar with one end at 1000 K; the other one radiates to 300 K.
TEST(HeatCases, NafemsT2) {
  const mesh::Mesh mesh = box_mesh(hex20, {10, 1, 1}, {0.1, 0.01, 0.01});
  Definition all;
  all.bodies = {{"bar", &mesh, {55.6}, {}, 0.0}};
  all.given = {{0, mesh::group_nodes(mesh, "x0"), 1000.0}};
  all.flows = {{Kind::radiation, 0, mesh::boundary_faces(mesh, "x1"), 0.98 * 5.67e-8, 300.0}};
  Conduction problem(std::move(all));
  std::vector<double> T = problem.unknowns(300.0);
  problem.steady(0, T);
  EXPECT_NEAR(at_place(problem, mesh, T, {0.1, 0, 0}), 927.0, 0.05) << "published with one decimal";
  double low = 300, high = 1000;  // k (1000 - T)/L = eps sigma (T^4 - 300^4)
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (55.6 / 0.1 * (1000 - middle) > 0.98 * 5.67e-8 * (std::pow(middle, 4) - std::pow(300, 4)) ? low : high) = middle;
  }
  EXPECT_NEAR(at_place(problem, mesh, T, {0.1, 0, 0}), low, 1e-9);
}

/// A bar whose one end is held at 0, the other one at 100 sin(pi t/40).
TEST(HeatCases, NafemsT3) {
  const mesh::Mesh mesh = box_mesh(hex20, {20, 1, 1}, {0.1, 0.01, 0.01});
  Definition all;
  all.bodies = {{"bar", &mesh, {35.0}, {}, 440.5, 7200}};
  all.given = {{0, mesh::group_nodes(mesh, "x0"), 0.0},
               {0, mesh::group_nodes(mesh, "x1"), Function::expression("100*sin(pi*t/40)", {"t"})}};
  Conduction problem(std::move(all));
  const History history = integrate(problem, problem.unknowns(0.0), {32, {}, 1e-3});
  EXPECT_NEAR(at_place(problem, mesh, history.values.back(), {0.08, 0, 0}), 36.60, 0.01);
}

/// A plate, 100 below, with films to 0 on the right and above, insulated on the left.
TEST(HeatCases, NafemsT4) {
  const auto at_E = [](int n, CellType type) {
    const mesh::Mesh mesh = section_mesh(type, {3 * n, 5 * n}, {0.6, 1.0}, {0, 0}, plane());
    Definition all;
    all.bodies = {{"plate", &mesh, {52.0}, {}, 0.0}};
    all.given = {{0, mesh::group_nodes(mesh, "y0"), 100.0}};
    all.flows = {film(mesh, "x1", 750.0, 0.0), film(mesh, "y1", 750.0, 0.0)};
    Conduction problem(std::move(all));
    std::vector<double> T = problem.unknowns(0.0);
    problem.steady(0, T);
    return at_place(problem, mesh, T, {0.6, 0.2, 0});
  };
  for (const CellType type : {tri6, quad8, quad9}) EXPECT_NEAR(at_E(6, type), 18.25, 0.01) << mesh::name(type);
  for (const CellType type : {tri3, quad4}) EXPECT_NEAR(at_E(12, type), 18.25, 0.1) << mesh::name(type);
}

/// Heat that has flowed in is heat that is stored, at every time that is kept.
TEST(HeatCases, BalanceOverTime) {
  const mesh::Mesh mesh = box_mesh(hex20, {8, 2, 2}, {1, 0.25, 0.25});
  Definition all;
  all.bodies = {{"slab", &mesh, {Function::expression("1 + T", {"T"})}, {}, 2.0}};
  all.flows = {film(mesh, "x0", 5.0, 1.0), {Kind::flux, 0, mesh::boundary_faces(mesh, "x1"), -0.1, 0.0}};
  all.sources = {{0, Function::expression("0.2*t", {"t"})}};
  Conduction problem(std::move(all));
  const History history = integrate(problem, problem.unknowns(0.0), {1, {}, 1e-5});
  const double volume = 0.25 * 0.25;
  double flowed = 0;
  const std::vector<double> none(problem.size(), 0.0);
  for (std::size_t k = 1; k < history.times.size(); ++k) {
    const double t = history.times[k - 1], h = history.times[k] - t;
    for (const double s : {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}) {
      const double r = (1 + s) / 2, weight = h * (s == 0 ? 8 : 5) / 18;
      std::vector<double> T(problem.size());
      for (std::size_t i = 0; i < T.size(); ++i)
        T[i] = (1 - r) * (1 - r) * (1 + 2 * r) * history.values[k - 1][i] + r * r * (3 - 2 * r) * history.values[k][i] +
               r * (1 - r) * h * ((1 - r) * history.rates_after[k - 1][i] - r * history.rates_before[k][i]);
      const heat::Balance balance = problem.balance(t + r * h, T, none);
      flowed += weight * (balance.flows[0] + balance.flows[1] + balance.sources[0]);
    }
    std::vector<double> change(problem.size());
    for (std::size_t i = 0; i < change.size(); ++i) change[i] = history.values[k][i] - history.values[0][i];
    const double stored = problem.balance(0, none, change).stored;  // capacities are constant
    EXPECT_NEAR(flowed, stored, 2 * volume * 1e-4) << history.times[k];
  }
  EXPECT_GT(flowed, volume);
}

/// Least temperature while a fluid of 1 heats a slab from 0, by the element Biot number.
TEST(HeatCases, UndershootByTheElementBiotNumber) {
  const auto undershoot = [](CellType type, double biot) {
    const mesh::Mesh mesh = box_mesh(type, {8, 1, 1}, {1, 0.125, 0.125});
    Definition all;
    all.bodies = {{"slab", &mesh, {1.0}, {}, 1.0}};
    all.flows = {film(mesh, "x0", 8 * biot, 1.0)};
    Conduction problem(std::move(all));
    const History history = integrate(problem, problem.unknowns(0.0), {0.01, {}, 1e-5});
    double least = 0;
    for (const std::vector<double>& T : history.values) least = std::min(least, std::ranges::min(T));
    return -least;
  };
  for (const auto& [biot, part] : {std::pair{0.1, 0.001}, {1.0, 0.01}, {3.0, 0.025}}) {
    for (const CellType type : {hex20, hex27}) EXPECT_LT(undershoot(type, biot), part) << mesh::name(type);
    for (const CellType type : {hex8, wedge15}) EXPECT_LT(undershoot(type, biot), 4 * part) << mesh::name(type);
    for (const CellType type : {tet4, tet10, wedge6}) EXPECT_LT(undershoot(type, biot), 7 * part) << mesh::name(type);
  }
}

}  // namespace
}  // namespace heat_cases
}  // namespace creepcontact
