#include "creepcontact/ode/implicit_integrator.hpp"

#include <fmt/format.h>
#include <ida/ida.h>
#include <ida/ida_ls.h>

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <sundials/sundials_context.hpp>
#include <utility>

#include "checked_call.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/ode/system.hpp"
#include "linear_solver_handle.hpp"
#include "sundials_vector.hpp"
#include "tangent_solver.hpp"

namespace creepcontact::ode {

namespace {

constexpr long most_steps = 1'000'000;        // of one start
constexpr double most_growth = 4;             // of a step: where a system comes to rest
constexpr double of_a_correction = 0.01;      // the error in it, of the tolerance
constexpr double shift_before_prepare = 0.9;  // (a - b)/(a + b) of two coefficients c: by a factor of 19

struct IdaDeleter {
  void operator()(void* memory) const { IDAFree(&memory); }
};

}  // namespace

struct ImplicitIntegrator::Ida {
  Ida(ImplicitSystem& of, double allowed)
      : system(of),
        size(of.size()),
        tolerance(allowed),
        y(make_vector(serial_team(), size, context)),
        rate(N_VClone(y.get())),
        linear(SUNLinSolNewEmpty(context)),
        matrix(SUNMatNewEmpty(context)),
        memory(IDACreate(context)) {
    if (!rate || !linear || !matrix || !memory) throw std::bad_alloc();
    linear->content = this;
    linear->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
    linear->ops->getid = [](SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; };
    linear->ops->setup = [](SUNLinearSolver, SUNMatrix) -> int { return SUNLS_SUCCESS; };  // done with the matrix
    linear->ops->solve = solve;
    linear->ops->free = [](SUNLinearSolver solver) -> int {
      SUNLinSolFreeEmpty(solver);
      return SUNLS_SUCCESS;
    };
    matrix->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
    matrix->ops->zero = [](SUNMatrix) -> int { return SUNMAT_SUCCESS; };
    matrix->ops->destroy = SUNMatFreeEmpty;
  }

  /// No exception may cross IDA: it is kept, and thrown when IDA has returned.
  template <typename Call>
  int guarded(Call call) noexcept {
    try {
      call();
      return 0;
    } catch (const RecoverableError& error) {
      said = error.what();
      return 1;
    } catch (...) {
      thrown = std::current_exception();
      return -1;
    }
  }

  std::span<double> entries(N_Vector v) const { return view(v, size); }

  static int residual(realtype t, N_Vector y, N_Vector rate, N_Vector into, void* self) noexcept {
    Ida& me = *static_cast<Ida*>(self);
    return me.guarded([&] { me.system.residual(t, me.entries(y), me.entries(rate), me.entries(into)); });
  }
  static int prepare(realtype t, realtype c, N_Vector y, N_Vector rate, N_Vector, SUNMatrix, void* self, N_Vector,
                     N_Vector, N_Vector) noexcept {
    Ida& me = *static_cast<Ida*>(self);
    return me.guarded([&] { me.system.prepare(t, me.entries(y), me.entries(rate), c); });
  }
  static int solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, realtype) noexcept {
    Ida& me = *static_cast<Ida*>(solver->content);
    const int failed = me.guarded([&] {
      const std::span<double> from = me.entries(b), into = me.entries(x);
      std::ranges::copy(from, into.begin());
      double c = 0;
      require_success(IDAGetCurrentCj(me.memory.get(), &c), "IDAGetCurrentCj");
      me.system.shift(c);
      me.system.solve(into, of_a_correction * me.tolerance);
    });
    return failed == 0 ? SUNLS_SUCCESS : failed > 0 ? SUNLS_PACKAGE_FAIL_REC : SUNLS_PACKAGE_FAIL_UNREC;
  }
  static void message(int /*code*/, const char*, const char*, char* text, void* self) {
    static_cast<Ida*>(self)->said = text;
  }

  ImplicitSystem& system;
  std::size_t size;
  double tolerance;
  sundials::Context context;
  Vector y, rate;
  LinearSolverHandle linear;
  std::unique_ptr<_generic_SUNMatrix, MatrixDeleter> matrix;
  std::unique_ptr<void, IdaDeleter> memory;
  bool is_started = false;
  double time = 0;
  std::exception_ptr thrown;
  std::string said;
};

ImplicitIntegrator::ImplicitIntegrator(ImplicitSystem& system, double tolerance)
    : ida_(std::make_unique<Ida>(system, tolerance)) {}
ImplicitIntegrator::~ImplicitIntegrator() = default;

void ImplicitIntegrator::start(double t, std::span<const double> y, std::span<const double> rate) {
  Ida& ida = *ida_;
  std::ranges::copy(y, ida.entries(ida.y.get()).begin());
  std::ranges::copy(rate, ida.entries(ida.rate.get()).begin());
  ida.time = t;
  void* const memory = ida.memory.get();
  if (std::exchange(ida.is_started, true))
    return require_success(IDAReInit(memory, t, ida.y.get(), ida.rate.get()), "IDAReInit");
  require_success(IDASetErrHandlerFn(memory, Ida::message, &ida), "IDASetErrHandlerFn");
  require_success(IDAInit(memory, Ida::residual, t, ida.y.get(), ida.rate.get()), "IDAInit");
  require_success(IDASetUserData(memory, &ida), "IDASetUserData");
  require_success(IDASStolerances(memory, 0, ida.tolerance), "IDASStolerances");
  require_success(IDASetLinearSolver(memory, ida.linear.get(), ida.matrix.get()), "IDASetLinearSolver");
  require_success(IDASetJacFn(memory, Ida::prepare), "IDASetJacFn");
  // The system shifts its matrix: IDA need not scale solutions with another c, nor prepare for each.
  require_success(IDASetLinearSolutionScaling(memory, SUNFALSE), "IDASetLinearSolutionScaling");
  require_success(IDASetEtaMax(memory, most_growth), "IDASetEtaMax");
  require_success(IDASetDeltaCjLSetup(memory, shift_before_prepare), "IDASetDeltaCjLSetup");
}

void ImplicitIntegrator::step(double end) {
  Ida& ida = *ida_;
  void* const memory = ida.memory.get();
  if (n_steps() >= most_steps)
    throw SolverError(fmt::format("more than {} steps up to t = {:.6g}", most_steps, ida.time));
  require_success(IDASetStopTime(memory, end), "IDASetStopTime");
  const int flag = IDASolve(memory, end, &ida.time, ida.y.get(), ida.rate.get(), IDA_ONE_STEP);
  if (ida.thrown) std::rethrow_exception(std::exchange(ida.thrown, nullptr));
  if (flag < 0) throw SolverError(fmt::format("the integration stopped at t = {:.6g}: {}", ida.time, ida.said));
}

double ImplicitIntegrator::next_step() const {
  double step = 0;
  if (n_steps() > 0) require_success(IDAGetCurrentStep(ida_->memory.get(), &step), "IDAGetCurrentStep");
  return step;
}

double ImplicitIntegrator::time() const {
  return ida_->time;
}
std::span<const double> ImplicitIntegrator::state() const {
  return ida_->entries(ida_->y.get());
}
std::span<const double> ImplicitIntegrator::rate() const {
  return ida_->entries(ida_->rate.get());
}
long ImplicitIntegrator::n_steps() const {
  long n = 0;
  require_success(IDAGetNumSteps(ida_->memory.get(), &n), "IDAGetNumSteps");
  return n;
}

}  // namespace creepcontact::ode
