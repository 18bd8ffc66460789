#pragma once
/// Supernodal Cholesky factor (CHOLMOD), ordered by METIS node by node. factorize() uses all cores; passes are those of
/// SupernodalPass.
/// Source: Chen, Davis, Hager and Rajamanickam, Algorithm 887 (2008).

#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::linalg {

class SupernodalCholesky final : public StiffnessSolver {
 public:
  /// See StiffnessToAnalyze. @throws as StiffnessSolverFactory
  SupernodalCholesky(const SparseMatrix& lower, std::span<const std::int64_t> block_of,
                     std::span<const std::int64_t> trailing);
  ~SupernodalCholesky() override;
  SupernodalCholesky(SupernodalCholesky&&) noexcept;
  SupernodalCholesky& operator=(SupernodalCholesky&&) noexcept;

  std::unique_ptr<StiffnessSolver> same_pattern() const override;
  void factorize(const SparseMatrix& lower) override;
  std::int64_t size() const override;
  std::int64_t trailing_size() const override;
  TaskList& forward_tasks(std::span<const double> b, std::span<double> y) override;
  TaskList& backward_tasks(std::span<const double> y, std::span<double> x) override;
  Eigen::MatrixXd trailing_factor() const override;
  std::int64_t factor_bytes() const override;
  std::int64_t work_bytes() const override;
  double rcond() const override;

 private:
  struct Impl;
  explicit SupernodalCholesky(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace creepcontact::linalg
