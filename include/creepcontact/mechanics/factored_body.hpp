#pragma once
/// The factored stiffness of one body at one time.

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::mechanics {

/// Stiffness solver of a body, with its fixing dofs fixed.
class FactoredBody {
 public:
  /// Orders and analyses the stiffness of the free dofs; factorize() must follow. Until then the sizes given by
  /// solver() are known, but its memory is not taken.
  /// @param body  must outlive the object @param at  conditions of `body`, for the pattern and the first factorisation
  /// @param trailing  free dofs to be eliminated last (those of the contact surfaces)
  FactoredBody(const Body& body, const BodyConditions& at, const std::vector<std::int64_t>& trailing,
               const linalg::StiffnessSolverFactory& make_solver = linalg::default_stiffness_solver);

  /// Factors the stiffness of these conditions, in the order and with the pattern found before. If the first
  /// factorisation is singular because of hourglass modes of hex20 elements in single rows, these are stabilised, with
  /// a warning.
  /// @throws ModelError naming the body and the position if the stiffness is singular
  void factorize(const BodyConditions& at);

  const Body& body() const { return *body_; }
  linalg::StiffnessSolver& solver() { return *solver_; }
  const linalg::StiffnessSolver& solver() const { return *solver_; }
  /// Time of the conditions that were factored.
  double time() const { return time_; }
  /// Moduli that were factored; no thermal strain.
  ElasticState elastic() const { return {.moduli = moduli_, .matrices = matrices_}; }
  /// Smallest and largest ratio of the bulk and shear moduli, or of the matrices, to the factored ones over all points.
  /// The eigenvalues of K0^-1 K(t) lie between them. {1, 1} if the stiffness does not change.
  std::pair<double, double> stiffness_ratio(const BodyConditions& at) const;

  /// Stiffness on the free dofs, lower triangle, with any hourglass stabilisation. Cost: assembly.
  linalg::SparseMatrix stiffness(const BodyConditions& at) const;
  /// Stiffness with arbitrary symmetric moduli, one per point, instead of the elastic ones.
  linalg::SparseMatrix stiffness(std::span<const Matrix6> moduli) const;
  /// Body::residual less the forces of the hourglass stabilisation. @param free  displacement on the free dofs
  void residual(std::span<const double> external, std::span<const double> stress, std::span<const double> free,
                std::span<double> residual) const;

 private:
  void stabilize(const BodyConditions& at);
  [[noreturn]] void report_singular(const linalg::SingularMatrix& error) const;

  const Body* body_;
  std::unique_ptr<linalg::StiffnessSolver> solver_;
  std::unique_ptr<linalg::SparseMatrix> analyzed_;  // the stiffness until factorize(), if somebody needed it
  std::vector<Moduli> moduli_;
  std::vector<Matrix6> matrices_;
  double time_ = 0;
  bool factored_ = false;

  // Stabilisation of hourglass modes: the diagonal of the elastic stiffness that scales it, and its matrix on the free
  // dofs. Constant, since it represents no material.
  bool stabilized_ = false;
  Eigen::VectorXd hourglass_diagonal_;
  linalg::SparseMatrix hourglass_;
};

/// Bytes of the factor of a body at t = 0 and of the work space of its factorisation. Cost: an assembly and an
/// analysis.
std::int64_t estimate_factor_bytes(const Body& body);

}  // namespace creepcontact::mechanics
