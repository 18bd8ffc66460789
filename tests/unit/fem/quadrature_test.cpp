#include "creepcontact/fem/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace creepcontact::fem {
namespace {

double integrate(const QuadratureRule& rule, int a, int b, int c) {
  double sum = 0;
  for (int i = 0; i < rule.size(); ++i) {
    sum += rule.weights[i] * std::pow(rule.points(i, 0), a) * std::pow(rule.points(i, 1), b) *
           std::pow(rule.points(i, 2), c);
  }
  return sum;
}

double line_integral(int a) {
  return a % 2 == 0 ? 2.0 / (a + 1) : 0;
}
double factorial(int n) {
  return std::tgamma(n + 1);
}
double triangle_integral(int a, int b) {
  return factorial(a) * factorial(b) / factorial(a + b + 2);
}
double tetrahedron_integral(int a, int b, int c) {
  return factorial(a) * factorial(b) * factorial(c) / factorial(a + b + c + 3);
}

constexpr double eps = 2e-15;

TEST(Quadrature, GaussLineIsExactToItsDegreeAndNoFurther) {
  for (int n = 1; n <= 5; ++n) {
    const QuadratureRule rule = gauss_line(n);
    ASSERT_EQ(rule.size(), n);
    for (int a = 0; a < 2 * n; ++a) EXPECT_NEAR(integrate(rule, a, 0, 0), line_integral(a), eps) << n << ' ' << a;
    EXPECT_GT(std::abs(integrate(rule, 2 * n, 0, 0) - line_integral(2 * n)), 1e-4);
    for (int i = 1; i < n; ++i) EXPECT_LT(rule.points(i - 1, 0), rule.points(i, 0));
    EXPECT_TRUE(rule.points.rightCols<2>().isZero(0));
  }
}

TEST(Quadrature, TensorProductsAreExactInEveryDirection) {
  for (int n = 1; n <= 4; ++n) {
    const QuadratureRule plane = gauss_quadrilateral(n), space = gauss_hexahedron(n);
    ASSERT_EQ(plane.size(), n * n);
    ASSERT_EQ(space.size(), n * n * n);
    EXPECT_TRUE(plane.points.col(2).isZero(0));
    for (int a = 0; a < 2 * n; ++a) {
      for (int b = 0; b < 2 * n; ++b) {
        const double exact = line_integral(a) * line_integral(b);
        EXPECT_NEAR(integrate(plane, a, b, 0), exact, 4 * eps);
        for (int c = 0; c < 2 * n; ++c) EXPECT_NEAR(integrate(space, a, b, c), exact * line_integral(c), 8 * eps);
      }
    }
  }
}

TEST(Quadrature, TriangleIsExactPositiveAndInside) {
  for (int degree = 1; degree <= 8; ++degree) {
    const QuadratureRule rule = triangle(degree);
    EXPECT_TRUE((rule.weights.array() > 0).all());
    EXPECT_TRUE((rule.points.leftCols<2>().array() > 0).all());
    EXPECT_TRUE((rule.points.rowwise().sum().array() < 1).all());
    EXPECT_TRUE(rule.points.col(2).isZero(0));
    for (int a = 0; a <= degree; ++a) {
      for (int b = 0; a + b <= degree; ++b) {
        EXPECT_NEAR(integrate(rule, a, b, 0), triangle_integral(a, b), 1e-16 + eps * triangle_integral(a, b))
            << degree << ' ' << a << ' ' << b;
      }
    }
  }
}

TEST(Quadrature, TetrahedronIsExactPositiveAndInside) {
  for (int degree = 1; degree <= 5; ++degree) {
    const QuadratureRule rule = tetrahedron(degree);
    EXPECT_TRUE((rule.weights.array() > 0).all());
    EXPECT_TRUE((rule.points.array() > 0).all());
    EXPECT_TRUE((rule.points.rowwise().sum().array() < 1).all());
    for (int a = 0; a <= degree; ++a) {
      for (int b = 0; a + b <= degree; ++b) {
        for (int c = 0; a + b + c <= degree; ++c) {
          EXPECT_NEAR(integrate(rule, a, b, c), tetrahedron_integral(a, b, c), 1e-16) << degree;
        }
      }
    }
  }
}

TEST(Quadrature, WedgeIsExactInPlaneAndHeight) {
  for (const int degree : {2, 5}) {
    for (int n = 1; n <= 3; ++n) {
      const QuadratureRule rule = wedge(degree, n);
      EXPECT_EQ(rule.size(), triangle(degree).size() * n);
      for (int a = 0; a <= degree; ++a) {
        for (int b = 0; a + b <= degree; ++b) {
          for (int c = 0; c < 2 * n; ++c) {
            EXPECT_NEAR(integrate(rule, a, b, c), triangle_integral(a, b) * line_integral(c), eps);
          }
        }
      }
    }
  }
}

TEST(Quadrature, RefusesRulesItDoesNotHave) {
  EXPECT_THROW(gauss_line(0), std::invalid_argument);
  EXPECT_THROW(gauss_line(6), std::invalid_argument);
  EXPECT_THROW(triangle(9), std::invalid_argument);
  EXPECT_THROW(tetrahedron(6), std::invalid_argument);
}

}  // namespace
}  // namespace creepcontact::fem
