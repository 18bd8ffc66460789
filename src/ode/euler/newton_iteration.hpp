#pragma once
/// Newton's method for the equation of an implicit step, y = G(y) := constant + gamma f(t, e(y)) with de/dy = 1.

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "convergence_watch.hpp"
#include "creepcontact/ode/system.hpp"

namespace creepcontact::ode {

/// Each correction solves (I - gamma J) dy = G(y) - y by GMRES (SUNDIALS SPGMR) with System::jacobian_times and
/// System::precondition; it is halved while the residual does not fall (Armijo). The preconditioner is on the
/// right, other than in the integrators of SUNDIALS, so that GMRES measures the true residual and its norm bounds the
/// error: on the left it would measure one divided by the stiffness of the step, which creep that changes no stress
/// does not have. Cost of a correction: one evaluation of G, and a Jacobian product for each Krylov vector.
class NewtonIteration {
 public:
  struct Equation {
    double t = 0, gamma = 0;
    /// image = G(y). @throws RecoverableError
    std::function<void(std::span<const double> y, std::span<double> image)> evaluate;
    std::span<const double> point;  ///< e(y) of the last evaluation, where the Jacobian is taken
    std::span<const double> rate;   ///< f(t, e) there
  };

  explicit NewtonIteration(System& system);
  ~NewtonIteration();
  NewtonIteration(const NewtonIteration&) = delete;
  NewtonIteration& operator=(const NewtonIteration&) = delete;

  /// Iterates until the watch has seen enough. It is told of the last change of y, or of the remaining
  /// residual of the linear solver if that is more: in a relaxing system either bounds what it has missed of the
  /// change.
  /// @param y      first guess, where G was evaluated last; the solution
  /// @param image  G of the first guess
  /// @param rate   f of the solution, as the equation has it
  /// @throws RecoverableError if a correction cannot be made; what System throws, as it is
  void run(const Equation& equation, std::span<double> y, std::span<const double> image, std::span<double> rate,
           ConvergenceWatch& watch);

 private:
  struct Krylov;
  /// Takes back of the correction what keeps the residual from falling; residual_ is then that of the new y.
  void line_search(const Equation& equation, std::span<double> y, std::span<const double> dy);

  const Team& team_;
  std::unique_ptr<Krylov> krylov_;
  std::vector<double> residual_;  ///< G(y) - y of the last evaluation
  std::vector<double> base_;      ///< y before the correction
  std::vector<double> image_;
};

}  // namespace creepcontact::ode
