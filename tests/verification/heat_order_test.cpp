/// Orders of the error of temperatures: of all elements over their size, of transients over the tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/fem/tangents.hpp"
#include "creepcontact/heat/history.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/sections.hpp"

namespace creepcontact {
namespace heat_order {
namespace {

using namespace test;
using heat::Conduction;
using heat::Definition;
using heat::History;
using enum CellType;

/// L2 norm of the error of steady temperatures with sources that make them exact; those of all faces are given.
double error_of(const mesh::Mesh& mesh, const std::string& exact, const std::string& source) {
  const Function value = Function::expression(exact, {"x", "y", "z"});
  Definition all;
  all.bodies = {{"body", &mesh, {2.0}, {}, 0.0}};
  for (const auto& [name, group] : mesh.groups)
    if (name.size() == 2) all.given.push_back({0, mesh::group_nodes(mesh, name), value});
  all.sources = {{0, Function::expression("2*(" + source + ")", {"x", "y", "z"})}};
  Conduction problem(std::move(all));
  std::vector<double> unknowns = problem.unknowns(0.0);
  problem.steady(0, unknowns);
  const std::vector<double> T = problem.at_nodes(0, unknowns);
  double sum = 0;
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type)) continue;
    const fem::ReferenceElement& element = fem::reference_element(block.type);
    const fem::QuadratureRule rule = [&] {
      switch (mesh::linear_type(block.type)) {
        case tri3:
          return fem::triangle(5);
        case quad4:
          return fem::gauss_quadrilateral(4);
        case tet4:
          return fem::tetrahedron(4);
        case wedge6:
          return fem::wedge(4, 3);
        default:
          return fem::gauss_hexahedron(4);
      }
    }();
    for (std::size_t c = 0; c < block.size(); ++c) {
      const auto cell = block.cell(c);
      Eigen::Matrix3Xd x(3, cell.size());
      Eigen::VectorXd at_nodes(cell.size());
      for (std::size_t i = 0; i < cell.size(); ++i) {
        x.col(static_cast<Index>(i)) = mesh.nodes[static_cast<std::size_t>(cell[i])];
        at_nodes[static_cast<Index>(i)] = T[static_cast<std::size_t>(cell[i])];
      }
      for (Index q = 0; q < rule.size(); ++q) {
        Eigen::VectorXd N(element.n_nodes());
        Eigen::MatrixX3d gradient(element.n_nodes(), 3);
        const Vector3 xi = rule.points.row(q).transpose();
        element.shape(xi, N);
        element.gradient(xi, gradient);
        const Vector3 place = x * N;
        const double error = N.dot(at_nodes) - value({.x = place[0], .y = place[1], .z = place[2]});
        sum += rule.weights[q] * std::abs(fem::jacobian(element, x, gradient).determinant()) * error * error;
      }
    }
  }
  return std::sqrt(sum);
}

TEST(HeatOrder, OfSolids) {
  for (const CellType type : {tet4, tet10, hex8, hex20, hex27, wedge6, wedge15}) {
    const auto error = [&](int n) {
      return error_of(box_mesh(type, {n, n, n}), "sin(1.3*x + 0.4)*cos(0.9*y - 0.2)*exp(0.5*z)",
                      "(1.69 + 0.81 - 0.25)*sin(1.3*x + 0.4)*cos(0.9*y - 0.2)*exp(0.5*z)");
    };
    EXPECT_NEAR(std::log2(error(4) / error(8)), mesh::order(type) + 1, 0.15) << mesh::name(type);
  }
}

TEST(HeatOrder, OfSections) {
  for (const auto analysis :
       {settings::Analysis::plane_strain, settings::Analysis::plane_stress, settings::Analysis::axisymmetric})
    for (const CellType type : {tri3, tri6, quad4, quad8, quad9}) {
      mesh::Section section;
      section.analysis = analysis;
      const std::string round = analysis == settings::Analysis::axisymmetric ? " - 0.7/x" : "";
      const auto error = [&](int n) {
        return error_of(section_mesh(type, {n, n}, {1, 1}, {1, 0}, section), "exp(0.7*x)*cos(0.9*y)",
                        "(0.81 - 0.49" + round + ")*exp(0.7*x)*cos(0.9*y)");
      };
      EXPECT_NEAR(std::log2(error(8) / error(16)), mesh::order(type) + 1, 0.15) << mesh::name(type);
    }
}

/// Of the cubic polynomials between the times that are kept.
double at(const History& history, std::size_t unknown, double t) {
  std::size_t k = 0;
  while (k + 2 < history.times.size() && history.times[k + 1] <= t) ++k;
  const double h = history.times[k + 1] - history.times[k], s = (t - history.times[k]) / h, r = 1 - s;
  return r * r * (1 + 2 * s) * history.values[k][unknown] + s * s * (3 - 2 * s) * history.values[k + 1][unknown] +
         s * r * h * (r * history.rates_after[k][unknown] - s * history.rates_before[k + 1][unknown]);
}

/// A start, a hold, a stop; data over temperature. At many times the error is at most about the tolerance.
TEST(HeatOrder, OfTransientsIsThatOfTheTolerance) {
  const mesh::Mesh mesh = box_mesh(hex20, {8, 1, 1}, {1, 0.125, 0.125});
  const auto run = [&](double tolerance) {
    Definition all;
    all.bodies = {
        {"slab", &mesh, {Function::table("T", {0, 1}, {1, 0.7})}, {}, Function::expression("1 + 0.5*T^2", {"T"})}};
    all.flows = {{heat::SurfaceFlow::Kind::film, 0, mesh::boundary_faces(mesh, "x0"), 5.0,
                  Function::table("t", {0, 0.1, 1, 1.2, 2}, {0, 1, 1, 0, 0})},
                 {heat::SurfaceFlow::Kind::film, 0, mesh::boundary_faces(mesh, "x1"), 0.5, 0.0}};
    Conduction problem(std::move(all));
    return integrate(problem, problem.unknowns(0.0), {2, {0.1, 1, 1.2}, tolerance});
  };
  const History exact = run(1e-8);
  double before = 1;
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const History history = run(tolerance);
    double error = 0;
    for (int k = 0; k <= 400; ++k)
      for (std::size_t i = 0; i < history.values[0].size(); ++i)
        error = std::max(error, std::abs(at(history, i, 0.005 * k) - at(exact, i, 0.005 * k)));
    EXPECT_LT(error, 1.5 * tolerance) << history.n_steps << " steps, " << history.times.size() << " times";
    EXPECT_LT(error, 0.3 * before);
    before = error;
  }
}

}  // namespace
}  // namespace heat_order
}  // namespace creepcontact
