#pragma once
/// Tells the user how far a run is: a bar on a terminal, plain lines elsewhere.

#include <chrono>
#include <cstdint>
#include <vector>

#include "creepcontact/run/run.hpp"
#include "thread_settings.hpp"

namespace creepcontact::cli {

class RunProgress final : public run::RunObserver {
 public:
  /// @param output_times  ascending, the last is the end of the run @param threads  adapted as the run goes on; must
  /// outlive the object
  RunProgress(const std::vector<double>& output_times, bool quiet, ThreadChoice& threads);
  ~RunProgress() override;
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;

  /// Draws at most some times per second.
  void step(double time, const RunCounters& work) override;
  /// Ends the bar's line.
  void before_message() override;

 private:
  using Clock = std::chrono::steady_clock;
  double share_done(double time) const;

  std::vector<double> output_times_;
  ThreadChoice& threads_;
  bool quiet_, terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace creepcontact::cli
