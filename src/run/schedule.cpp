#include "schedule.hpp"

#include <algorithm>
#include <limits>

namespace creepcontact::run {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

std::size_t first_after(const std::vector<double>& times, double t) {
  return static_cast<std::size_t>(std::ranges::upper_bound(times, t) - times.begin());
}

}  // namespace

void Schedule::begin(double t) {
  next_output_ = first_after(outputs_, t);
  go_to(t);
}

void Schedule::go_to(double t) {
  next_breakpoint_ = first_after(breakpoints_, t);
}

void Schedule::add_breakpoint(double t) {
  const auto after = std::ranges::lower_bound(breakpoints_, t);
  if (after == breakpoints_.end() || *after != t) breakpoints_.insert(after, t);
}

bool Schedule::is_breakpoint(double t) const {
  return std::ranges::binary_search(breakpoints_, t);
}

model::StepGuard::Segment Schedule::segment(double t) const {
  // At the end of the run there is no state after a jump that would still be integrated, but one to be reported.
  return {.begin = next_breakpoint_ > 0 ? breakpoints_[next_breakpoint_ - 1] : -never,
          .end = has_breakpoint() ? breakpoints_[next_breakpoint_] : (t < end_ ? end_ : never)};
}

double Schedule::next_output() const {
  return next_output_ < outputs_.size() ? outputs_[next_output_] : never;
}

}  // namespace creepcontact::run
