#pragma once
/// Monitoring of what ends the life of a part: damage and used-up life.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/io/tables/summary.hpp"

namespace creepcontact::results {

/// Collects extreme values for summary.json and issues warnings, each once. Calls are collective.
class DamageMonitor {
 public:
  /// @param system  must outlive the object
  explicit DamageMonitor(const creep::CreepSystem& system);

  bool has_damage() const { return system_.has(material::damage); }
  /// The largest damage in this state, with body and position; value 0 if no law has damage.
  /// @param at  evaluation of this state or of one close to it @param y  state of the system
  creep::CreepSystem::Extreme largest_damage(const creep::Evaluation& at, std::span<const double> y) const;
  /// True if this is rupture: nothing that would matter remains of the life of this body.
  /// @param damage  the largest in the state y @param time  of this state @param at  as above
  bool is_rupture(const creep::CreepSystem::Extreme& damage, double time, const creep::Evaluation& at,
                  std::span<const double> y) const;
  /// Records a rupture.
  void rupture(double time, const creep::CreepSystem::Extreme& where) { rupture_ = {time, where}; }

  /// Must be called at every output time.
  void output(const creep::Evaluation& at);
  /// Warns, once each, if creep strains are no longer small, or if life is used up. Collective.
  /// @param at  evaluation of this state or of one close to it
  void warn(double time, const creep::Evaluation& at, std::span<const double> y);

  void fill(io::Summary& summary) const;

 private:
  const creep::CreepSystem& system_;
  /// The variables that count, and where they are in the summary.
  struct Counter {
    const material::StateVariable* variable;
    std::map<std::string, io::Summary::Largest> io::Summary::*member;
    std::map<std::size_t, creep::CreepSystem::Extreme> largest;  // by body
  };
  std::vector<Counter> counters_;
  std::optional<std::pair<double, creep::CreepSystem::Extreme>> rupture_;
  bool warned_of_strain_ = false, warned_of_life_ = false, warned_of_creep_fatigue_ = false;
};

}  // namespace creepcontact::results
