#pragma once
/// The cycles of the loads: where they end, and which of them are alike.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/creep/assembly.hpp"

namespace creepcontact::model {

/// A value of the configuration that changes in time.
struct ChangingValue {
  std::string key;
  std::vector<std::function<double(double t)>> courses;  ///< at some places where it acts
};

/// The run is divided into cycles of the length time.cycle, numbered from 0; what is left at the end belongs to none.
/// Immutable.
class LoadCycles {
 public:
  /// @param config  with time.cycle @param values  all that change @param breakpoints  of the model; ends of the cycles
  /// are among them
  /// Cost: some hundred evaluations of each course per cycle
  LoadCycles(const config::Config& config, std::vector<ChangingValue> values, std::vector<double> breakpoints);

  double period() const { return period_; }
  /// Number of whole cycles up to the end of the run.
  std::int64_t count() const { return static_cast<std::int64_t>(ends_.size()); }
  /// Where a cycle begins and ends: one of the breakpoints, to the last bit.
  double begin(std::int64_t cycle) const { return cycle == 0 ? 0 : ends_[static_cast<std::size_t>(cycle) - 1]; }
  double end(std::int64_t cycle) const { return ends_[static_cast<std::size_t>(cycle)]; }
  /// The cycle that ends at this time, if one does.
  std::optional<std::int64_t> ending_at(double t) const;
  /// Number of cycles that end at this time or before.
  std::int64_t ended_by(double t) const { return std::ranges::upper_bound(ends_, t) - ends_.begin(); }

  /// The key whose values differ between this cycle and the one before it; empty: they are alike. Compared are samples
  /// at regular times and within each piece between breakpoints, to 1e-7 of the largest, and the breakpoints.
  const std::string& difference(std::int64_t cycle) const { return differences_[static_cast<std::size_t>(cycle)]; }
  bool repeats(std::int64_t cycle) const { return difference(cycle).empty(); }
  /// True if this cycle and all later ones do.
  bool repeats_from(std::int64_t cycle) const;
  /// True if a load jumps at this breakpoint.
  bool jumps_at(double t) const;
  /// The breakpoints without those in cycles that repeat the one before.
  std::vector<double> distinct_breakpoints() const;

 private:
  /// What a cycle is compared by.
  struct Samples {
    std::vector<double> corners;              ///< since its begin
    std::vector<std::vector<double>> values;  ///< of every part
  };
  Samples samples(std::int64_t cycle) const;
  std::string difference(const Samples& one, const Samples& other) const;
  static std::vector<double> values(const ChangingValue& part, double t);
  /// Breakpoints of a cycle, its ends included.
  std::vector<double> corners(std::int64_t cycle) const;

  double period_;
  std::vector<double> ends_, breakpoints_;
  std::vector<ChangingValue> parts_;
  std::vector<double> sudden_;  // times at which something begins or ends to act
  std::vector<std::string> differences_;
};

/// @throws ConfigError if the model has no use for cycles, or cannot jump over them as it is to do
void require_cycles(const config::Config& config, const creep::Assembly& assembly, const LoadCycles& cycles);

}  // namespace creepcontact::model
