#pragma once
/// What the cycles closed so far say about the next one.

#include <cstdint>
#include <optional>
#include <vector>

#include "creepcontact/base/memory.hpp"
#include "cycle_watch.hpp"

namespace creepcontact::run {

/// Compares a cycle with the last one closed before it, and keeps which bodies have used up their life. Cycles are
/// numbered from 0.
class ClosedCycles {
 public:
  explicit ClosedCycles(std::size_t n_bodies);

  /// Sets the lives that have been used up: they stay so, wherever the last rates lead back to.
  /// @param jumped  cycles before this one that were not computed
  void keep_used_lives(CycleRecord& record, std::int64_t cycle, std::int64_t jumped);
  /// See Summary::Cycles::last_change; nullopt if no cycle before this one has been closed.
  std::optional<double> change(const CycleRecord& record, std::int64_t cycle) const;
  void add(const CycleRecord& record, std::int64_t cycle);
  /// The next cycle is not compared.
  void forget_last() { last_ = -1; }

  void save(Memory& memory) const;
  /// @param n_probes  of this run; a cycle with another number is not compared
  void restore(const Memory& memory, std::size_t n_probes);

 private:
  std::int64_t last_ = -1;            // number of the last cycle closed
  std::vector<double> probe_ranges_;  // in it
  std::vector<double> used_up_;       // after how many cycles the life of a body was; infinity: it is not
  static constexpr auto saved_members =
      std::tuple{Member{"last", &ClosedCycles::last_}, Member{"probe_ranges", &ClosedCycles::probe_ranges_},
                 Member{"used_up", &ClosedCycles::used_up_}};
};

}  // namespace creepcontact::run
