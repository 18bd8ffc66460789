/// Manufactured solutions in sections: the displacement converges with the order of the element in the L2 norm.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/reference_element.hpp"
#include "support/mechanics/sections.hpp"
#include "support/mechanics/solve.hpp"

namespace creepcontact::test {
namespace section_convergence_tests {
namespace {

using mesh::CellType;
using settings::Analysis;

constexpr double young = 1.0, nu = 0.3, inner = 0.5;

/// u = (x^4 - x^2 y^2, x^2 y + y^4): its body force is a polynomial in both cases.
Vector3 exact(const Vector3& x) {
  const double a = x.x(), b = x.y();
  return {a * a * a * a - a * a * b * b, a * a * b + b * b * b * b, 0};
}

const char* const exact_x = "x^4 - x^2*y^2";
const char* const exact_y = "x^2*y + y^4";

/// -div sigma of the exact displacement. @param plane  else axisymmetric, with the hoop strain u_x/x
std::array<Function, 3> body_force(bool plane) {
  const auto h = material::lame(young, nu);
  // e_xx = 4x^3 - 2xy^2, e_yy = x^2 + 4y^3, 2 e_xy = -2x^2 y + 2xy, hoop strain = x^3 - xy^2.
  // Divergence d and its derivatives, then force_x = -(lambda d_x + mu (2 e_xx,x + 2 e_xy,y) [+ 2 mu (e_xx - hoop)/x]).
  const std::string d_x = plane ? "(12*x^2 - 2*y^2 + 2*x)" : "(15*x^2 - 3*y^2 + 2*x)";
  const std::string d_y = plane ? "(-4*x*y + 12*y^2)" : "(-6*x*y + 12*y^2)";
  const std::string shear_x = "(24*x^2 - 4*y^2 - 2*x^2 + 2*x)", shear_y = "(24*y^2 - 4*x*y + 2*y)";
  const std::string round_x = plane ? "0" : "2*(3*x^2 - y^2)", round_y = plane ? "0" : "(-2*x*y + 2*y)";
  const auto force = [&](const std::string& d, const std::string& shear, const std::string& round) {
    return Function::expression(fmt::format("-({:.17g}*{} + {:.17g}*({} + {}))", h.lambda, d, h.mu, shear, round),
                                {"x", "y", "z"});
  };
  return {force(d_x, shear_x, round_x), force(d_y, shear_y, round_y), Function(0.0)};
}

double l2_error(const mesh::Mesh& mesh, const std::vector<double>& u) {
  const mesh::CellBlock& block = mesh.blocks[0];
  const auto& reference = fem::reference_element(block.type);
  const fem::QuadratureRule rule = mesh::n_corners(block.type) == 3 ? fem::triangle(8) : fem::gauss_quadrilateral(4);
  Eigen::VectorXd shape(reference.n_nodes());
  double sum = 0;
  for (std::size_t e = 0; e < block.size(); ++e)
    for (int p = 0; p < rule.size(); ++p) {
      reference.shape(rule.points.row(p).transpose(), shape);
      Vector3 x = Vector3::Zero(), value = Vector3::Zero();
      for (Index a = 0; a < shape.size(); ++a) {
        x += shape[a] * mesh.nodes[block.cell(e)[a]];
        value += shape[a] * Vector3::Map(&u[3 * block.cell(e)[a]]);
      }
      sum += rule.weights[p] * (value - exact(x)).squaredNorm();  // all elements are alike
    }
  return std::sqrt(sum / static_cast<double>(block.size()));
}

double error_of(CellType type, Analysis analysis, int n) {
  const mesh::Mesh mesh = section_mesh(type, {n, n}, {1, 1}, {inner, 0}, {analysis});
  std::vector<mechanics::Support> supports;
  for (const char* side : {"x0", "x1", "y0", "y1"})
    for (const bool along_x : {true, false})
      supports.push_back({.on = side,
                          .nodes = mesh::group_nodes(mesh, side),
                          .directions = {along_x ? Vector3(Vector3::UnitX()) : Vector3(Vector3::UnitY())},
                          .value = Function::expression(along_x ? exact_x : exact_y, {"x", "y", "z", "t"})});
  mechanics::Body body("section", mesh, elastic_material(young, nu), supports, std::nullopt);
  body.add_load(mechanics::volume_load(body.discretization(), body_force(analysis == Analysis::plane_strain)));
  return l2_error(mesh, solve(body));
}

class SectionConvergence : public testing::TestWithParam<std::tuple<CellType, Analysis>> {};

TEST_P(SectionConvergence, HasTheOrderOfTheElement) {
  const auto [type, analysis] = GetParam();
  const double observed = std::log2(error_of(type, analysis, 6) / error_of(type, analysis, 12));
  EXPECT_GT(observed, mesh::order(type) + 0.9);
}

INSTANTIATE_TEST_SUITE_P(Types, SectionConvergence,
                         testing::Combine(testing::Values(CellType::tri3, CellType::tri6, CellType::quad4,
                                                          CellType::quad8, CellType::quad9),
                                          testing::Values(Analysis::plane_strain, Analysis::axisymmetric)),
                         [](const auto& of) {
                           return fmt::format("{}_{}", mesh::name(std::get<0>(of.param)),
                                              settings::name_of(std::get<1>(of.param)));
                         });

}  // namespace
}  // namespace section_convergence_tests
}  // namespace creepcontact::test
