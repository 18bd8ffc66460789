/// Another solver of the stiffness in the place of CHOLMOD's: all that the rest of the program asks of one.

#include <Eigen/Cholesky>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "support/run/blocks.hpp"

namespace creepcontact::run::test {
namespace {

/// Dense Cholesky factors; the trailing unknowns come last in the order.
class DenseCholesky final : public linalg::StiffnessSolver {
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

 private:
  std::vector<Index> order_;
  Index n_trailing_;
  Eigen::MatrixXd factor_;
  linalg::SingleTask task_;
};

std::unique_ptr<linalg::StiffnessSolver> dense_cholesky(const linalg::SparseMatrix& lower,
                                                        std::span<const std::int64_t> /*block_of*/,
                                                        std::span<const std::int64_t> trailing) {
  return std::make_unique<DenseCholesky>(lower.rows(), trailing);
}

struct SolverCase {
  const char* name;
  std::vector<std::string> overrides;
  bool dense = true;  ///< matrices of the contact zone; else products are iterated, and there is no tangent
};

class AnotherStiffnessSolver : public testing::TestWithParam<SolverCase> {};

/// Rates, Jacobian products and solutions of the tangent are those with the default solver.
TEST_P(AnotherStiffnessSolver, GivesTheSameRates) {
  const Case blocks;
  const config::Config config = blocks.config("", GetParam().overrides);
  std::vector<std::vector<double>> results;
  for (const bool dense : {false, true}) {
    Stopwatch watch;
    Model model = build_model(config);
    if (dense) model.solver.stiffness_solver = dense_cholesky;
    creep::EquilibriumSolver solver(model.assembly, model.solver, watch);
    creep::CreepSystem system(solver, creep::survey_elastic_stress(solver, config.time.output, model.breakpoints), 1e-4,
                              watch);
    std::vector<double> y(system.size()), rate(y.size()), product(y.size()), solution(y.size());
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = 0.2 * std::sin(static_cast<double>(i)) * system.scale()[i];
    system.rate(0.1, y, rate);
    system.jacobian_times(0.1, y, y, product);
    if (GetParam().dense) {
      system.prepare_tangent(0.1, y, 0.01);
      system.solve_tangent(y, solution);
    }
    rate.insert(rate.end(), product.begin(), product.end());
    rate.insert(rate.end(), solution.begin(), solution.end());
    results.push_back(rate);
  }
  const std::size_t n = results[0].size() / 3;
  for (std::size_t part = 0; part < 3; ++part) {
    const auto of = [&](int k) { return Eigen::VectorXd::Map(results[k].data() + part * n, n); };
    EXPECT_LE((of(1) - of(0)).norm(), (GetParam().dense ? 1e-8 : 1e-5) * of(0).norm())
        << "rate, product, solution: " << part;
  }
}

INSTANTIATE_TEST_SUITE_P(Contacts, AnotherStiffnessSolver,
                         testing::Values(SolverCase{"closed", {}}, SolverCase{"tied", {"contacts.0.type=tied"}},
                                         SolverCase{"matrix_free", {"contact_solver.dense_limit_mb=1e-6"}, false},
                                         SolverCase{"hot",
                                                    {"temperature.value=100*t*(1+0.3*x)",
                                                     "materials.soft.young_modulus='100-0.08*T'"}}),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace creepcontact::run::test
