#include "sundials_callbacks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sundials_vector.hpp"

namespace creepcontact::ode {

namespace {
/// Part of the residual that an iteration may leave without a new tangent.
constexpr double slow_convergence = 0.5;

SundialsCallbacks& object(void* self) {
  return *static_cast<SundialsCallbacks*>(self);
}
}  // namespace

template <typename Call>
int SundialsCallbacks::guarded(Call call) noexcept {
  try {
    call();
    return 0;
  } catch (const RecoverableError& error) {
    recoverable_ = error.what();
    return 1;
  } catch (...) {
    fatal_ = std::current_exception();
    return -1;
  }
}

int SundialsCallbacks::rate(realtype t, N_Vector y, N_Vector rate, void* self) {
  SundialsCallbacks& me = object(self);
  me.last_ = {t, y};
  return me.guarded([&] { me.system_.rate(t, view(y, me.size_), view(rate, me.size_)); });
}

int SundialsCallbacks::weights(N_Vector, N_Vector weights, void* self) {
  N_VScale(1.0, object(self).weights_, weights);
  return 0;
}

int SundialsCallbacks::jacobian_times(N_Vector v, N_Vector product, realtype t, N_Vector y, N_Vector, void* self,
                                      N_Vector) {
  SundialsCallbacks& me = object(self);
  return me.guarded(
      [&] { me.system_.jacobian()->jacobian_times(t, view(y, me.size_), view(v, me.size_), view(product, me.size_)); });
}

int SundialsCallbacks::prepare_preconditioner(realtype t, N_Vector y, N_Vector, booleantype reuse, booleantype* renewed,
                                              realtype, void* self) {
  *renewed = SUNFALSE;
  if (reuse) return 0;  // only gamma has changed, and precondition() is told of it
  SundialsCallbacks& me = object(self);
  *renewed = SUNTRUE;
  return me.guarded([&] { me.system_.jacobian()->prepare_preconditioner(t, view(y, me.size_)); });
}

int SundialsCallbacks::precondition(realtype, N_Vector, N_Vector, N_Vector r, N_Vector z, realtype gamma, realtype, int,
                                    void* self) {
  SundialsCallbacks& me = object(self);
  return me.guarded([&] { me.system_.jacobian()->precondition(gamma, view(r, me.size_), view(z, me.size_)); });
}

int SundialsCallbacks::prepare_tangent(realtype t, N_Vector y, N_Vector, SUNMatrix, booleantype, booleantype* renewed,
                                       realtype gamma, void* self, N_Vector, N_Vector, N_Vector) {
  SundialsCallbacks& me = object(self);
  *renewed = SUNTRUE;  // also where only gamma has changed: the factorisation is the cost, not the Jacobian
  me.tangent_gamma_ = gamma;
  me.residual_ = 0;  // an iteration begins
  return me.guarded([&] { me.system_.newton_solver()->prepare_tangent(t, view(y, me.size_), gamma); });
}

int SundialsCallbacks::prepare_tangent_with_mass(realtype t, N_Vector y, N_Vector rate, SUNMatrix matrix, SUNMatrix,
                                                 booleantype reuse, booleantype* renewed, realtype gamma, void* self,
                                                 N_Vector work1, N_Vector work2, N_Vector work3) {
  return prepare_tangent(t, y, rate, matrix, reuse, renewed, gamma, self, work1, work2, work3);
}

int SundialsCallbacks::solve_tangent(N_Vector r, N_Vector z) noexcept {
  return guarded([&] {
    const double before = last_.time == solved_time_ ? residual_ : 0;
    residual_ = N_VWrmsNorm(r, weights_);
    solved_time_ = last_.time;
    if (before > 0 && residual_ > slow_convergence * before)
      system_.newton_solver()->prepare_tangent(last_.time, view(last_.state, size_), tangent_gamma_);
    system_.newton_solver()->solve_tangent(view(r, size_), view(z, size_));
  });
}

void SundialsCallbacks::message(int code, const char*, const char*, char* text, void* self) {
  if (code < 0) object(self).guarded([&] { object(self).message_ = text; });
}

void SundialsCallbacks::clear() {
  fatal_ = nullptr;
  recoverable_.clear();
  message_.clear();
}

void SundialsCallbacks::rethrow() {
  if (fatal_) std::rethrow_exception(std::exchange(fatal_, nullptr));
}

std::string SundialsCallbacks::details() const {
  std::string text = recoverable_.empty() ? "" : fmt::format(" Last failure: {}.", recoverable_);
  if (!message_.empty()) text += fmt::format(" SUNDIALS: {}", message_);
  return text;
}

}  // namespace creepcontact::ode
