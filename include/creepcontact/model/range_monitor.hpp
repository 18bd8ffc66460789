#pragma once
/// Tables in T of materials and gaskets cover a limited range, outside of which their end values are used, creep laws
/// hold for the stresses and temperatures of their data, and a table of the yield stress ends at some plastic strain.
/// Warns once per range when what it is of leaves it.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/team.hpp"
#include "creepcontact/config/config.hpp"
#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/mechanics/body.hpp"
#include "creepcontact/mechanics/point_extreme.hpp"

namespace creepcontact::model {

/// One per run. The time is known before the run: see time_warnings().
class RangeMonitor {
 public:
  explicit RangeMonitor(const config::Config& config);

  /// Warns of each range that the temperature or stress of a body leaves for the first time. Collective.
  /// @param at  its bodies and conditions: of these bodies. @param team  the processes that share the bodies.
  /// Cost: minimum and maximum of the temperature, if it changes in time and the materials have ranges of T, and the
  /// largest stress, if they have ranges of stress.
  void observe(double t, const std::vector<mechanics::Body>& bodies, const creep::Equilibrium& at, const Team& team);
  /// Likewise for the gaskets and springs of contact pairs. @param at  their equilibrium
  void observe(const std::vector<contact::Pair>& pairs, const creep::Equilibrium& at);
  /// To be called at the end: warns of ranges of stress that the stress has never come up to.
  void finish() const;

  /// Warnings of laws whose data are shorter than the run.
  static std::vector<std::string> time_warnings(const config::Config& config);

 private:
  struct Range {
    std::string what;  ///< key of the table, or of the range: "young_modulus"
    Interval range;
    bool of_law = false;  ///< not of a table
  };
  struct StressRange {
    std::string what;
    Interval range;
    double largest = 0;  ///< stress up to now
    bool exceeded = false;
    std::string name = {};  ///< of the stress
  };
  void observe_flow(const mechanics::Body& body, const creep::PlasticState& state, double t, const Team& team);
  void observe_temperature(const mechanics::Body& body, const mechanics::BodyConditions& at, const Team& team);
  void observe_stress(const mechanics::Body& body, const std::vector<double>& stress, double t, const Team& team);
  /// Preconditions: the owner has such ranges
  void check_stress(const std::string& owner, const char* name, const mechanics::PointExtreme& largest, double t);
  void check_temperature(const std::string& owner, const mechanics::PointExtreme& hottest,
                         const mechanics::PointExtreme& coldest, double t, bool has_temperature);

  // By owner: "material 'disc'", "gasket 'graphite'"
  std::map<std::string, std::vector<Range>> tables_;  // ranges of T not warned of yet
  std::map<std::string, std::vector<StressRange>> stresses_;
  std::map<std::string, double> curves_;  // plastic strain at which its table ends, not warned of yet
  bool changes_in_time_ = false;
  double temperature_error_;    // of a computed temperature, of the range of a table
  std::optional<double> time_;  // of the last call
};

}  // namespace creepcontact::model
