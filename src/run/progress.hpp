#pragma once
/// Tells the user how far a run is: a bar on a terminal, plain lines elsewhere.

#include <chrono>
#include <cstdint>
#include <vector>

namespace creepcontact::run {

class Progress {
 public:
  /// @param output_times  ascending, the last is the end of the run
  Progress(const std::vector<double>& output_times, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// After every step; draws at most some times a second.
  void step(double time, std::int64_t steps, std::int64_t elastic_solves);
  /// Ends the bar's line, so that other text can follow.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  double share_done(double time) const;

  std::vector<double> output_times_;
  bool quiet_, terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace creepcontact::run
