#include "support/run/dense_solvers.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "creepcontact/base/index.hpp"

namespace creepcontact::run::test {
namespace {

/// Dense Cholesky factors; the trailing unknowns come last in the order.
class DenseCholesky : public linalg::StiffnessSolver {
 public:
  DenseCholesky(Index size, std::span<const std::int64_t> trailing) : n_trailing_(std::ssize(trailing)) {
    std::vector<bool> is_trailing(size);
    for (const std::int64_t unknown : trailing) is_trailing[unknown] = true;
    for (Index i = 0; i < size; ++i)
      if (!is_trailing[i]) order_.push_back(i);
    order_.insert(order_.end(), trailing.begin(), trailing.end());
  }

  std::unique_ptr<StiffnessSolver> same_pattern() const override { return std::make_unique<DenseCholesky>(*this); }
  void factorize(const linalg::SparseMatrix& lower) override {
    const Eigen::MatrixXd whole = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
    factor_ = whole(order_, order_).llt().matrixL();
    const auto diagonal = factor_.diagonal();
    for (Index i = 0; i < diagonal.size(); ++i)
      if (!(diagonal[i] > 1e-6 * diagonal.maxCoeff())) throw linalg::SingularMatrix{order_[i], rcond()};
  }
  std::int64_t size() const override { return std::ssize(order_); }
  std::int64_t trailing_size() const override { return n_trailing_; }
  linalg::TaskList& forward_tasks(std::span<const double> b, std::span<double> y) override {
    return task_ = {1.0, [this, b, y] { substitute_forward(b, y); }};
  }
  linalg::TaskList& backward_tasks(std::span<const double> y, std::span<double> x) override {
    return task_ = {1.0, [this, y, x] { substitute_backward(y, x); }};
  }
  void substitute_forward(std::span<const double> b, std::span<double> y) const {
    const Eigen::VectorXd ordered = Eigen::VectorXd::Map(b.data(), b.size())(order_);
    Eigen::VectorXd::Map(y.data(), y.size()) = factor_.triangularView<Eigen::Lower>().solve(ordered);
  }
  void substitute_backward(std::span<const double> y, std::span<double> x) const {
    const Eigen::VectorXd ordered =
        factor_.triangularView<Eigen::Lower>().transpose().solve(Eigen::VectorXd::Map(y.data(), y.size()));
    Eigen::VectorXd::Map(x.data(), x.size())(order_) = ordered;
  }
  Eigen::MatrixXd trailing_factor() const override { return factor_.bottomRightCorner(n_trailing_, n_trailing_); }
  std::int64_t factor_bytes() const override { return 8 * size() * size(); }
  std::int64_t work_bytes() const override { return 16 * size() * size(); }
  double rcond() const override { return std::pow(factor_.diagonal().minCoeff() / factor_.diagonal().maxCoeff(), 2); }

 protected:
  void solve(std::span<const double> b, std::span<double> x, double error) const {
    std::vector<double> y(b.size());
    substitute_forward(b, y);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] *= 1 + (i % 2 == 0 ? error : -error);
    substitute_backward(y, x);
  }

 private:
  std::vector<Index> order_;
  Index n_trailing_;
  Eigen::MatrixXd factor_;
  linalg::SingleTask task_;
};

class Inexact final : public DenseCholesky {
 public:
  Inexact(Index size, double error) : DenseCholesky(size, {}), error_(error) {}
  std::unique_ptr<StiffnessSolver> same_pattern() const override { return std::make_unique<Inexact>(*this); }
  linalg::TaskList& forward_tasks(std::span<const double> b, std::span<double> y) override {
    return task_ = {1.0, [b, y] { std::copy(b.begin(), b.end(), y.begin()); }};
  }
  linalg::TaskList& backward_tasks(std::span<const double> y, std::span<double> x) override {
    return task_ = {1.0, [this, y, x] { solve(y, x, error_); }};
  }
  Eigen::MatrixXd trailing_factor() const override {
    ADD_FAILURE() << "there is none";
    return {};
  }
  double error_bound() const override { return error_; }

 private:
  double error_;
  linalg::SingleTask task_;
};

class WithoutMemory final : public DenseCholesky {
 public:
  using DenseCholesky::DenseCholesky;
  void factorize(const linalg::SparseMatrix& /*lower*/) override { ADD_FAILURE() << "there is no memory"; }
  std::int64_t factor_bytes() const override { return std::int64_t{1} << 60; }
};

}  // namespace

std::unique_ptr<linalg::StiffnessSolver> dense_cholesky(const linalg::StiffnessToAnalyze& matrix) {
  return std::make_unique<DenseCholesky>(matrix.lower.matrix().rows(), matrix.trailing);
}

linalg::StiffnessSolverFactory inexact_solvers(double error) {
  return [error](const linalg::StiffnessToAnalyze& matrix) {
    return std::make_unique<Inexact>(matrix.lower.matrix().rows(), error);
  };
}

std::unique_ptr<linalg::StiffnessSolver> without_memory(const linalg::StiffnessToAnalyze& matrix) {
  return std::make_unique<WithoutMemory>(matrix.lower.matrix().rows(), matrix.trailing);
}

}  // namespace creepcontact::run::test
