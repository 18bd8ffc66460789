#include "anderson_iteration.hpp"

#include <fmt/format.h>
#include <kinsol/kinsol.h>

#include <algorithm>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include "elementwise.hpp"

namespace creepcontact::ode {

namespace {

/// The solution of a relaxing system lies no further from y than G(y) - y is long. An iterate farther from the last
/// image than this many changes comes of residuals that depend on each other, where the least-squares problem has no
/// solution of its own: points of equal stress, say, which differ by nothing or by rounding.
constexpr double trust_factor = 10;

void check(int flag, const char* function) {
  if (flag < 0) throw std::runtime_error(fmt::format("{} failed with flag {}", function, flag));
}

/// Every end of the iterations is an error to KINSOL, see evaluate().
void ignore_message(int, const char*, const char*, char*, void*) {}

}  // namespace

void AndersonIteration::MemoryDeleter::operator()(void* memory) const {
  KINFree(&memory);
}

AndersonIteration::AndersonIteration(std::size_t size, int depth, int max_iterations, Map map)
    : map_(std::move(map)),
      iterate_(make_vector(std::max<std::size_t>(size, 1), context_)),
      ones_(make_vector(std::max<std::size_t>(size, 1), context_)),
      memory_(KINCreate(context_)),
      image_(size) {
  if (!memory_) throw std::bad_alloc();
  N_VConst(1.0, ones_.get());
  void* const kinsol = memory_.get();
  check(KINSetErrHandlerFn(kinsol, ignore_message, nullptr), "KINSetErrHandlerFn");
  check(KINSetUserData(kinsol, this), "KINSetUserData");
  check(KINSetNumMaxIters(kinsol, max_iterations), "KINSetNumMaxIters");
  check(KINSetMAA(kinsol, static_cast<long>(std::min<std::size_t>(static_cast<std::size_t>(depth), size))),
        "KINSetMAA");
  // Residuals of proportional states are almost parallel; with one orthogonalisation the acceleration begins anew so
  // often that it reaches half as far.
  check(KINSetOrthAA(kinsol, KIN_ORTH_CGS2), "KINSetOrthAA");
  // KINSOL judges the accelerated step, which may be short far from the solution: the watch judges instead.
  check(KINSetFuncNormTol(kinsol, std::numeric_limits<double>::min()), "KINSetFuncNormTol");
  check(KINInit(kinsol, evaluate, iterate_.get()), "KINInit");
}

void AndersonIteration::run(std::span<double> y, ConvergenceWatch& watch) {
  watch_ = &watch;
  std::ranges::copy(y, image_.begin());
  while (watch.state() == ConvergenceWatch::State::running) {
    std::ranges::copy(image_, view(iterate_.get(), image_.size()).begin());
    plain_ = true;
    // Success means that y stands still or is not a number (whose norm KINSOL takes for 0): both begin anew.
    const int flag = KINSol(memory_.get(), iterate_.get(), KIN_FP, ones_.get(), ones_.get());
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    if (flag != KIN_SYSFUNC_FAIL) check(flag, "KINSol");
  }
  std::ranges::copy(image_, y.begin());
}

/// No exception may cross KINSOL, and the one way for us to end its iterations is an unrecoverable failure.
int AndersonIteration::evaluate(N_Vector y, N_Vector image, void* self) noexcept {
  AndersonIteration& me = *static_cast<AndersonIteration*>(self);
  try {
    return me.next(view(y, me.image_.size()), view(image, me.image_.size())) ? 0 : -1;
  } catch (...) {
    me.failure_ = std::current_exception();
    return -1;
  }
}

/// False to end: the watch has decided, or the acceleration has to begin anew from the last image.
bool AndersonIteration::next(std::span<const double> y, std::span<double> image) {
  if (!std::exchange(plain_, false) && !(max_difference(y, image_) <= trust_factor * watch_->change())) return false;
  map_(y, image_);
  std::ranges::copy(image_, image.begin());
  return watch_->see(max_difference(image_, y)) == ConvergenceWatch::State::running;
}

}  // namespace creepcontact::ode
