#pragma once
/// How many threads are useful at the moment.

#include <chrono>
#include <functional>
#include <optional>

namespace creepcontact::platform {

/// The largest of `most`, most/2, most/4, ... threads of OpenMP that do not wait for each other, at least 1. On a busy
/// machine, a loop shared among all cores takes as long as its slowest part, which may be waiting for a core. Measured
/// by short test loops. Results of computations do not depend on the number.
/// Cost: about a hundredth of a second per number tried.
int useful_threads(int most);

/// Measures the machine now and then, as other programs come and go in a long run.
class ThreadWatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param most  threads that may be used @param interval  between two measurements
  /// @param measure  the number that is useful now
  explicit ThreadWatch(int most, std::chrono::seconds interval = std::chrono::seconds(10),
                       std::function<int(int most)> measure = useful_threads);
  /// The number at the last measurement.
  int threads() const { return threads_; }
  /// Measures if the interval is over. @returns the new number if it has changed
  std::optional<int> update(Clock::time_point now = Clock::now());

 private:
  int most_, threads_;
  std::chrono::seconds interval_;
  std::function<int(int)> measure_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace creepcontact::platform
