#pragma once
/// Creep laws are fitted to tests of a limited range of stress and temperature. Warns once per material and quantity
/// when a body leaves it.

#include <map>
#include <string>
#include <vector>

#include "creepcontact/base/team.hpp"
#include "creepcontact/config/config.hpp"
#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::model {

/// One per run. The time is known before the run: see time_warnings().
class DataRangeMonitor {
 public:
  explicit DataRangeMonitor(const config::Config& config);

  /// The largest von Mises stress of a body counts, which creeps most: above the tests, or below all of them.
  /// Collective. @param team  the processes that share the bodies
  /// Cost: a pass through the stress, until all has been warned of; none without [materials.<name>.data_range].
  void observe(const std::vector<mechanics::Body>& bodies, const creep::Equilibrium& at, const Team& team);

  /// Warnings of materials whose tests are shorter than the run.
  static std::vector<std::string> time_warnings(const config::Config& config);

 private:
  /// @returns true if it has warned
  static bool observe_stress(const mechanics::Body& body, const std::vector<double>& range, double t,
                         const std::vector<double>& stress, const Team& team);
  static bool observe_temperature(const mechanics::Body& body, const std::vector<double>& range, double t,
                              const std::vector<double>& temperature, const Team& team);

  std::map<std::string, config::DataRange> ranges_;  // by material; those warned of are emptied
};

}  // namespace creepcontact::model
