#pragma once
/// Material tables in T cover a limited range; outside it their end values are used. Warns once per table when a
/// temperature leaves the range.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/team.hpp"
#include "creepcontact/config/config.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::model {

/// One per run. A default-constructed monitor never warns.
class TableRangeMonitor {
 public:
  TableRangeMonitor() = default;
  explicit TableRangeMonitor(const config::Config& config);

  /// Warns of each table that the temperature of a body leaves for the first time. Collective.
  /// @param team  the processes that share the bodies
  /// Cost: minimum and maximum of the temperature, if it changes in time and the materials have tables in T; else none.
  void see(double t, const std::vector<mechanics::Body>& bodies,
           const std::vector<mechanics::BodyConditions>& conditions, const Team& team);

 private:
  struct Table {
    std::string what;  ///< key of the table: "young_modulus"
    Interval range;
  };
  void see(const mechanics::Body& body, const mechanics::BodyConditions& at, const Team& team);

  std::map<std::string, std::vector<Table>> tables_;  // by material: tables not warned of yet
  bool changes_in_time_ = false;
  std::optional<double> time_;  // of the last call
};

}  // namespace creepcontact::model
