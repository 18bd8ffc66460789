#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "creepcontact/base/log.hpp"

namespace creepcontact::simulation {
namespace {

constexpr double seconds_between_draws = 0.1;
constexpr double seconds_between_lines = 10;
constexpr int bar_width = 24;

std::string clock_text(double seconds) {
  const auto whole = static_cast<long>(seconds);
  return whole >= 3600 ? fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60)
                       : fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

Progress::Progress(double end, bool quiet) : end_(end), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  clear();
}

void Progress::step(double time, std::int64_t steps, std::int64_t elastic_solves) {
  if (quiet_) return;
  const Clock::time_point now = Clock::now();
  const double since = std::chrono::duration<double>(now - last_).count();
  if (since < (terminal_ ? seconds_between_draws : seconds_between_lines)) return;
  last_ = now;
  const double share = end_ > 0 ? std::min(time / end_, 1.0) : 1.0;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  // Steps grow as creep slows down: time left from the share of simulated time is an upper bound.
  const double left = share > 0 ? elapsed * (1 - share) / share : 0;
  if (!terminal_) {
    log::info("t = {:.6g} of {:.6g}, {} steps, {} elastic solves, at most {} left", time, end_, steps, elastic_solves,
              clock_text(left));
    return;
  }
  const int full = static_cast<int>(share * bar_width);
  const std::string bar =
      std::string(static_cast<std::size_t>(full), '#') + std::string(static_cast<std::size_t>(bar_width - full), '.');
  fmt::print(stderr, "\r[{}] t = {:.5g} of {:.5g}  {} steps  {} solves  {} left\033[K", bar, time, end_, steps,
             elastic_solves, clock_text(left));
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::clear() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
  drawn_ = false;
}

}  // namespace creepcontact::simulation
