#include "unit/linalg/matrices.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <random>
#include <span>

#include "creepcontact/base/index.hpp"

namespace creepcontact::linalg::testing {

Eigen::MatrixXd Problem::dense() const {
  return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
}

SparseMatrix lower_of(const Eigen::MatrixXd& dense) {
  SparseMatrix lower = Eigen::MatrixXd(dense.triangularView<Eigen::Lower>()).sparseView();
  lower.makeCompressed();
  return lower;
}

Eigen::VectorXd random_vector(std::int64_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::VectorXd::NullaryExpr(n, [&] { return uniform(random); });
}

Problem grid(int n, int copies, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  const std::int64_t n_nodes = static_cast<std::int64_t>(n) * n * n;
  for (int copy = 0; copy < copies; ++copy) {
    for (int cell = 0; cell < (n - 1) * (n - 1) * (n - 1); ++cell) {
      const int i = cell % (n - 1), j = cell / (n - 1) % (n - 1), k = cell / ((n - 1) * (n - 1));
      const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(24, 24, [&] { return uniform(random); });
      const Eigen::MatrixXd matrix = root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(24, 24);
      const auto unknown = [&](int local) {
        const int corner = local / 3;
        const std::int64_t node = (i + (corner & 1)) + n * ((j + (corner >> 1 & 1)) + n * (k + (corner >> 2)));
        return 3 * (node + copy * n_nodes) + local % 3;
      };
      for (int a = 0; a < 24; ++a) {
        for (int b = 0; b < 24; ++b) {
          if (unknown(a) >= unknown(b)) entries.emplace_back(unknown(a), unknown(b), matrix(a, b));
        }
      }
    }
  }
  Problem problem;
  const std::int64_t size = 3 * n_nodes * copies;
  problem.lower.resize(size, size);
  problem.lower.setFromTriplets(entries.begin(), entries.end());
  for (std::int64_t i = 0; i < size; ++i) problem.node_of.push_back(i / 3);
  return problem;
}

Problem random_sparse(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  for (int k = 0; k < 3 * n; ++k) {
    const Index i = random() % static_cast<unsigned>(n);
    const Index j = random() % static_cast<unsigned>(n);
    if (i != j) dense(i, j) = dense(j, i) = uniform(random);
  }
  for (int i = 0; i < n; ++i) dense(i, i) = 0.5 + dense.row(i).cwiseAbs().sum();
  Problem problem{lower_of(dense), {}};
  for (int i = 0; i < n; ++i) problem.node_of.push_back(1000 - 3 * i);  // any numbers will do
  return problem;
}

Eigen::VectorXd forward(StiffnessSolver& solver, const Eigen::VectorXd& b) {
  Eigen::VectorXd y(b.size());
  solver.forward(std::span(b.data(), b.size()), std::span(y.data(), y.size()));
  return y;
}

Eigen::VectorXd backward(StiffnessSolver& solver, const Eigen::VectorXd& y) {
  Eigen::VectorXd x(y.size());
  solver.backward(std::span(y.data(), y.size()), std::span(x.data(), x.size()));
  return x;
}

Eigen::VectorXd solve(StiffnessSolver& solver, const Eigen::VectorXd& b) {
  return backward(solver, forward(solver, b));
}

Eigen::MatrixXd schur_complement(const Eigen::MatrixXd& a, const std::vector<std::int64_t>& trailing) {
  std::vector<std::int64_t> leading;
  for (std::int64_t i = 0; i < a.rows(); ++i) {
    if (std::find(trailing.begin(), trailing.end(), i) == trailing.end()) leading.push_back(i);
  }
  Eigen::MatrixXd schur = a(trailing, trailing);
  if (!leading.empty()) {
    const Eigen::MatrixXd coupling = a(leading, trailing);
    schur -= coupling.transpose() * a(leading, leading).llt().solve(coupling);
  }
  return schur;
}

}  // namespace creepcontact::linalg::testing
