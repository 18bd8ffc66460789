#pragma once
/// What ends the life of a part in a run: damage, spent life, and preload that relaxes away.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/io/summary.hpp"

namespace creepcontact::results {

class DamageMonitor {
 public:
  /// Damage that counts as rupture: the little that is missing takes no time worth mentioning.
  static constexpr double rupture_damage = 0.99;

  /// @param system  must outlive the object
  explicit DamageMonitor(const creep::CreepSystem& system);

  /// The body with the largest damage in this state; value 0 if no law has damage.
  creep::CreepSystem::Extreme largest_damage(std::span<const double> y) const;
  void rupture(double time, const creep::CreepSystem::Extreme& where) { rupture_ = {time, where}; }

  /// An output time.
  void output(const creep::Evaluation& at);
  /// Warns once, where creep strain is no longer small, or life is used up.
  /// @param at  of this state or one beside it
  void warn(double time, const creep::Evaluation& at, std::span<const double> y);

  /// At the end of a run: contacts that are not tied and have carried nothing.
  void warn_of_open_contacts() const;

  void fill(io::Summary& summary) const;
  void save(creep::Memory& memory) const { memory["largest_contact_force"] = largest_force_; }
  /// Nothing happens if the memory has no record.
  void restore(const creep::Memory& memory);

 private:
  const creep::CreepSystem& system_;
  std::vector<double> largest_force_, final_force_;                   // normal force of every contact pair
  std::map<std::size_t, creep::CreepSystem::Extreme> damage_, life_;  // by body
  std::optional<std::pair<double, creep::CreepSystem::Extreme>> rupture_;
  bool warned_of_strain_ = false, warned_of_life_ = false;
};

}  // namespace creepcontact::results
