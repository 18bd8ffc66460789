#include "creepcontact/ode/anderson_iteration.hpp"

#include <kinsol/kinsol.h>

#include <algorithm>
#include <exception>
#include <new>
#include <sundials/sundials_context.hpp>
#include <utility>
#include <vector>

#include "../state_norms.hpp"
#include "checked_call.hpp"
#include "sundials_vector.hpp"

namespace creepcontact::ode {

namespace {

/// Every end of the iterations is an error to KINSOL, see evaluate().
void ignore_message(int, const char*, const char*, char*, void*) {}

struct MemoryDeleter {
  void operator()(void* memory) const { KINFree(&memory); }
};

}  // namespace

struct AndersonIteration::Kinsol {
  Kinsol(std::size_t size, int depth, double trust_factor, const Team& of)
      : team(of),
        iterate(make_vector(team, size, context)),
        ones(N_VClone(iterate.get())),
        memory(KINCreate(context)),
        image(size),
        trust(trust_factor) {
    if (!memory || !ones) throw std::bad_alloc();
    N_VConst(1.0, ones.get());
    void* const kinsol = memory.get();
    require_success(KINSetErrHandlerFn(kinsol, ignore_message, nullptr), "KINSetErrHandlerFn");
    require_success(KINSetUserData(kinsol, this), "KINSetUserData");
    require_success(KINSetNumMaxIters(kinsol, std::numeric_limits<int>::max()),
                    "KINSetNumMaxIters");  // the step ends it
    require_success(KINSetMAA(kinsol, static_cast<long>(std::min<double>(depth, team.sum(static_cast<double>(size))))),
                    "KINSetMAA");
    // Residuals of proportional states are almost parallel; with one orthogonalisation the acceleration begins again so
    // often that it reaches half as far.
    require_success(KINSetOrthAA(kinsol, KIN_ORTH_CGS2), "KINSetOrthAA");
    // KINSOL judges the accelerated step, which may be short far from the solution: the caller judges instead.
    require_success(KINSetFuncNormTol(kinsol, std::numeric_limits<double>::min()), "KINSetFuncNormTol");
    require_success(KINInit(kinsol, evaluate, iterate.get()), "KINInit");
  }

  /// No exception may cross KINSOL, and the one way for us to end its iterations is an unrecoverable failure.
  static int evaluate(N_Vector y, N_Vector image, void* self) noexcept {
    Kinsol& me = *static_cast<Kinsol*>(self);
    try {
      return me.next(view(y, me.image.size()), view(image, me.image.size())) ? 0 : -1;
    } catch (...) {
      me.failure = std::current_exception();
      return -1;
    }
  }

  /// False to end: the step has decided, or the acceleration has to begin again from the last image.
  bool next(std::span<const double> y, std::span<double> next_image) {
    if (!std::exchange(plain, false) && !(max_difference(team, y, image) <= trust * change)) return false;
    ended = (*step)(y, image);
    std::ranges::copy(image, next_image.begin());
    change = max_difference(team, image, y);
    return !ended;
  }

  const Team& team;
  sundials::Context context;  // outlives whatever is made from it
  Vector iterate;             // KINSOL's y, padded to one entry if there is none
  Vector ones;
  std::unique_ptr<void, MemoryDeleter> memory;
  std::vector<double> image;  // G of the step's last argument
  double trust;
  const Step* step = nullptr;
  double change = 0;   // of the last step
  bool ended = false;  // by the step
  bool plain = true;   // the next argument is none of the acceleration's
  std::exception_ptr failure;
};

AndersonIteration::AndersonIteration(std::size_t size, int depth, double trust, const Team& team)
    : kinsol_(std::make_unique<Kinsol>(size, depth, trust, team)) {}

AndersonIteration::~AndersonIteration() = default;

void AndersonIteration::run(std::span<double> y, const Step& step) {
  Kinsol& kinsol = *kinsol_;
  kinsol.step = &step;
  kinsol.ended = false;
  std::ranges::copy(y, kinsol.image.begin());
  while (!kinsol.ended) {
    std::ranges::copy(kinsol.image, view(kinsol.iterate.get(), kinsol.image.size()).begin());
    kinsol.plain = true;
    // Success means that y no longer changes or is not a number (whose norm KINSOL takes for 0): both begin again.
    const int flag = KINSol(kinsol.memory.get(), kinsol.iterate.get(), KIN_FP, kinsol.ones.get(), kinsol.ones.get());
    if (kinsol.failure) std::rethrow_exception(std::exchange(kinsol.failure, nullptr));
    if (flag != KIN_SYSFUNC_FAIL) require_success(flag, "KINSol");
  }
  std::ranges::copy(kinsol.image, y.begin());
}

}  // namespace creepcontact::ode
