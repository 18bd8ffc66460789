#pragma once
/// Wall time per part of the program, reported as wall_seconds in summary.json.

#include <array>
#include <chrono>

namespace creepcontact {

enum class Part { factorize, solve, material, contact, output };
inline constexpr int n_parts = 5;

/// Accumulates wall time; starts at construction. Laps must be made and destroyed by one thread.
class Stopwatch {
 public:
  /// Adds the time between its construction and destruction to a part. Must not outlive the stopwatch.
  class Lap {
   public:
    Lap(Stopwatch& watch, Part part) : watch_(watch), part_(part), start_(Clock::now()) {}
    ~Lap() { watch_.seconds_[static_cast<std::size_t>(part_)] += seconds_since(start_); }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

   private:
    Stopwatch& watch_;
    Part part_;
    std::chrono::steady_clock::time_point start_;
  };

  [[nodiscard]] Lap lap(Part part) { return Lap(*this, part); }
  double seconds(Part part) const { return seconds_[static_cast<std::size_t>(part)]; }
  /// Seconds since construction.
  double total() const { return seconds_since(start_); }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }
  Clock::time_point start_ = Clock::now();
  std::array<double, n_parts> seconds_{};
};

}  // namespace creepcontact
