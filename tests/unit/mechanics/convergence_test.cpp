/// Manufactured solution: the displacement converges with the order of the element in the L2 norm.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/reference_element.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"

namespace creepcontact::test {
namespace {

constexpr double young = 1.0, nu = 0.3;
const Vector3 amplitude(1.0, -0.5, 0.7), wave(1.3, 0.9, 1.1);

/// u = amplitude sin(wave . x)
Vector3 exact(const Vector3& x) {
  return amplitude * std::sin(wave.dot(x));
}

std::string times_wave(double factor) {
  return fmt::format("{:.17g}*sin(1.3*x + 0.9*y + 1.1*z)", factor);
}

double l2_error(const mesh::Mesh& mesh, const std::vector<double>& u) {
  const auto& reference = fem::reference_element(mesh.blocks[0].type);
  const int corners = mesh::n_corners(mesh.blocks[0].type);
  const fem::QuadratureRule rule = corners == 4   ? fem::tetrahedron(5)
                                   : corners == 6 ? fem::wedge(6, 4)
                                                  : fem::gauss_hexahedron(4);
  Eigen::VectorXd shape(reference.n_nodes());
  Eigen::MatrixX3d gradient(reference.n_nodes(), 3);
  double sum = 0;
  for (std::size_t e = 0; e < mesh.blocks[0].size(); ++e) {
    const auto cell = mesh.blocks[0].cell(e);
    for (int p = 0; p < rule.size(); ++p) {
      const Vector3 xi = rule.points.row(p).transpose();
      reference.shape(xi, shape);
      reference.gradient(xi, gradient);
      Vector3 x = Vector3::Zero(), value = Vector3::Zero();
      Matrix3 jacobian = Matrix3::Zero();
      for (std::size_t a = 0; a < cell.size(); ++a) {
        const Index row = a;
        const std::size_t node = cell[a];
        x += shape[row] * mesh.nodes[node];
        value += shape[row] * Vector3::Map(&u[3 * node]);
        jacobian += mesh.nodes[node] * gradient.row(row);
      }
      sum += rule.weights[p] * jacobian.determinant() * (value - exact(x)).squaredNorm();
    }
  }
  return std::sqrt(sum);
}

double error_of(CellType type, int n) {
  const mesh::Mesh cube = box_mesh(type, {n, n, n});
  const auto h = material::lame(young, nu);
  // -div sigma = [(lambda + mu) (wave . amplitude) wave + mu |wave|^2 amplitude] sin(wave . x)
  const Vector3 force = (h.lambda + h.mu) * wave.dot(amplitude) * wave + h.mu * wave.squaredNorm() * amplitude;
  mechanics::Body body(
      "cube", cube, elastic_material(young, nu),
      boundary_supports(cube, {times_wave(amplitude[0]), times_wave(amplitude[1]), times_wave(amplitude[2])}),
      std::nullopt);
  const auto component = [&](int i) { return Function::expression(times_wave(force[i]), {"x", "y", "z"}); };
  body.add_load(mechanics::volume_load(body.discretization(), {component(0), component(1), component(2)}));
  return l2_error(cube, solve(body));
}

struct Case {
  CellType type;
  int coarse;
};

class Convergence : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Types, Convergence,
                         testing::Values(Case{CellType::tet4, 6}, Case{CellType::hex8, 6}, Case{CellType::wedge6, 6},
                                         Case{CellType::tet10, 4}, Case{CellType::hex20, 5}, Case{CellType::hex27, 3},
                                         Case{CellType::wedge15, 5}),
                         [](const auto& c) { return std::string(mesh::name(c.param.type)); });

TEST_P(Convergence, HasTheOrderOfTheElement) {
  const auto [type, coarse] = GetParam();
  const double observed = std::log2(error_of(type, coarse) / error_of(type, 2 * coarse));
  EXPECT_GT(observed, mesh::order(type) + 0.9);
}

}  // namespace
}  // namespace creepcontact::test
