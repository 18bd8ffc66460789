#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/bubble.hpp"
#include "elements.hpp"

namespace creepcontact::fem {
namespace {

using testing::gradient_at;
using testing::inner_points;
using testing::shape_at;

class Element : public ::testing::TestWithParam<CellType> {
 protected:
  const ReferenceElement& element_ = reference_element(GetParam());
  int order_ = mesh::order(GetParam());
};
INSTANTIATE_TEST_SUITE_P(AllTypes, Element, ::testing::ValuesIn(testing::element_types()), testing::type_name);

TEST_P(Element, HasOneInstanceOfItsType) {
  EXPECT_EQ(element_.type(), GetParam());
  EXPECT_EQ(&element_, &reference_element(GetParam()));
  EXPECT_EQ(element_.nodes().rows(), element_.n_nodes());
}

TEST_P(Element, ShapeFunctionIsOneAtItsNodeAndZeroAtTheOthers) {
  for (int j = 0; j < element_.n_nodes(); ++j) {
    const Eigen::VectorXd shape = shape_at(element_, element_.nodes().row(j));
    EXPECT_LT((shape - Eigen::VectorXd::Unit(element_.n_nodes(), j)).lpNorm<Eigen::Infinity>(), 1e-15) << "node " << j;
  }
}

TEST_P(Element, ShapeFunctionsAreAPartitionOfUnity) {
  for (const Vector3& xi : inner_points(GetParam())) {
    EXPECT_NEAR(shape_at(element_, xi).sum(), 1, 2e-15);
    EXPECT_LT(gradient_at(element_, xi).colwise().sum().norm(), 2e-14);
  }
}

TEST_P(Element, GradientAgreesWithCentralDifferences) {
  const double h = 1e-5;
  for (const Vector3& xi : inner_points(GetParam())) {
    const Eigen::MatrixX3d gradient = gradient_at(element_, xi);
    for (int d = 0; d < 3; ++d) {
      if (d >= element_.dimension()) {
        EXPECT_TRUE(gradient.col(d).isZero(0));
        continue;
      }
      const Vector3 step = h * Vector3::Unit(d);
      const Eigen::VectorXd difference = (shape_at(element_, xi + step) - shape_at(element_, xi - step)) / (2 * h);
      EXPECT_LT((gradient.col(d) - difference).lpNorm<Eigen::Infinity>(), 1e-9);
    }
  }
}

TEST_P(Element, ReproducesEveryPolynomialOfItsOrder) {
  const auto power = [](const Vector3& x, int a, int b, int c) {
    return std::pow(x[0], a) * std::pow(x[1], b) * std::pow(x[2], c);
  };
  const int dimension = element_.dimension();
  for (int a = 0; a <= order_; ++a) {
    for (int b = 0; b <= (dimension > 1 ? order_ - a : 0); ++b) {
      for (int c = 0; c <= (dimension > 2 ? order_ - a - b : 0); ++c) {
        Eigen::VectorXd nodal(element_.n_nodes());
        for (int i = 0; i < nodal.size(); ++i) nodal[i] = power(element_.nodes().row(i), a, b, c);
        for (const Vector3& xi : inner_points(GetParam())) {
          EXPECT_NEAR(shape_at(element_, xi).dot(nodal), power(xi, a, b, c), 5e-15) << a << b << c;
        }
      }
    }
  }
}

TEST_P(Element, RuleLiesInsideAndMeasuresTheDomain) {
  const int dimension = element_.dimension(), corners = mesh::n_corners(GetParam());
  const double measure = testing::tetrahedral(GetParam()) ? 1. / 6
                         : corners == 6                   ? 1.0
                         : corners == 3                   ? 0.5
                                                          : std::pow(2, dimension);
  EXPECT_NEAR(element_.rule().weights.sum(), measure, 1e-14);
  const auto& points = element_.rule().points;
  const bool unit_triangle = testing::simplex_plane(GetParam()), unit_tetrahedron = testing::tetrahedral(GetParam());
  for (Index i = 0; i < points.rows(); ++i) {
    if (unit_triangle) {
      EXPECT_LT(points(i, 0) + points(i, 1), 1);
      EXPECT_GT(points.row(i).head<2>().minCoeff(), 0);
      EXPECT_LT(std::abs(points(i, 2)), 1);
    } else if (unit_tetrahedron) {
      EXPECT_LT(points.row(i).sum(), 1);
      EXPECT_GT(points.row(i).minCoeff(), 0);
    } else {
      EXPECT_LT(points.row(i).lpNorm<Eigen::Infinity>(), 1);
    }
  }
}

TEST(StiffnessRule, HasTheNumberOfPointsThatCarryTheCreepState) {
  const std::map<CellType, int> expected{{CellType::tet4, 1},    {CellType::tet10, 8},  {CellType::hex8, 8},
                                         {CellType::hex20, 8},   {CellType::hex27, 27}, {CellType::wedge6, 6},
                                         {CellType::wedge15, 12}};
  for (const auto& [type, n] : expected) EXPECT_EQ(reference_element(type).rule().size(), n) << mesh::name(type);
}

TEST(SurfaceRule, IntegratesProductsOfShapeFunctionsOnACurvedFaceExactly) {
  for (const CellType type : {CellType::tri3, CellType::tri6, CellType::quad4, CellType::quad8, CellType::quad9}) {
    const ReferenceElement& face = reference_element(type);
    Eigen::MatrixX3d position = face.nodes();
    position.col(2) = 0.3 * (3.0 * Eigen::VectorXd::LinSpaced(position.rows(), 1, 9)).array().sin();
    position.col(0).array() += 0.1 * position.col(2).array();
    const auto integral = [&](const QuadratureRule& rule) {
      Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(face.n_nodes(), 3 * face.n_nodes());
      for (int q = 0; q < rule.size(); ++q) {
        const Eigen::VectorXd shape = shape_at(face, rule.points.row(q));
        const Matrix3 tangents = position.transpose() * gradient_at(face, rule.points.row(q));
        const Vector3 normal = rule.weights[q] * tangents.col(0).cross(tangents.col(1));
        for (int d = 0; d < 3; ++d)
          sum.middleCols(d * face.n_nodes(), face.n_nodes()) += normal[d] * shape * shape.transpose();
      }
      return sum;
    };
    const QuadratureRule finer = mesh::n_corners(type) == 3 ? triangle(8) : gauss_quadrilateral(5);
    EXPECT_LT((integral(face.rule()) - integral(finer)).lpNorm<Eigen::Infinity>(), 1e-14) << mesh::name(type);
  }
}

TEST(ReferenceElement, BubblesVanishOnAllFaces) {
  // Then, by the divergence theorem, integral of grad N = 0 and integral of xi_i dN/dxi_j = - delta_ij integral of N.
  for (const CellType type : {CellType::tet10, CellType::wedge15}) {
    const QuadratureRule rule = type == CellType::tet10 ? tetrahedron(5) : wedge(6, 4);
    const double volume = type == CellType::tet10 ? 256 * 1.0 / 5040 : 27 * 2.0 / 120 / 2 * 4 / 3;
    Vector3 sum = Vector3::Zero();
    Matrix3 moment = Matrix3::Zero();
    for (Index p = 0; p < rule.size(); ++p) {
      const Vector3 xi = rule.points.row(p), gradient = bubble_gradient(type, xi);
      sum += rule.weights[p] * gradient;
      moment += rule.weights[p] * xi * gradient.transpose();
    }
    EXPECT_LT(sum.norm(), 1e-14);
    EXPECT_LT((moment + volume * Matrix3::Identity()).norm(), 1e-14) << moment;
  }
  EXPECT_THROW(bubble_gradient(CellType::hex8, Vector3::Zero()), std::invalid_argument);
}

TEST(ReferenceElement, OnlyLinearTetrahedraAndWedgesLock) {
  for (const CellType type : {CellType::tet4, CellType::wedge6}) EXPECT_TRUE(reference_element(type).locks());
  for (const CellType type : {CellType::tet10, CellType::hex8, CellType::hex20, CellType::hex27, CellType::wedge15})
    EXPECT_FALSE(reference_element(type).locks());
}

TEST(ReferenceElement, DoesNotExistForAPoint) {
  EXPECT_THROW(reference_element(CellType::point1), std::invalid_argument);
}

}  // namespace
}  // namespace creepcontact::fem
