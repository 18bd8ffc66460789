#pragma once
/// GMRES with right preconditioning and without restart. Unlike Eigen's it spends no product on its start from zero,
/// which would cost an elastic solve where the flexibility is an operator.

#include <Eigen/Core>
#include <Eigen/Jacobi>
#include <cmath>
#include <vector>

namespace creepcontact::contact {

struct GmresResult {
  Eigen::VectorXd solution;
  int iterations = 0;
  bool converged = false;
};

/// @param product  v -> A v @param precondition  v -> M^-1 v @param tolerance  of |b - A x| relative to |b|
/// Source: Saad and Schultz (1986), Saad (2003), algorithm 9.5.
template <typename Product, typename Precondition>
GmresResult gmres(const Product& product, const Precondition& precondition, const Eigen::VectorXd& right,
                  double tolerance, int max_iterations) {
  constexpr double breakdown = 1e-13;
  GmresResult result{Eigen::VectorXd::Zero(right.size()), 0, true};
  const double size = right.norm();
  if (size == 0) return result;
  std::vector<Eigen::VectorXd> basis{right / size};
  std::vector<Eigen::JacobiRotation<double>> rotations;
  Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(max_iterations + 1, max_iterations);
  Eigen::VectorXd rest = Eigen::VectorXd::Zero(max_iterations + 1);
  rest[0] = size;
  result.converged = false;
  int k = 0;
  while (k < max_iterations && !result.converged) {
    Eigen::VectorXd next = product(precondition(basis[k]));
    auto column = triangle.col(k);
    for (int pass = 0; pass < 2; ++pass)  // twice is enough against round-off
      for (int i = 0; i <= k; ++i) {
        const double part = basis[i].dot(next);
        column[i] += part;
        next -= part * basis[i];
      }
    const double left = next.norm();
    double last = left;
    for (int i = 0; i < k; ++i) column.applyOnTheLeft(i, i + 1, rotations[i].adjoint());
    column[k + 1] = last;
    rotations.emplace_back().makeGivens(column[k], column[k + 1]);
    column.applyOnTheLeft(k, k + 1, rotations[k].adjoint());
    rest.applyOnTheLeft(k, k + 1, rotations[k].adjoint());
    // A singular preconditioner: the residual is not what the rotations say.
    if (!(std::abs(column[k]) > breakdown * triangle.topLeftCorner(k + 1, k + 1).cwiseAbs().maxCoeff())) break;
    ++k;
    result.converged = std::abs(rest[k]) <= tolerance * size;
    if (!(left > 0)) break;
    basis.emplace_back(next / left);
  }
  Eigen::VectorXd weights = rest.head(k);
  triangle.topLeftCorner(k, k).triangularView<Eigen::Upper>().solveInPlace(weights);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(right.size());
  for (int i = 0; i < k; ++i) sum += weights[i] * basis[i];
  result.solution = precondition(sum);
  result.iterations = k;
  return result;
}

}  // namespace creepcontact::contact
