#include "arkode_integrator.hpp"

#include <arkode/arkode_arkstep.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include <new>

#include "butcher_tables.hpp"
#include "krylov_settings.hpp"

namespace creepcontact::ode {

namespace {
const ButcherTable& table_of(bool implicit, const IntegratorOptions& options) {
  const std::vector<ButcherTable>& tables = implicit ? diagonally_implicit_tables() : explicit_tables();
  return options.table.empty() ? tables.front() : find_table(tables, options.table);
}
/// Extrapolates from the last step, at lower order for the later stages: a quarter fewer evaluations than starting the
/// stages from the old state, and more robust over long steps than extrapolating at full order.
constexpr int variable_order_predictor = 2;
/// With a tangent of some steps before, Newton's method converges linearly: one iteration more than SUNDIALS' three
/// costs less than a failed step. On growing contact 88 factorisations instead of 102, and 3 % more solves.
constexpr int max_tangent_iterations = 4;
}  // namespace

ArkodeIntegrator::ArkodeIntegrator(std::string name, Kind kind, System& system, const IntegratorOptions& options)
    : SundialsIntegrator(std::move(name), system, options), kind_(kind) {
  const ARKRhsFn rate = SundialsCallbacks::rate;
  const bool implicit = kind == Kind::implicit_rk;
  const ButcherTable& table = table_of(implicit, options);  // throws for an unknown one, before there is memory to free
  memory_ = ARKStepCreate(implicit ? nullptr : rate, implicit ? rate : nullptr, 0.0, state_.get(), context_);
  if (!memory_) throw std::bad_alloc();
  check(ARKStepSetErrHandlerFn(memory_, SundialsCallbacks::message, &callbacks_), "ARKStepSetErrHandlerFn");
  check(ARKStepSetUserData(memory_, &callbacks_), "ARKStepSetUserData");
  check(ARKStepWFtolerances(memory_, SundialsCallbacks::weights), "ARKStepWFtolerances");
  order_ = table.order;
  check(ARKStepSetTableName(memory_, implicit ? table.arkode_name.c_str() : "ARKODE_DIRK_NONE",
                            implicit ? "ARKODE_ERK_NONE" : table.arkode_name.c_str()),
        "ARKStepSetTableName");
}

ArkodeIntegrator::~ArkodeIntegrator() {
  ARKStepFree(&memory_);
  if (linear_) SUNLinSolFree(linear_);
}

std::unique_ptr<Integrator> ArkodeIntegrator::explicit_rk(System& system, const IntegratorOptions& options) {
  return std::unique_ptr<Integrator>(new ArkodeIntegrator("arkode_erk", Kind::explicit_rk, system, options));
}

std::unique_ptr<Integrator> ArkodeIntegrator::diagonally_implicit_rk(System& system, const IntegratorOptions& options) {
  std::unique_ptr<ArkodeIntegrator> arkode(new ArkodeIntegrator("arkode_dirk", Kind::implicit_rk, system, options));
  options.linear_solver == LinearSolver::tangent ? arkode->use_newton_tangent() : arkode->use_newton_krylov();
  arkode->use_stage_settings();
  return arkode;
}

void ArkodeIntegrator::use_newton_krylov() {
  linear_ = SUNLinSol_SPGMR(state_.get(), SUN_PREC_LEFT, krylov_dimension, context_);
  if (!linear_) throw std::bad_alloc();
  check(ARKStepSetLinearSolver(memory_, linear_, nullptr), "ARKStepSetLinearSolver");
  check(ARKStepSetJacTimes(memory_, nullptr, SundialsCallbacks::jacobian_times), "ARKStepSetJacTimes");
  check(ARKStepSetPreconditioner(memory_, SundialsCallbacks::prepare_preconditioner, SundialsCallbacks::precondition),
        "ARKStepSetPreconditioner");
  check(ARKStepSetEpsLin(memory_, krylov_coefficient), "ARKStepSetEpsLin");
  check(ARKStepSetJacEvalFrequency(memory_, linearisation_interval), "ARKStepSetJacEvalFrequency");
}

void ArkodeIntegrator::use_newton_tangent() {
  tangent_.emplace(callbacks_, context_);
  check(ARKStepSetLinearSolver(memory_, tangent_->solver.get(), tangent_->matrix.get()), "ARKStepSetLinearSolver");
  check(ARKStepSetLinSysFn(memory_, SundialsCallbacks::prepare_tangent_with_mass), "ARKStepSetLinSysFn");
  check(ARKStepSetMaxNonlinIters(memory_, max_tangent_iterations), "ARKStepSetMaxNonlinIters");
}

void ArkodeIntegrator::use_stage_settings() {
  check(ARKStepSetNonlinConvCoef(memory_, newton_coefficient), "ARKStepSetNonlinConvCoef");
  check(ARKStepSetPredictorMethod(memory_, variable_order_predictor), "ARKStepSetPredictorMethod");
  // The stage rate from the stage equation instead of from f: one evaluation less a stage, and the error of the
  // Newton iteration is not multiplied by the stiffness on its way into the next step and the dense output. (Without
  // it, long steps near a steady state fail.)
  check(ARKStepSetDeduceImplicitRhs(memory_, SUNTRUE), "ARKStepSetDeduceImplicitRhs");
}

void ArkodeIntegrator::restart(double t, N_Vector y, double first_step) {
  const ARKRhsFn rate = SundialsCallbacks::rate;
  const bool implicit = kind_ == Kind::implicit_rk;
  check(ARKStepReInit(memory_, implicit ? nullptr : rate, implicit ? rate : nullptr, t, y), "ARKStepReInit");
  check(ARKStepSetInitStep(memory_, first_step), "ARKStepSetInitStep");
}

int ArkodeIntegrator::set_stop(double t) {
  return ARKStepSetStopTime(memory_, t);
}

int ArkodeIntegrator::set_smallest_step(double step) {
  return ARKStepSetMinStep(memory_, step);
}

int ArkodeIntegrator::evolve(double horizon, N_Vector y, double& t) {
  return ARKStepEvolve(memory_, horizon, y, &t, ARK_ONE_STEP);
}

int ArkodeIntegrator::interpolate_into(double t, N_Vector y) const {
  return ARKStepGetDky(memory_, t, 0, y);
}

int ArkodeIntegrator::local_errors(N_Vector errors) const {
  return ARKStepGetEstLocalErrors(memory_, errors);
}

double ArkodeIntegrator::internal_time() const {
  double t = 0;
  check(ARKStepGetCurrentTime(memory_, &t), "ARKStepGetCurrentTime");
  return t;
}

SundialsIntegrator::Statistics ArkodeIntegrator::statistics() const {
  Statistics now;
  long attempts = 0;
  check(ARKStepGetNumSteps(memory_, &now.steps), "ARKStepGetNumSteps");
  check(ARKStepGetNumErrTestFails(memory_, &now.rejected), "ARKStepGetNumErrTestFails");
  check(ARKStepGetNumStepAttempts(memory_, &attempts), "ARKStepGetNumStepAttempts");
  // Every other failed attempt is one of the stage iterations or of a rate that could not be evaluated.
  now.convergence_failures = attempts - now.steps - now.rejected;
  check(ARKStepGetCurrentStep(memory_, &now.next_step), "ARKStepGetCurrentStep");
  now.order = order_;
  return now;
}

}  // namespace creepcontact::ode
