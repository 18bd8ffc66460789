/// Closed forms of heat conduction: slabs, cylinders, fins, films, radiation, interfaces, transients.
#include "creepcontact/heat/conduction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "creepcontact/base/error.hpp"
#include "creepcontact/heat/history.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/sections.hpp"
#include "support/says.hpp"

namespace creepcontact::heat {
namespace {

using namespace test;
using enum CellType;
using Kind = SurfaceFlow::Kind;

const std::vector<CellType> solids{tet4, tet10, hex8, hex20, hex27, wedge6, wedge15};
const std::vector<CellType> sections{tri3, tri6, quad4, quad8, quad9};

mesh::Section section_of(settings::Analysis analysis) {
  mesh::Section section;
  section.analysis = analysis;
  return section;
}

Function expression(const std::string& text) {
  return Function::expression(text, {"x", "y", "z", "t", "T"});
}

SurfaceFlow film(const mesh::Mesh& mesh, const std::string& on, const Function& h, const Function& fluid,
                 std::size_t body = 0) {
  return {Kind::film, body, mesh::boundary_faces(mesh, on), h, fluid};
}

double at_place(const Conduction& problem, const mesh::Mesh& mesh, std::span<const double> T, const Vector3& x,
                std::size_t body = 0) {
  const std::vector<double> nodes = problem.at_nodes(body, T);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if ((mesh.nodes[i] - x).norm() < 1e-9) return nodes[i];
  ADD_FAILURE() << "no node there";
  return 0;
}

std::vector<double> steady(Conduction& problem, double start) {
  std::vector<double> T = problem.unknowns(start);
  problem.steady(0, T);
  const std::vector<double> rate(T.size(), 0.0);
  const Balance balance = problem.balance(0, T, rate);
  double largest = 0;
  for (const auto* flows : {&balance.flows, &balance.given, &balance.sources, &balance.points})
    for (const double flow : *flows) largest = std::max(largest, std::abs(flow));
  EXPECT_NEAR(balance.rest(), 0, 1e-10 * largest);
  return T;
}

TEST(Conduction, OfASlabWithFilmsInAllElements) {
  const auto expect = [](const mesh::Mesh& mesh, double area) {
    Definition all;
    all.bodies = {{"slab", &mesh, {40.0}, {}, 0.0}};
    all.flows = {film(mesh, "x0", 1000.0, 550.0), film(mesh, "x1", 200.0, 50.0)};
    Conduction problem(std::move(all));
    const std::vector<double> T = steady(problem, 20);
    const std::vector<double> nodes = problem.at_nodes(0, T);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      EXPECT_NEAR(nodes[i], 475.925926 - (475.925926 - 420.370370) * mesh.nodes[i].x() / 0.03, 1e-5);
    EXPECT_NEAR(problem.balance(0, T, std::vector<double>(T.size())).flows[0] / area, 74074.0741, 1e-3);
  };
  for (const CellType type : solids) expect(box_mesh(type, {3, 2, 2}, {0.03, 0.02, 0.01}, {0, 0, 0}, 0.2), 2e-4);
  for (const CellType type : sections)
    expect(section_mesh(type, {3, 2}, {0.03, 0.02}, {0, 0}, section_of(settings::Analysis::plane_strain), 0.2), 0.02);
}

/// Heat enters at both nodes of one end, and leaves at the other.
TEST(Conduction, OfFlowsIntoNodes) {
  for (const double k : {1.0, 1e-12, 1e12}) {  // given temperatures have pivots like the others
    const mesh::Mesh mesh = section_mesh(quad4, {3, 1}, {2, 1}, {0, 0}, section_of(settings::Analysis::plane_strain));
    Definition all;
    all.bodies = {{"strip", &mesh, {k}, {}, 0.0}};
    all.given = {{0, mesh::group_nodes(mesh, "x0"), 20.0}};
    PointFlow flow{{}, 3 * k};
    for (const std::int64_t node : mesh::group_nodes(mesh, "x1"))
      flow.nodes.insert(flow.nodes.end(), 2, {0, node});  // a node of two bodies counts once
    all.point_flows = {flow};
    Conduction problem(std::move(all));
    const std::vector<double> T = steady(problem, 0);
    EXPECT_NEAR(at_place(problem, mesh, T, {2, 1, 0}), 20 + 6 * 2, 1e-9);
    EXPECT_NEAR(problem.balance(0, T, std::vector<double>(T.size())).points[0], 6 * k, 1e-9 * k);
  }
}

TEST(Conduction, OfACylinder) {
  for (const CellType type : {tri6, quad8, quad9}) {
    const mesh::Mesh mesh =
        section_mesh(type, {16, 1}, {0.05, 0.01}, {0.05, 0}, section_of(settings::Analysis::axisymmetric));
    Definition all;
    all.bodies = {{"tube", &mesh, {30.0}, {}, 0.0}};
    all.flows = {film(mesh, "x0", 2000.0, 560.0), film(mesh, "x1", 50.0, 30.0)};
    Conduction problem(std::move(all));
    const std::vector<double> T = steady(problem, 20);
    EXPECT_NEAR(at_place(problem, mesh, T, {0.05, 0, 0}), 537.26346, 1e-3);
    EXPECT_NEAR(at_place(problem, mesh, T, {0.075, 0, 0}), 506.53387, 1e-4);
    EXPECT_NEAR(at_place(problem, mesh, T, {0.1, 0, 0}), 484.73088, 1e-4);
    EXPECT_NEAR(problem.balance(0, T, std::vector<double>(T.size())).flows[0] / 0.01, 14285.7920, 1e-2);
  }
}

TEST(Conduction, WithConductivityOverTheTemperature) {
  const mesh::Mesh mesh = box_mesh(hex20, {8, 1, 1}, {0.1, 0.01, 0.01});
  Definition all;
  all.bodies = {{"slab", &mesh, {expression("50*(1 - 6e-4*T)")}, {}, 0.0}};
  all.given = {{0, mesh::group_nodes(mesh, "x0"), 500.0}, {0, mesh::group_nodes(mesh, "x1"), 0.0}};
  Conduction problem(std::move(all));
  const std::vector<double> T = steady(problem, 0);
  EXPECT_NEAR(at_place(problem, mesh, T, {0.05, 0, 0}), 228.110292, 1e-3);
  const Balance balance = problem.balance(0, T, std::vector<double>(T.size()));
  EXPECT_NEAR(balance.given[0] / 1e-4, 212500, 1);
  EXPECT_NEAR(balance.given[1] / 1e-4, -212500, 1);
}

TEST(Conduction, AlongMaterialAxes) {
  const mesh::Mesh mesh = box_mesh(hex8, {4, 4, 1}, {1, 1, 0.2}, {0, 0, 0}, 0.2);
  // k along (1, 1, 0) is 4, across it 1: a gradient along x drives a flux (2.5, 1.5, 0).
  mechanics::MaterialAxes axes{{Function(1.0), Function(1.0), Function(0.0)},
                               {Function(-1.0), Function(1.0), Function(0.0)}};
  Definition all;
  all.bodies = {{"block", &mesh, {4.0, 1.0, 1.0}, axes, 0.0}};
  for (const char* face : {"x0", "x1", "y0", "y1"})
    all.given.push_back({0, mesh::group_nodes(mesh, face), expression("-x")});
  Conduction problem(std::move(all));
  const std::vector<double> T = steady(problem, 0);
  EXPECT_NEAR(problem.balance(0, T, std::vector<double>(T.size())).rest(), 0, 1e-12);
  const std::vector<double> nodes = problem.at_nodes(0, T);
  for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_NEAR(nodes[i], -mesh.nodes[i].x(), 1e-12);
}

TEST(Conduction, OfAFinAndARadiatingPlate) {
  const mesh::Mesh fin = box_mesh(hex20, {20, 2, 2}, {0.1, 0.01, 0.01});
  Definition of_fin;
  of_fin.bodies = {{"fin", &fin, {40.0}, {}, 0.0}};
  of_fin.given = {{0, mesh::group_nodes(fin, "x0"), 300.0}};
  for (const char* face : {"x1", "y0", "y1", "z0", "z1"}) of_fin.flows.push_back(film(fin, face, 50.0, 20.0));
  Conduction of(std::move(of_fin));
  const std::vector<double> T = steady(of, 20);
  EXPECT_NEAR(at_place(of, fin, T, {0.05, 0.005, 0.005}), 119.27173, 0.4)
      << "one-dimensional: transverse Biot number .003";
  EXPECT_NEAR(at_place(of, fin, T, {0.1, 0.005, 0.005}), 76.10989, 0.3);

  const mesh::Mesh plate = box_mesh(hex20, {1, 1, 4}, {0.01, 0.01, 0.02});
  Definition radiating;
  radiating.absolute_zero = -273.15;
  radiating.bodies = {{"plate", &plate, {25.0}, {}, 0.0}};
  radiating.sources = {{0, 2e6}};
  radiating.flows = {{Kind::radiation, 0, mesh::boundary_faces(plate, "z1"), 0.8 * 5.670374e-8, 20.0}};
  Conduction hot(std::move(radiating));
  const std::vector<double> at = steady(hot, 20);
  EXPECT_NEAR(at_place(hot, plate, at, {0, 0, 0.02}), 697.90788, 1e-4);
  EXPECT_NEAR(at_place(hot, plate, at, {0, 0, 0}), 713.90788, 1e-4);
}

/// A temperature that is linear in each of two bodies, with a jump between them, on meshes that do not match.
TEST(Interface, PassesThePatchTest) {
  const auto expect = [](const mesh::Mesh& low, const mesh::Mesh& high, const std::string& below,
                         const std::string& above, const std::string& bottom, const std::string& top, int axis) {
    for (const double h : {0.2, 17.0, 1.7e3}) {
      Definition all;
      all.bodies = {{"low", &low, {1.0}, {}, 0.0}, {"high", &high, {3.0}, {}, 0.0}};
      all.given = {{0, mesh::group_nodes(low, bottom), 10.0}, {1, mesh::group_nodes(high, top), 0.0}};
      all.interfaces = {{"joint", 0, 1,
                         contact::facing_faces(low, mesh::boundary_faces(low, below), high,
                                               mesh::boundary_faces(high, above), std::nullopt),
                         h, false}};
      Conduction problem(std::move(all));
      const std::vector<double> T = steady(problem, 0);
      const double q = 10 / (1 + 1 / h + 1.0 / 3);
      const std::vector<double> of_low = problem.at_nodes(0, T), of_high = problem.at_nodes(1, T);
      for (std::size_t i = 0; i < of_low.size(); ++i) EXPECT_NEAR(of_low[i], 10 - q * low.nodes[i][axis], 1e-11);
      for (std::size_t i = 0; i < of_high.size(); ++i)
        EXPECT_NEAR(of_high[i], q / 3 * (2 - high.nodes[i][axis]), 1e-11);
      EXPECT_NEAR(problem.balance(0, T, std::vector<double>(T.size())).interfaces[0], q, 1e-10 * q);
    }
  };
  for (const CellType type : solids)
    expect(box_mesh(type, {2, 2, 2}, {1, 1, 1}, {0, 0, 0}, 0.2), box_mesh(hex20, {3, 3, 2}, {1, 1, 1}, {0, 0, 1}, 0.2),
           "z1", "z0", "z0", "z1", 2);
  for (const CellType type : sections)
    expect(section_mesh(type, {3, 2}, {1, 1}, {0, 0}, section_of(settings::Analysis::plane_strain), 0.2),
           section_mesh(quad9, {4, 2}, {1, 1}, {0, 1}, section_of(settings::Analysis::plane_strain), 0.2), "y1", "y0",
           "y0", "y1", 1);
}

TEST(Interface, BetweenTwoSlabsAndPerfect) {
  const mesh::Mesh low = box_mesh(hex8, {2, 2, 4}, {0.01, 0.01, 0.02});
  const mesh::Mesh high = box_mesh(tet10, {3, 3, 4}, {0.01, 0.01, 0.04}, {0, 0, 0.02});
  const auto solve = [&](bool perfect) {
    Definition all;
    all.bodies = {{"low", &low, {20.0}, {}, 0.0}, {"high", &high, {45.0}, {}, 0.0}};
    all.flows = {film(low, "z0", 800.0, 500.0), film(high, "z1", 150.0, 40.0, 1)};
    all.interfaces = {{"joint", 0, 1,
                       contact::facing_faces(low, mesh::boundary_faces(low, "z1"), high,
                                             mesh::boundary_faces(high, "z0"), std::nullopt),
                       3000.0, perfect}};
    Conduction problem(std::move(all));
    const std::vector<double> T = steady(problem, 20);
    return std::array{at_place(problem, low, T, {0, 0, 0}), at_place(problem, low, T, {0, 0, 0.02}),
                      at_place(problem, high, T, {0, 0, 0.02}, 1), at_place(problem, high, T, {0, 0, 0.06}, 1)};
  };
  const auto T = solve(false);
  EXPECT_NEAR(T[0], 443.287671, 1e-6);
  EXPECT_NEAR(T[1], 397.917808, 1e-6);
  EXPECT_NEAR(T[2], 382.794521, 1e-6);
  EXPECT_NEAR(T[3], 342.465753, 1e-6);
  const auto perfect = solve(true);
  const double q = 460 / (1 / 800.0 + 0.02 / 20 + 0.04 / 45 + 1 / 150.0);
  EXPECT_NEAR(perfect[0], 500 - q / 800, 0.01);
  EXPECT_NEAR(perfect[1], perfect[2], 0.01);
}

TEST(Conduction, NamesABodyThatNothingHolds) {
  const mesh::Mesh mesh = box_mesh(hex8, {1, 1, 1});
  Definition all;
  all.bodies = {{"loose", &mesh, {1.0}, {}, 0.0}};
  all.flows = {{Kind::flux, 0, mesh::boundary_faces(mesh, "x0"), 1.0, 0.0}};
  Conduction problem(std::move(all));
  std::vector<double> T = problem.unknowns(0.0);
  EXPECT_TRUE(says(message_of<ModelError>([&] { problem.steady(0, T); }), {"body 'loose'", "film"}));
}

/// A slab heated by a film at x = 0, insulated at x = L: 1 - sum of C exp(-z^2 Fo) cos(z (1 - x/L)).
double transient(double biot, double fourier, double place) {
  double sum = 0;
  for (int k = 0; k < 60; ++k) {
    double low = k * std::numbers::pi, high = low + std::numbers::pi / 2;
    for (int i = 0; i < 200; ++i) {
      const double z = (low + high) / 2;
      (z * std::tan(z) < biot ? low : high) = z;
    }
    const double z = low;
    sum += 4 * std::sin(z) / (2 * z + std::sin(2 * z)) * std::cos(z * (1 - place)) * std::exp(-z * z * fourier);
  }
  return 1 - sum;
}

TEST(HeatHistory, OfASlabThatAFilmHeats) {
  EXPECT_NEAR(transient(0.5, 0.05, 0), 0.114635, 1e-6);
  EXPECT_NEAR(transient(5, 0.5, 1), 0.476891, 1e-6);
  const mesh::Mesh mesh = box_mesh(hex20, {12, 1, 1}, {1, 0.1, 0.1});
  for (const double biot : {0.5, 5.0}) {
    Definition all;
    all.time_unit = 3600;  // t in hours, data in seconds
    all.bodies = {{"slab", &mesh, {1.0}, {}, 3600.0}};
    all.flows = {film(mesh, "x0", biot, 1.0)};
    Conduction problem(std::move(all));
    const History history = integrate(problem, problem.unknowns(0.0), {0.5, {}, 1e-5});
    EXPECT_NEAR(at_place(problem, mesh, history.values.back(), {0, 0, 0}), transient(biot, 0.5, 0), 5e-5);
    EXPECT_NEAR(at_place(problem, mesh, history.values.back(), {1, 0, 0}), transient(biot, 0.5, 1), 5e-5);
    EXPECT_LT(history.times.size(), static_cast<std::size_t>(history.n_steps) / 2);
  }
}

/// Conductivities and capacities depend on the temperature, and steps grow and shrink.
TEST(HeatHistory, KeepsFactors) {
  const mesh::Mesh mesh = box_mesh(hex20, {12, 4, 4}, {30, 10, 10});
  Definition all;
  all.time_unit = 3600;
  all.bodies = {{"block",
                 &mesh,
                 {Function::table("T", {20, 600}, {42, 29})},
                 {},
                 Function::table("T", {20, 600}, {4.6e8, 7.2e8}),
                 7.8e-9}};
  all.flows = {film(mesh, "x0", 1.0, Function::table("t", {0, 4}, {20, 550})), film(mesh, "x1", 0.05, 50.0)};
  Conduction problem(std::move(all));
  const History history = integrate(problem, problem.unknowns(20.0), {1e5, {4}, 0.05});
  const auto n_steps = static_cast<std::size_t>(history.n_steps);
  EXPECT_LT(problem.n_factorizations(), n_steps / 4);
  EXPECT_LT(problem.n_passes(), 5 * n_steps);
}

TEST(HeatHistory, FollowsGivenTemperaturesThroughKinksAndJumps) {
  // Slow against the body: the temperature is the given one. A ramp, a hold, a jump.
  const mesh::Mesh mesh = box_mesh(hex8, {1, 1, 1});
  Definition all;
  all.bodies = {{"block", &mesh, {1e6}, {}, 1.0}};
  all.given = {{0, mesh::group_nodes(mesh, "x0"), Function::table("t", {0, 1, 2, 2, 3}, {0, 100, 100, 20, 20})}};
  Conduction problem(std::move(all));
  const History history = integrate(problem, problem.unknowns(0.0), {3, {1, 2}, 1e-3});
  EXPECT_EQ(history.kinks, (std::vector<double>{1, 2}));
  for (std::size_t k = 0; k < history.times.size(); ++k)
    EXPECT_NEAR(at_place(problem, mesh, history.values[k], {0, 0, 0}),
                history.times[k] <= 2 ? 100 * std::min(history.times[k], 1.0) : 20, 1e-9)
        << history.times[k];
  EXPECT_NEAR(at_place(problem, mesh, history.values.back(), {1, 0, 0}), 20, 2e-3);
}

}  // namespace
}  // namespace creepcontact::heat
