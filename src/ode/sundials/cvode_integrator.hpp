#pragma once
/// CVODE: variable-step, variable-order linear multistep methods (Hindmarsh et al. 2005).

#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_nonlinearsolver.h>

#include <memory>
#include <optional>

#include "sundials_integrator.hpp"
#include "tangent_solver.hpp"

namespace creepcontact::ode {

class CvodeIntegrator final : public SundialsIntegrator {
 public:
  /// BDF with Newton iterations, each a preconditioned GMRES solve with System::jacobian_times, or a direct one.
  static std::unique_ptr<Integrator> bdf(System& system, const IntegratorOptions& options);
  /// Adams-Moulton with Anderson-accelerated fixed-point iterations: no Jacobian, for slow creep.
  static std::unique_ptr<Integrator> adams(System& system, const IntegratorOptions& options);
  ~CvodeIntegrator() override;

 protected:
  void restart(double t, N_Vector y, double first_step) override;
  int set_stop(double t) override;
  int set_smallest_step(double step) override;
  int evolve(double horizon, N_Vector y, double& t) override;
  int interpolate_into(double t, N_Vector y) const override;
  int local_errors(N_Vector errors) const override;
  double internal_time() const override;
  Statistics statistics() const override;

 private:
  CvodeIntegrator(std::string name, int method, System& system, const IntegratorOptions& options);
  void use_newton_krylov();
  void use_newton_tangent();
  void use_fixed_point();

  void* memory_ = nullptr;
  SUNLinearSolver linear_ = nullptr;
  std::optional<TangentSolver> tangent_;
  SUNNonlinearSolver nonlinear_ = nullptr;
};

}  // namespace creepcontact::ode
