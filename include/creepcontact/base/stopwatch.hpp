#pragma once
/// Wall time per part of a run, reported as wall_seconds in summary.json.

#include <array>
#include <chrono>
#include <string_view>
#include <utility>

namespace creepcontact {

enum class Part { prepare, factorize, solve, material, contact, integrate, observe, output };

struct PartInfo {
  std::string_view name;   ///< in summary.json
  std::string_view words;  ///< in texts
};
/// Indexed by Part.
inline constexpr std::array<PartInfo, 8> run_parts{{{"prepare", "mesh and model"},
                                                    {"factorize", "factors"},
                                                    {"solve", "solves"},
                                                    {"material", "material points"},
                                                    {"contact", "contact"},
                                                    {"integrate", "time integration"},
                                                    {"observe", "extremes, events and life"},
                                                    {"output", "output"}}};

/// Seconds per part, indexed by Part.
using PartSeconds = std::array<double, run_parts.size()>;

/// Accumulates wall time from its construction on; every instant belongs to one part, the first ones to `prepare`. Laps
/// must be made and destroyed by one thread.
class Stopwatch {
 public:
  /// The time between its construction and destruction belongs to a part, but for that of laps within it. Must not
  /// outlive the stopwatch; of several laps, the last one made ends first.
  class Lap {
   public:
    Lap(Stopwatch& watch, Part part) : watch_(watch), outer_(watch.go_on_with(part)) {}
    ~Lap() { watch_.go_on_with(outer_); }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

   private:
    Stopwatch& watch_;
    Part outer_;
  };

  [[nodiscard]] Lap lap(Part part) { return Lap(*this, part); }
  /// Up to now.
  PartSeconds seconds() const {
    PartSeconds all = seconds_;
    all[static_cast<std::size_t>(part_)] += seconds_until(Clock::now());
    return all;
  }

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_until(Clock::time_point now) const { return std::chrono::duration<double>(now - since_).count(); }
  /// @returns the part up to now
  Part go_on_with(Part part) {
    const Clock::time_point now = Clock::now();
    seconds_[static_cast<std::size_t>(part_)] += seconds_until(now);
    since_ = now;
    return std::exchange(part_, part);
  }

  Clock::time_point since_ = Clock::now();
  Part part_ = Part::prepare;
  PartSeconds seconds_{};
};

}  // namespace creepcontact
