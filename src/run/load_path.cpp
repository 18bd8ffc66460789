#include "load_path.hpp"

#include <algorithm>

#include "creepcontact/base/error.hpp"

namespace creepcontact::run {
namespace {
constexpr double min_relative_step = 1e-7;  // of the time
const std::string path_name = "load_path";  // in memories
}  // namespace

void LoadPath::initialize(double t, std::span<const double> y, double /*step*/) {
  state_.assign(y.begin(), y.end());
  time_ = t;
  target_ = none;
  accept_output();
}

ode::StepReport LoadPath::step(double t_limit) {
  const double begin = time_;
  if (system_.depends_on_path()) {
    follow_path(t_limit);
  } else {
    time_ = t_limit;
    const bool is_end = t_limit >= outputs_.back();  // the end of the run is an output time, and nothing follows it
    if (!is_end && !std::ranges::binary_search(breakpoints_, t_limit)) accept_output();
  }
  return {.time = time_, .step = time_ - begin};
}

void LoadPath::accept_output() {
  if (system_.depends_on_path() || time_ <= accepted_ || !std::ranges::binary_search(outputs_, time_)) return;
  system_.evaluate_step(time_, state_);
  system_.accept(time_, state_);
  accepted_ = time_;
}

void LoadPath::follow_path(double t_limit) {
  if (t_limit != target_) length_ = t_limit - time_;
  target_ = t_limit;
  while (true) {
    length_ = std::min(length_, system_.longest_step_of_friction(time_, target_));
    const double to = length_ < target_ - time_ ? time_ + length_ : target_;
    try {
      system_.evaluate_step(to, state_);
      system_.accept(to, state_);
    } catch (const RecoverableError&) {  // loads that cannot be carried in one step, or not at all
      length_ = (to - time_) / 2;
      if (!(length_ > min_relative_step * target_)) throw;
      continue;
    }
    time_ = to;
    length_ *= 2;
    return;
  }
}

ode::RestartPoint LoadPath::save() const {
  ode::RestartPoint point;
  point.time = time_;
  point.memory.save(path_name, *this, saved_members);
  return point;
}

void LoadPath::restore(const ode::RestartPoint& point) {
  time_ = point.time;
  point.memory.restore(path_name, *this, saved_members);
}

}  // namespace creepcontact::run
