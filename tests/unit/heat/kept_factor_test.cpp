#include "../../../src/heat/kept_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <cmath>
#include <vector>

namespace creepcontact::heat {
namespace kept_factor_tests {
namespace {

/// Lower triangle of c times capacities + conduction of a bar of linear elements, with a film at one end.
linalg::SparseMatrix bar(double c, int n) {
  linalg::SparseMatrix lower(n, n);
  const double h = 1.0 / (n - 1);
  for (int i = 0; i < n; ++i) {
    const double elements = i == 0 || i == n - 1 ? 1 : 2;
    lower.insert(i, i) = elements * (c * h / 3 + 1 / h) + (i == 0 ? 1 : 0);
    if (i + 1 < n) lower.insert(i + 1, i) = c * h / 6 - 1 / h;
  }
  lower.makeCompressed();
  return lower;
}

/// A step that is 10, 1000, ... times longer or shorter than that of the factor: what is taken for solved is solved.
TEST(KeptFactor, IsNotTakenForNearWhereItIsFar) {
  constexpr int n = 60;
  for (const double far : {1e-6, 1e-3, 0.1, 10.0, 1e3, 1e6}) {
    KeptFactor factor;
    const linalg::SparseMatrix made = bar(1e4, n), now = bar(1e4 * far, n);
    factor.set(made);
    std::vector<double> x(n, 1.0);
    factor.solve(x, {1e-8, 0});
    factor.set(now);
    Eigen::VectorXd right(n);
    for (int i = 0; i < n; ++i) right[i] = std::sin(0.3 * i) / n;
    const Eigen::VectorXd exact = Eigen::SimplicialLDLT<linalg::SparseMatrix, Eigen::Lower>(now).solve(right);
    const double tolerance = 0.1 * exact.norm() / std::sqrt(n);
    x.assign(right.data(), right.data() + n);
    factor.solve(x, {1e-8, tolerance});
    EXPECT_LE((Eigen::Map<Eigen::VectorXd>(x.data(), n) - exact).norm(), 1.5 * tolerance * std::sqrt(n)) << far;
  }
}

/// What is left of a factorisation that failed is no factor.
TEST(KeptFactor, GoesOnAfterASingularMatrix) {
  constexpr int n = 20;
  KeptFactor factor;
  linalg::SparseMatrix singular = bar(0, n);
  singular.coeffRef(0, 0) -= 1;  // without the film
  const linalg::SparseMatrix regular = bar(10, n);
  factor.set(singular);
  EXPECT_THROW(factor.factorize(), linalg::SingularMatrix);
  factor.set(regular);
  std::vector<double> x(n, 1.0);
  factor.solve(x, {1e-8, 1e3});
  const Eigen::VectorXd exact =
      Eigen::SimplicialLDLT<linalg::SparseMatrix, Eigen::Lower>(regular).solve(Eigen::VectorXd::Ones(n));
  for (int i = 0; i < n; ++i) EXPECT_NEAR(x[static_cast<std::size_t>(i)], exact[i], 1e-6 * exact[i]);
}

}  // namespace
}  // namespace kept_factor_tests
}  // namespace creepcontact::heat
