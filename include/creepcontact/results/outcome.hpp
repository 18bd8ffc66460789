#pragma once
/// The main results of a run in a few numbers: contact forces and von Mises stresses at the start, at their largest and
/// at the end, and the contacts that opened.

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/io/summary.hpp"

namespace creepcontact::results {

/// Sees the output times only: what happens between two of them is not recorded.
class Outcome {
 public:
  /// @param assembly  must outlive the object
  explicit Outcome(const creep::Assembly& assembly);

  /// An output time; they come in increasing order. Warns once per contact that has slid by more than an element.
  void output(double time, const creep::Equilibrium& at);

  /// At the end of a run: warns of unilateral contacts that never carried a force.
  void warn_of_open_contacts() const;

  /// Normal forces of unilateral and preloaded contacts, largest von Mises stress of each body (at integration points).
  void fill(io::Summary& summary) const;
  void save(creep::Memory& memory) const;
  /// Does nothing if the memory has no record.
  void restore(const creep::Memory& memory);

 private:
  void see_friction(double time, const creep::Equilibrium& at, std::size_t pair);

  const creep::Assembly& assembly_;
  bool started_ = false;
  std::vector<io::Summary::Course> forces_;    // of every contact pair
  std::vector<double> opened_;                 // time, by pair; NaN: has not opened
  std::vector<io::Summary::Course> stresses_;  // of every body
  std::vector<double> dissipated_, slip_;      // of every contact pair at the last output; NaN: no friction
  std::vector<double> interference_;           // likewise; NaN: no preload
  std::vector<char> slid_far_;                 // by pair: warned of
};

}  // namespace creepcontact::results
