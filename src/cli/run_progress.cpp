#include "run_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "creepcontact/base/log.hpp"
#include "creepcontact/base/log_notice.hpp"

namespace creepcontact::cli {
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

RunProgress::RunProgress(const std::vector<double>& output_times, bool quiet, ThreadChoice& threads)
    : output_times_(output_times), threads_(threads), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {
  log::before_messages([this] { clear(); });
}

RunProgress::~RunProgress() {
  log::before_messages({});
  clear();
}

/// The share counts output intervals: where creep slows down, users space the outputs out, and the steps grow alike.
double RunProgress::share_done(double time) const {
  const auto next = std::upper_bound(output_times_.begin(), output_times_.end(), time);
  if (next == output_times_.begin() || next == output_times_.end()) return next == output_times_.begin() ? 0 : 1;
  const double within = (time - *(next - 1)) / (*next - *(next - 1));
  return (static_cast<double>(next - output_times_.begin() - 1) + within) /
         static_cast<double>(output_times_.size() - 1);
}

run::Reaction RunProgress::step(run::StepView& view) {
  if (const std::optional<int> changed = threads_.update())
    log::info("other programs use the machine more or less than before: {} from here on",
              *changed == 1 ? "one thread" : fmt::format("{} threads", *changed));
  if (!quiet_) draw(view.time(), view.work());
  return run::Reaction::advance;
}

void RunProgress::end(run::End /*how*/) {
  clear();
}

void RunProgress::draw(double time, const RunCounters& work) {
  const Clock::time_point now = Clock::now();
  const double since = std::chrono::duration<double>(now - last_).count();
  if (since < (terminal_ ? seconds_between_draws : seconds_between_lines)) return;
  last_ = now;
  const double share = share_done(time);
  const double end = output_times_.back();
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  constexpr double enough = 0.01;  // of the run; before that the first tiny steps would promise years
  const std::string left = share < enough ? "" : clock_text(elapsed * (1 - share) / share) + " left";
  if (!terminal_) {
    log::info("t = {:.6g} of {:.6g}, {} steps, {} elastic solves{}{}", time, end, work.steps, work.elastic_solves,
              left.empty() ? "" : ", about ", left);
    return;
  }
  const int full = static_cast<int>(share * bar_width);
  const std::string bar = std::string(full, '#') + std::string(bar_width - full, '.');
  // fmt::print throws where the terminal is gone.
  const std::string line = fmt::format("\r[{}] t = {:.5g} of {:.5g}  {} steps  {} solves  {}\033[K", bar, time, end,
                                       work.steps, work.elastic_solves, left);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
}

void RunProgress::clear() {
  if (drawn_.exchange(false)) std::fputs("\r\033[K", stderr);
}

}  // namespace creepcontact::cli
