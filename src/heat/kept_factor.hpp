#pragma once
/// Solutions with matrices that change little by little, by the factor of an earlier one.

#include <memory>
#include <span>

#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::heat {

/// Conjugate gradients, preconditioned by the factor of the last matrix that was factored. Another one is factored when
/// the iterations have cost as much as that costs. Matrices are symmetric, positive definite, of one pattern.
class KeptFactor {
 public:
  /// What follows is solved with this matrix, which must outlive the next call.
  void set(const linalg::SparseMatrix& lower);
  /// Factors the matrix now. @throws linalg::SingularMatrix
  void factorize();
  /// The error of a solution is at most one of both: in the energy norm as part of the solution, or as the root mean
  /// square.
  struct Accuracy {
    double relative = 0, absolute = 0;
  };
  /// x = matrix^-1 x. @throws linalg::SingularMatrix
  void solve(std::span<double> x, Accuracy accuracy);

  std::size_t n_factorizations() const { return n_factorizations_; }
  /// Passes through the factors, forward and backward.
  std::size_t n_passes() const { return n_passes_; }

 private:
  void pass(std::span<double> x);
  /// @return false: the iterations do not converge; x is then as it was
  bool iterate(std::span<double> x, Accuracy accuracy);
  /// Passes that cost as much as a factorisation, about.
  double worth() const;

  const linalg::SparseMatrix* matrix_ = nullptr;
  std::unique_ptr<linalg::StiffnessSolver> solver_;
  bool has_factor_ = false, is_exact_ = false;  // the factor is that of the matrix
  double spent_ = 0;                            // passes more than with an exact factor, since the last factorisation
  std::size_t n_factorizations_ = 0, n_passes_ = 0;
};

}  // namespace creepcontact::heat
