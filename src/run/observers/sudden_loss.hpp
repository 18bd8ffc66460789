#pragma once
/// Contacts that lose their pressure at the speed of heat, as an unstable joint does, and not at that of creep.

#include <deque>
#include <optional>
#include <vector>

#include "creepcontact/base/memory.hpp"

namespace creepcontact::run {

/// The normal force of one contact over the accepted steps.
class SuddenLoss {
 public:
  struct Loss {
    double time = 0;   ///< at which nothing is left
    double force = 0;  ///< that was left before
    double share = 0;  ///< of the largest force
    double since = 0;  ///< the last time with half of it
  };

  /// @param heating_time  in which heat comes through the bodies @param load_changes  times, ascending: what is lost
  /// just after one is not called sudden
  SuddenLoss(double heating_time, std::vector<double> load_changes);

  /// Times come in ascending order. @returns the loss, if the contact is lost now
  std::optional<Loss> observe(double time, double force);

  void save(const std::string& name, Memory& memory) const;
  void restore(const std::string& name, const Memory& memory);

 private:
  struct Entry {
    double time = 0, force = 0;
  };
  double force_at(double time) const;

  double window_;
  std::vector<double> load_changes_;
  std::deque<Entry> entries_;  // those of the last two windows, and one before
  double largest_ = 0;
};

}  // namespace creepcontact::run
