#pragma once
/// Supernodal Cholesky factor (CHOLMOD), ordered by METIS node by node. factorize() uses all cores; passes are those of
/// SupernodalPass.
/// Source: Chen, Davis, Hager and Rajamanickam, Algorithm 887 (2008).

#include <memory>
#include <vector>

#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::linalg {

class SupernodalPass;

class SupernodalCholesky final : public StiffnessSolver {
 public:
  /// See StiffnessToAnalyze. @throws as StiffnessSolverFactory
  SupernodalCholesky(const SparseMatrix& lower, std::span<const std::int64_t> block_of,
                     std::span<const std::int64_t> trailing);
  ~SupernodalCholesky() override;
  SupernodalCholesky(SupernodalCholesky&&) noexcept;
  SupernodalCholesky& operator=(SupernodalCholesky&&) noexcept;

  /// It shares the analysis and the factor, until it computes another one. Cost: memory of some vectors
  std::unique_ptr<StiffnessSolver> same_pattern() const override;
  const void* shared_factor() const override { return factor_.get(); }
  void factorize(const SparseMatrix& lower) override;
  std::int64_t size() const override;
  std::int64_t trailing_size() const override;
  TaskList& forward_tasks(std::span<const double> b, std::span<double> y) override;
  TaskList& backward_tasks(std::span<const double> y, std::span<double> x) override;
  TaskList& tasks_of_several(PassDirection direction, std::span<const PassVector> vectors) override;
  Eigen::MatrixXd trailing_factor() const override;
  std::int64_t factor_bytes() const override;
  std::int64_t work_bytes() const override;
  double rcond() const override;

 private:
  struct Analysis;
  struct Factor;
  SupernodalCholesky(const SupernodalCholesky& other);
  void prepare_passes();
  bool is_empty() const;
  std::span<const double> apart(std::span<const double> from, std::span<double> into, std::size_t vector);

  std::shared_ptr<const Analysis> analysis_;
  std::shared_ptr<Factor> factor_;  // null: none is computed
  std::unique_ptr<SupernodalPass> passes_;
  SingleTask nothing_;
  std::vector<std::vector<double>> copies_;
};

}  // namespace creepcontact::linalg
