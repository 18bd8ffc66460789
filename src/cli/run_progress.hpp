#pragma once
/// Tells the user how far a run is: a bar on a terminal, plain lines elsewhere.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <vector>

#include "creepcontact/run/run.hpp"
#include "thread_settings.hpp"

namespace creepcontact::cli {

class RunProgress final : public run::Observer {
 public:
  /// @param output_times  ascending, the last is the end of the run @param threads  adapted as the run goes on; must
  /// outlive the object
  RunProgress(const std::vector<double>& output_times, bool quiet, ThreadChoice& threads);
  ~RunProgress() override;
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;

  /// Draws at most some times per second.
  run::Reaction step(run::StepView& view) override;
  void end(run::End how) override;

 private:
  /// Ends the bar's line, so that something else may be written.
  void clear();
  void draw(double time, const RunCounters& work);
  using Clock = std::chrono::steady_clock;
  double share_done(double time) const;

  std::vector<double> output_times_;
  ThreadChoice& threads_;
  bool quiet_, terminal_;
  std::atomic<bool> drawn_ = false;  // messages may come from any thread
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace creepcontact::cli
