#include "load_path.hpp"

#include <algorithm>

#include "creepcontact/base/error.hpp"

namespace creepcontact::run {
namespace {
constexpr double min_relative_step = 1e-7;  // of the time
const std::string path_name = "load_path";  // in memories
}  // namespace

void LoadPath::initialize(double t, std::span<const double> /*y*/, double /*step*/) {
  time_ = t;
  target_ = none;
}

ode::StepReport LoadPath::step(double t_limit) {
  const double begin = time_;
  if (system_.has_friction()) {
    follow_slip(t_limit);
  } else {
    if (std::ranges::binary_search(outputs_, t_limit)) {
      system_.evaluate_step(t_limit, {});
      system_.accept(t_limit, {});
    }
    time_ = t_limit;
  }
  return {.time = time_, .step = time_ - begin};
}

void LoadPath::follow_slip(double t_limit) {
  if (t_limit != target_) length_ = t_limit - time_;
  target_ = t_limit;
  while (true) {
    length_ = std::min(length_, system_.longest_step_of_friction(time_, target_));
    const double to = length_ < target_ - time_ ? time_ + length_ : target_;
    try {
      system_.accept(to, {});
    } catch (const RecoverableError&) {  // loads that friction cannot hold in one step, or not at all
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
  return {.time = time_, .next_step = 0, .state = {}, .memory = {{path_name, {target_, length_}}}};
}

void LoadPath::restore(const ode::RestartPoint& point) {
  initialize(point.time, {});
  const std::vector<double>& path = point.memory.at(path_name);
  target_ = path.at(0);
  length_ = path.at(1);
}

}  // namespace creepcontact::run
