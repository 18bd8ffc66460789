#include "creepcontact/fem/cut_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace creepcontact::fem {
namespace {

class CutRule : public testing::TestWithParam<CellType> {
 protected:
  /// Integral of f over the part beyond.
  template <typename Function>
  static double integral(const QuadratureRule& rule, const Function& f) {
    double sum = 0;
    for (Index q = 0; q < rule.size(); ++q) sum += rule.weights[q] * f(Vector3(rule.points.row(q).transpose()));
    return sum;
  }
  static double cubic(const Vector3& xi) {
    return 1 + xi.x() + 2 * xi.y() - 3 * xi.z() + xi.x() * xi.x() * xi.y() + xi.z() * xi.z() * xi.x() -
           xi.y() * xi.y() * xi.y();
  }
};

TEST_P(CutRule, BothPartsMakeTheWhole) {
  const ReferenceElement& element = reference_element(GetParam());
  const Vector3 normal(0.3, 0.2, element.dimension() == 3 ? -0.5 : 0);
  for (const double at : {-0.9, -0.05, 0.1, 0.23, 0.9}) {
    const Eigen::VectorXd levels = (element.nodes() * normal).array() - at;
    const QuadratureRule beyond = positive_part_rule(element, levels), behind = positive_part_rule(element, -levels),
                         whole = positive_part_rule(element, Eigen::VectorXd::Ones(levels.size()));
    EXPECT_NEAR(integral(beyond, cubic) + integral(behind, cubic), integral(whole, cubic), 1e-13) << at;
    EXPECT_NEAR(whole.weights.sum(), element.rule().weights.sum(), 1e-13);
    for (Index q = 0; q < beyond.size(); ++q) EXPECT_GT(beyond.points.row(q).dot(normal), at);
    for (Index q = 0; q < beyond.size(); ++q) EXPECT_GT(beyond.weights[q], 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Types, CutRule,
                         testing::Values(CellType::line2, CellType::line3, CellType::tri3, CellType::tri6,
                                         CellType::quad4, CellType::quad8, CellType::quad9, CellType::tet4,
                                         CellType::tet10, CellType::hex8, CellType::hex20, CellType::hex27,
                                         CellType::wedge6, CellType::wedge15),
                         [](const auto& tested) { return std::string(mesh::name(tested.param)); });

TEST(CutRuleOfOneType, PartsOfCubeAndTetrahedron) {
  const ReferenceElement& cube = reference_element(CellType::hex8);
  // The corner at (1, 1, 1), cut off at x + y + z = 2: a tetrahedron of edges 1.
  const Eigen::VectorXd levels = cube.nodes().rowwise().sum().array() - 2;
  EXPECT_NEAR(positive_part_rule(cube, levels).weights.sum(), 1.0 / 6, 1e-14);
  const ReferenceElement& tetrahedron = reference_element(CellType::tet10);
  const Eigen::VectorXd height = tetrahedron.nodes().col(2).array() - 0.5;
  EXPECT_NEAR(positive_part_rule(tetrahedron, height).weights.sum(), 1.0 / 48, 1e-15);
  const Eigen::VectorXd below = -Eigen::VectorXd::Ones(8);
  EXPECT_EQ(positive_part_rule(cube, below).size(), 0);
}

TEST(CutRuleOfOneType, ACurvedLevel) {
  // x^2 + y^2 < 0.64 in the square [-1, 1]^2: the level of nine nodes is exactly this.
  const ReferenceElement& square = reference_element(CellType::quad9);
  const Eigen::VectorXd levels = 0.64 - square.nodes().rowwise().squaredNorm().array();
  EXPECT_NEAR(positive_part_rule(square, levels).weights.sum(), M_PI * 0.64, 0.01);
}

}  // namespace
}  // namespace creepcontact::fem
