#pragma once
/// System as the C functions that CVODE and ARKODE call. No exception crosses them: a RecoverableError becomes +1 (try
/// a smaller step); anything else is kept and becomes -1 (stop), to be rethrown when the integrator has returned.

#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nvector.h>

#include <exception>
#include <string>
#include <vector>

#include "creepcontact/ode/system.hpp"

namespace creepcontact::ode {

/// User data of an integrator; its address must not change.
class SundialsCallbacks {
 public:
  explicit SundialsCallbacks(System& system) : system_(system), size_(system.size()) {}
  SundialsCallbacks(const SundialsCallbacks&) = delete;
  SundialsCallbacks& operator=(const SundialsCallbacks&) = delete;

  // The prototypes are those of CVRhsFn, CVEwtFn, CVLsJacTimesVecFn, CVLsPrecSetupFn, CVLsPrecSolveFn, CVLsLinSysFn,
  // CVErrHandlerFn and of their ARKODE twins; `self` is the SundialsCallbacks. ARKLsLinSysFn has a mass matrix, too.
  static int rate(realtype t, N_Vector y, N_Vector rate, void* self);
  static int weights(N_Vector y, N_Vector weights, void* self);
  static int jacobian_times(N_Vector v, N_Vector product, realtype t, N_Vector y, N_Vector rate, void* self,
                            N_Vector work);
  static int prepare_preconditioner(realtype t, N_Vector y, N_Vector rate, booleantype reuse, booleantype* renewed,
                                    realtype gamma, void* self);
  static int precondition(realtype t, N_Vector y, N_Vector rate, N_Vector r, N_Vector z, realtype gamma, realtype delta,
                          int side, void* self);
  static int prepare_tangent(realtype t, N_Vector y, N_Vector rate, SUNMatrix matrix, booleantype reuse,
                             booleantype* renewed, realtype gamma, void* self, N_Vector work1, N_Vector work2,
                             N_Vector work3);
  static int prepare_tangent_with_mass(realtype t, N_Vector y, N_Vector rate, SUNMatrix matrix, SUNMatrix mass,
                                       booleantype reuse, booleantype* renewed, realtype gamma, void* self,
                                       N_Vector work1, N_Vector work2, N_Vector work3);
  static void message(int code, const char* module, const char* function, char* text, void* self);

  /// z = NewtonSolver::solve_tangent(r) for a SUNLinearSolver. An iteration that hardly reduces the residual goes on
  /// with the tangent at its present point: that of the first one misleads where a law without a smooth rate yields in
  /// one of both points alone. @returns 0, +1 or -1
  int solve_tangent(N_Vector r, N_Vector z) noexcept;

  /// What weights() hands out: 1 / absolute tolerance.
  void set_weights(N_Vector weights) { weights_ = weights; }
  void clear();
  /// Throws what a callback kept, if anything.
  void rethrow();
  /// What SUNDIALS and the last recoverable failure of System had to say, for an error message.
  std::string details() const;

 private:
  template <typename Call>
  int guarded(Call call) noexcept;

  System& system_;
  std::size_t size_;
  N_Vector weights_ = nullptr;
  struct Point {
    double time = 0;
    N_Vector state = nullptr;
  };
  Point last_;                             ///< of rate(), which outlives the iteration
  double tangent_gamma_ = 0;               ///< of the last factorisation
  double residual_ = 0, solved_time_ = 0;  ///< of the last solve_tangent(); 0: none since the last factorisation
  std::exception_ptr fatal_;
  std::string recoverable_;
  std::string message_;
};

}  // namespace creepcontact::ode
