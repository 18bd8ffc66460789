#pragma once
/// ARKODE: adaptive one-step Runge-Kutta methods (Reynolds et al. 2023), explicit or diagonally implicit.

#include <sundials/sundials_linearsolver.h>

#include <memory>
#include <optional>

#include "sundials_integrator.hpp"
#include "tangent_solver.hpp"

namespace creepcontact::ode {

class ArkodeIntegrator final : public SundialsIntegrator {
 public:
  /// Explicit, for times short against the relaxation; Bogacki-Shampine 3(2), or Dormand-Prince 5(4) if options.table
  /// names it.
  static std::unique_ptr<Integrator> explicit_rk(System& system, const IntegratorOptions& options);
  /// With the Newton iteration of cvode_bdf in every stage; ESDIRK 3(2), L-stable and stiffly accurate (Kennedy
  /// and Carpenter 2003, ARK3(2)4L[2]SA).
  static std::unique_ptr<Integrator> diagonally_implicit_rk(System& system, const IntegratorOptions& options);
  ~ArkodeIntegrator() override;

 protected:
  void restart(double t, N_Vector y, double first_step) override;
  int set_stop(double t) override;
  int set_smallest_step(double step) override;
  int evolve(double horizon, N_Vector y, double& t) override;
  int interpolate_into(double t, N_Vector y) const override;
  int local_errors(N_Vector errors) const override;
  double internal_time() const override;
  Statistics statistics() const override;
  int restart_interval() const override { return options_.restart_interval; }

 private:
  enum class Kind { explicit_rk, implicit_rk };
  ArkodeIntegrator(std::string name, Kind kind, System& system, const IntegratorOptions& options);
  void use_newton_krylov();
  void use_newton_tangent();
  void use_stage_settings();

  Kind kind_;
  int order_ = 0;
  void* memory_ = nullptr;
  SUNLinearSolver linear_ = nullptr;
  std::optional<TangentSolver> tangent_;
};

}  // namespace creepcontact::ode
