#pragma once
/// Wall time by part of the program: what summary.json reports as wall_seconds.

#include <array>
#include <chrono>

namespace creepcontact {

enum class Part { factorize, solve, material, contact, output };
inline constexpr int n_parts = 5;

class Stopwatch {
 public:
  /// Adds the time of its own life to a part.
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
