#pragma once
/// Whether a course repeats with a period, and which period it has.

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "discontinuities.hpp"

namespace creepcontact::model {

/// Cycles that are alike from the second one on, but for some.
class Repetition {
 public:
  /// Compares every cycle with one of them, at phases that change from cycle to cycle.
  /// @param comparisons  in all, where they leave more than `fewest_phases` for a cycle; at most 2000 are made of one
  /// @returns nullopt if more than 64 cycles and more than a twentieth of all differ
  static std::optional<Repetition> find(const Course& course, double end, double period, double comparisons,
                                        int fewest_phases);

  double period() const { return period_; }
  /// Number of whole cycles; what is left is one more.
  std::int64_t count() const { return count_; }
  /// The cycle that the others are like.
  std::int64_t pattern() const { return pattern_; }
  bool differs(std::int64_t cycle) const { return different_.contains(cycle); }
  /// The cycles that differ, neighbours as one interval; the first one is none of them.
  std::vector<Interval> different(double end) const;

 private:
  double period_ = 0;
  std::int64_t count_ = 0, pattern_ = 1;
  std::set<std::int64_t> different_;
};

/// The period of a course that has kinks or jumps, from the middle of the run; nullopt: none found. To about 1e-13.
std::optional<double> find_period(const Course& course, double end);

}  // namespace creepcontact::model
