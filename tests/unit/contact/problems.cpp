#include "unit/contact/problems.hpp"

#include <algorithm>
#include <utility>

#include "creepcontact/base/index.hpp"

namespace creepcontact::test {

Eigen::MatrixXd random_flexibility(int n, std::mt19937& generator, double scale) {
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd half = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return normal(generator); });
  // Like a surface's flexibility: diagonally strong, all entries of one family.
  return scale * (half * half.transpose() / n + Eigen::MatrixXd::Identity(n, n));
}

ContactProblem chain(int n_pairs, int rows_per_pair, double stiffness_ratio, std::mt19937& generator, int n_floating) {
  ContactProblem problem;
  const int n = n_pairs * rows_per_pair;
  problem.total.setZero(n, n);
  problem.bilateral.assign(n, 0);
  problem.rigid.setZero(n, Index{2} * n_floating);
  for (int b = 0; b <= n_pairs; ++b) {
    contact::Flexibility body;
    for (int r = std::max(b - 1, 0) * rows_per_pair; r < std::min(b + 1, n_pairs) * rows_per_pair; ++r)
      body.rows.push_back(r);
    const int n_rows = static_cast<int>(body.rows.size());
    body.matrix = random_flexibility(n_rows, generator, b % 2 == 0 ? 1.0 : 1 / stiffness_ratio);
    problem.total(body.rows, body.rows) += body.matrix;
    // Translation across the joints and rotation: moving towards the first body closes its one side, opens the other.
    Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(n_rows, problem.rigid.cols());
    if (const Index floating = b - (n_pairs + 1 - n_floating); floating >= 0)
      for (Index k = 0; k < n_rows; ++k) {
        const double side = body.rows[k] / rows_per_pair < b ? 1.0 : -1.0;
        rigid(k, 2 * floating) = side;
        rigid(k, 2 * floating + 1) = side * (2.0 * static_cast<double>(k % rows_per_pair) / (rows_per_pair - 1) - 1.0);
      }
    problem.rigid(body.rows, Eigen::all) += rigid;
    problem.rigid_of_body.push_back(std::move(rigid));
    problem.bodies.push_back(std::move(body));
  }
  for (int r = 0; r < n; ++r) {
    problem.slave_body.push_back(r / rows_per_pair);
    problem.master_body.push_back(r / rows_per_pair + 1);
  }
  return problem;
}

void expect_solved(const ContactProblem& problem, const ContactLoad& load, const ContactState& state,
                   double tolerance) {
  const Eigen::VectorXd& multiplier = state.multiplier;
  const Eigen::VectorXd gap = contact_gaps(problem, load, state);
  const double rounding = contact::multiplier_rounding(problem, load);
  const double error = tolerance * multiplier.cwiseAbs().maxCoeff() + rounding;
  const Eigen::VectorXd flexibility = contact::row_flexibility(problem);
  for (int i = 0; i < problem.n_rows(); ++i) {
    const double opening = gap[i] / flexibility[i];
    if (problem.bilateral[i])
      EXPECT_NEAR(opening, 0, error);
    else
      EXPECT_NEAR(std::min(multiplier[i], opening), 0, error);
  }
  if (problem.n_motions() > 0) {
    const Eigen::VectorXd left = problem.rigid.transpose() * multiplier + load.resultant;
    EXPECT_LE(left.cwiseAbs().maxCoeff(),
              tolerance * multiplier.cwiseAbs().sum() + rounding * static_cast<double>(problem.n_rows()));
  }
}

}  // namespace creepcontact::test
