#pragma once
/// Tables in T end somewhere: tells once of each when a temperature leaves it and its end value is used.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::model {

class TableRangeMonitor {
 public:
  TableRangeMonitor() = default;
  explicit TableRangeMonitor(const config::Config& config);

  /// Warns of every table that a body's temperature at this time is the first to leave.
  /// Cost: the extremes of the temperature, if it changes in time and the bodies' materials have tables in T.
  void see(double t, const std::vector<mechanics::Body>& bodies,
           const std::vector<mechanics::BodyConditions>& conditions);

 private:
  struct Table {
    std::string what;  ///< "young_modulus"
    Interval range;
  };
  void see(const mechanics::Body& body, const mechanics::BodyConditions& at);

  std::map<std::string, std::vector<Table>> tables_;  // of every material, those not warned of
  bool changes_in_time_ = false;
  std::optional<double> time_;  // of the last call
};

}  // namespace creepcontact::model
