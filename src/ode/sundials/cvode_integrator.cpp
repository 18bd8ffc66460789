#include "cvode_integrator.hpp"

#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <new>

#include "krylov_settings.hpp"

namespace creepcontact::ode {

namespace {
/// The higher orders are weakly damped: their steps oscillate and fail where contact changes or a steady state comes
/// near, and they pay by fewer steps for small tolerances only. Solves for the same error of the stress: with order 3 a
/// fifth fewer than with 4 at 1e-2 to 1e-3, a third more at 1e-6; order 5 costs twice as many on growing contact.
int max_bdf_order(double tolerance) {
  return tolerance >= 2e-4 ? 3 : 4;
}
/// Creep has not been seen to use higher ones, but their vectors would be allocated.
constexpr int max_adams_order = 6;
constexpr int anderson_depth = 3;
/// Two more than SUNDIALS' three, with which an iteration that has found out where a law yields comes to its end.
constexpr int max_newton_iterations = 5;
}  // namespace

CvodeIntegrator::CvodeIntegrator(std::string name, int method, System& system, const IntegratorOptions& options)
    : SundialsIntegrator(std::move(name), system, options), memory_(CVodeCreate(method, context_)) {
  if (!memory_) throw std::bad_alloc();
  check(CVodeSetErrHandlerFn(memory_, SundialsCallbacks::message, &callbacks_), "CVodeSetErrHandlerFn");
  check(CVodeInit(memory_, SundialsCallbacks::rate, 0.0, state_.get()), "CVodeInit");
  check(CVodeSetUserData(memory_, &callbacks_), "CVodeSetUserData");
  check(CVodeWFtolerances(memory_, SundialsCallbacks::weights), "CVodeWFtolerances");
}

CvodeIntegrator::~CvodeIntegrator() {
  CVodeFree(&memory_);
  if (linear_) SUNLinSolFree(linear_);
  if (nonlinear_) SUNNonlinSolFree(nonlinear_);
}

std::unique_ptr<Integrator> CvodeIntegrator::bdf(System& system, const IntegratorOptions& options) {
  std::unique_ptr<CvodeIntegrator> cvode(new CvodeIntegrator("cvode_bdf", CV_BDF, system, options));
  options.linear_solver == LinearSolver::tangent ? cvode->use_newton_tangent() : cvode->use_newton_krylov();
  return cvode;
}

std::unique_ptr<Integrator> CvodeIntegrator::adams(System& system, const IntegratorOptions& options) {
  std::unique_ptr<CvodeIntegrator> cvode(new CvodeIntegrator("cvode_adams", CV_ADAMS, system, options));
  cvode->use_fixed_point();
  return cvode;
}

void CvodeIntegrator::use_newton_krylov() {
  linear_ = SUNLinSol_SPGMR(state_.get(), SUN_PREC_LEFT, krylov_dimension, context_);
  if (!linear_) throw std::bad_alloc();
  check(CVodeSetLinearSolver(memory_, linear_, nullptr), "CVodeSetLinearSolver");
  check(CVodeSetJacTimes(memory_, nullptr, SundialsCallbacks::jacobian_times), "CVodeSetJacTimes");
  check(CVodeSetPreconditioner(memory_, SundialsCallbacks::prepare_preconditioner, SundialsCallbacks::precondition),
        "CVodeSetPreconditioner");
  check(CVodeSetNonlinConvCoef(memory_, newton_coefficient), "CVodeSetNonlinConvCoef");
  check(CVodeSetEpsLin(memory_, krylov_coefficient), "CVodeSetEpsLin");
  check(CVodeSetJacEvalFrequency(memory_, linearisation_interval), "CVodeSetJacEvalFrequency");
  check(CVodeSetMaxOrd(memory_, max_bdf_order(options_.tolerance)), "CVodeSetMaxOrd");
}

void CvodeIntegrator::use_newton_tangent() {
  tangent_.emplace(callbacks_, context_);
  check(CVodeSetLinearSolver(memory_, tangent_->solver.get(), tangent_->matrix.get()), "CVodeSetLinearSolver");
  check(CVodeSetLinSysFn(memory_, SundialsCallbacks::prepare_tangent), "CVodeSetLinSysFn");
  check(CVodeSetMaxNonlinIters(memory_, max_newton_iterations), "CVodeSetMaxNonlinIters");
  check(CVodeSetNonlinConvCoef(memory_, newton_coefficient), "CVodeSetNonlinConvCoef");
  check(CVodeSetMaxOrd(memory_, max_bdf_order(options_.tolerance)), "CVodeSetMaxOrd");
}

void CvodeIntegrator::use_fixed_point() {
  nonlinear_ = SUNNonlinSol_FixedPoint(state_.get(), anderson_depth, context_);
  if (!nonlinear_) throw std::bad_alloc();
  check(CVodeSetNonlinearSolver(memory_, nonlinear_), "CVodeSetNonlinearSolver");
  check(CVodeSetMaxOrd(memory_, max_adams_order), "CVodeSetMaxOrd");
}

void CvodeIntegrator::restart(double t, N_Vector y, double first_step) {
  check(CVodeReInit(memory_, t, y), "CVodeReInit");
  check(CVodeSetInitStep(memory_, first_step), "CVodeSetInitStep");
}

int CvodeIntegrator::set_stop(double t) {
  return CVodeSetStopTime(memory_, t);
}

int CvodeIntegrator::set_smallest_step(double step) {
  return CVodeSetMinStep(memory_, step);
}

int CvodeIntegrator::evolve(double horizon, N_Vector y, double& t) {
  return CVode(memory_, horizon, y, &t, CV_ONE_STEP);
}

int CvodeIntegrator::interpolate_into(double t, N_Vector y) const {
  return CVodeGetDky(memory_, t, 0, y);
}

int CvodeIntegrator::local_errors(N_Vector errors) const {
  return CVodeGetEstLocalErrors(memory_, errors);
}

double CvodeIntegrator::internal_time() const {
  double t = 0;
  check(CVodeGetCurrentTime(memory_, &t), "CVodeGetCurrentTime");
  return t;
}

SundialsIntegrator::Statistics CvodeIntegrator::statistics() const {
  Statistics now;
  check(CVodeGetNumSteps(memory_, &now.steps), "CVodeGetNumSteps");
  check(CVodeGetNumErrTestFails(memory_, &now.rejected), "CVodeGetNumErrTestFails");
  check(CVodeGetNumStepSolveFails(memory_, &now.convergence_failures), "CVodeGetNumStepSolveFails");
  check(CVodeGetLastOrder(memory_, &now.order), "CVodeGetLastOrder");
  check(CVodeGetCurrentStep(memory_, &now.next_step), "CVodeGetCurrentStep");
  return now;
}

}  // namespace creepcontact::ode
