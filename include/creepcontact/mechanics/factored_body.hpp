#pragma once
/// The stiffness of one body, factored at one time.

#include <span>
#include <utility>
#include <vector>

#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::mechanics {

class FactoredBody {
 public:
  /// Orders and analyses the stiffness of the free unknowns, the pins fixed; factorize() must follow. In between the
  /// sizes of solver() are known, and nothing of them is taken.
  /// @param body, at  must outlive the object until factorize() has been called, the body as long as the object
  /// @param trailing  free unknowns to be eliminated last (those of the contact surfaces)
  FactoredBody(const Body& body, const BodyConditions& at, const std::vector<std::int64_t>& trailing,
               const linalg::StiffnessSolverFactory& make_solver = linalg::default_stiffness_solver);

  /// Factors the stiffness of these conditions, in the order and with the pattern found before. At the first time
  /// hourglass modes of hex20 elements in single rows are stabilised, with a warning.
  /// @throws ModelError naming the body and the place if the stiffness is singular
  void factorize(const BodyConditions& at);

  const Body& body() const { return *body_; }
  linalg::StiffnessSolver& solver() { return *solver_; }
  const linalg::StiffnessSolver& solver() const { return *solver_; }
  /// Of the conditions that were factored.
  double time() const { return time_; }
  /// Elastic constants that were factored, without thermal strain.
  ElasticState elastic() const { return {moduli_, {}}; }
  /// Least and largest ratio of the bulk and shear moduli to those of the factor, over all points: the eigenvalues of
  /// K0^-1 K(t) lie between them. {1, 1} if the stiffness does not change.
  std::pair<double, double> stiffness_ratio(const BodyConditions& at) const;

  /// Lower triangle over the free unknowns.
  linalg::SparseMatrix stiffness(const BodyConditions& at) const;
  /// The same with symmetric moduli of any kind, one per point, in place of the elastic ones.
  linalg::SparseMatrix stiffness(std::span<const Matrix6> moduli) const;
  /// Body::residual less the forces of the hourglass stabilisation. @param free  the free unknowns
  void residual(const BodyConditions& at, std::span<const double> stress, std::span<const double> free,
                std::span<double> residual) const;

 private:
  void stabilize(const BodyConditions& at);
  [[noreturn]] void report_singular(const linalg::SingularMatrix& error) const;

  const Body* body_;
  std::unique_ptr<linalg::StiffnessSolver> solver_;
  linalg::SparseMatrix analyzed_;  // the stiffness, until factorize()
  std::vector<Moduli> moduli_;
  double time_ = 0;
  bool factored_ = false;

  // Where hourglass modes are held: the diagonal of the elastic stiffness that measures what holds them, and that
  // itself on the free unknowns. They stay as they are: they stand for no material.
  bool stabilized_ = false;
  Eigen::VectorXd hourglass_diagonal_;
  linalg::SparseMatrix hourglass_;
};

/// Bytes of the factor of a body's stiffness at t = 0, and of the work space of its factorisation.
std::int64_t estimate_factor_bytes(const Body& body);

}  // namespace creepcontact::mechanics
