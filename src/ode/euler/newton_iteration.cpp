#include "newton_iteration.hpp"

#include <sunlinsol/sunlinsol_spgmr.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <stdexcept>
#include <sundials/sundials_context.hpp>
#include <utility>

#include "../elementwise.hpp"
#include "../state_norms.hpp"
#include "../sundials/krylov_settings.hpp"
#include "../sundials/linear_solver_handle.hpp"
#include "../sundials/sundials_vector.hpp"

namespace creepcontact::ode {

namespace {
/// Remaining residual of a linear solve, relative to the first.
constexpr double forcing = 0.01;
constexpr int max_krylov_restarts = 10;
/// Fraction of the decrease of the residual that the linearisation promises.
constexpr double armijo = 1e-4;
constexpr int max_correction_halvings = 12;
}  // namespace

struct NewtonIteration::Krylov {
  explicit Krylov(System& of)
      : system(of),
        size(of.size()),
        right(make_vector(of.team(), size, context)),
        correction(N_VClone(right.get())),
        solver(SUNLinSol_SPGMR(right.get(), SUN_PREC_RIGHT, krylov_dimension, context)) {
    if (!solver || !correction) throw std::bad_alloc();
    SUNLinSol_SPGMRSetMaxRestarts(solver.get(), max_krylov_restarts);
    SUNLinSolSetATimes(solver.get(), this, multiply);
    SUNLinSolSetPreconditioner(solver.get(), this, nullptr, precondition);
    if (SUNLinSolInitialize(solver.get()) != SUNLS_SUCCESS) throw std::runtime_error("SUNLinSolInitialize failed");
  }

  /// correction = (I - gamma J)^-1 residual. @returns the Euclidean norm of what is left of the residual
  double solve(const Equation& of, std::span<const double> residual, double tolerance) {
    equation = &of;
    system.jacobian()->prepare_preconditioner(of.t, of.point);
    std::ranges::copy(residual, view(right.get(), size).begin());
    N_VConst(0.0, correction.get());
    SUNLinSolSetZeroGuess(solver.get(), SUNTRUE);
    SUNLinSolSetup(solver.get(), nullptr);
    const int flag = SUNLinSolSolve(solver.get(), nullptr, correction.get(), right.get(), tolerance);
    if (failure) std::rethrow_exception(std::exchange(failure, nullptr));
    if (flag != SUNLS_SUCCESS && flag != SUNLS_RES_REDUCED)
      throw RecoverableError("the linear equations of the Newton iteration could not be solved");
    return SUNLinSolResNorm(solver.get());
  }

  /// What the last solve() found.
  std::span<const double> found() const { return view(correction.get(), size); }

  /// No exception may cross SUNDIALS.
  template <typename Call>
  int guarded(Call call) noexcept {
    try {
      call();
      return 0;
    } catch (...) {
      failure = std::current_exception();
      return -1;
    }
  }

  static int multiply(void* self, N_Vector v, N_Vector product) {
    Krylov& me = *static_cast<Krylov*>(self);
    return me.guarded([&] {
      const std::span<const double> in = view(v, me.size);
      const std::span<double> out = view(product, me.size);
      me.system.jacobian()->jacobian_times(me.equation->t, me.equation->point, in, out);
      const double gamma = me.equation->gamma;
      for_each_index(me.size, [&](std::size_t i) { out[i] = in[i] - gamma * out[i]; });
    });
  }
  static int precondition(void* self, N_Vector r, N_Vector z, realtype, int) {
    Krylov& me = *static_cast<Krylov*>(self);
    return me.guarded(
        [&] { me.system.jacobian()->precondition(me.equation->gamma, view(r, me.size), view(z, me.size)); });
  }

  System& system;
  std::size_t size;
  sundials::Context context;  // outlives whatever is made from it
  Vector right, correction;
  LinearSolverHandle solver;
  const Equation* equation = nullptr;
  std::exception_ptr failure;
};

NewtonIteration::NewtonIteration(System& system)
    : team_(system.team()),
      krylov_(std::make_unique<Krylov>(system)),
      residual_(system.size()),
      base_(system.size()),
      image_(system.size()) {}

NewtonIteration::~NewtonIteration() = default;

void NewtonIteration::run(const Equation& equation, std::span<double> y, std::span<const double> image,
                          std::span<double> rate, ConvergenceWatch& watch) {
  for_each_index(y.size(), [&](std::size_t i) { residual_[i] = image[i] - y[i]; });
  std::span<const double> dy;
  while (true) {
    const double left = krylov_->solve(equation, residual_, forcing * euclidean_norm(team_, residual_));
    dy = krylov_->found();
    std::ranges::copy(y, base_.begin());
    for_each_index(y.size(), [&](std::size_t i) { y[i] += dy[i]; });
    if (watch.update(std::max(max_difference(team_, y, base_), left)) != ConvergenceWatch::State::running) break;
    line_search(equation, y, dy);
  }
  // To first order, and such that nothing cancels in short steps.
  for_each_index(y.size(),
                 [&](std::size_t i) { rate[i] = equation.rate[i] + (dy[i] - residual_[i]) / equation.gamma; });
}

void NewtonIteration::line_search(const Equation& equation, std::span<double> y, std::span<const double> dy) {
  const double before = euclidean_norm(team_, residual_);
  double part = 1;
  for (int halvings = 0;; ++halvings) {
    try {
      equation.evaluate(y, image_);
      for_each_index(y.size(), [&](std::size_t i) { residual_[i] = image_[i] - y[i]; });
      if (euclidean_norm(team_, residual_) <= (1 - armijo * part) * before) return;
      if (halvings == max_correction_halvings)
        throw RecoverableError("the residual of the Newton iteration does not decrease along its direction");
    } catch (const RecoverableError&) {
      if (halvings == max_correction_halvings) throw;
    }
    part *= 0.5;
    for_each_index(y.size(), [&](std::size_t i) { y[i] = base_[i] + part * dy[i]; });
  }
}

}  // namespace creepcontact::ode
