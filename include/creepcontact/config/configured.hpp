#pragma once
/// Functions and values of a configuration as data. They follow from its structs by the declarations of the keys. So
/// code that needs all of them (breakpoints, the fingerprint of a checkpoint) cannot forget a kind of key. A
/// configuration that is made in code has them too.

#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"

namespace creepcontact::config {

struct Config;

/// A function of the configuration: a number, an expression or a table.
struct ConfiguredFunction {
  std::string key;  ///< full: "loads[0].traction[2]"
  Function value;
  std::vector<std::string> variables;  ///< that the key allows

  bool may_depend_on(const std::string& variable) const;
  /// True if it may depend on x, y, z and t only.
  bool is_of_position_and_time() const;
  /// True for functions of [heat], conductances and what conducts: what they do is in the temperature that is computed.
  bool acts_by_temperature_alone() const;
};

/// The value of a key.
struct ConfiguredValue {
  std::string key;   ///< full: "contacts[0].gap"
  std::string text;  ///< as a file has it, the same for equal values: 1.0 and 1 are both "1"
};

/// All functions that act on the model, in the order of the keys, those of keys that have their defaults included; the
/// limits of criteria only judge it. Cost: linear in the
/// number of keys.
std::vector<ConfiguredFunction> functions(const Config& config);
/// Whether one of those that act by the temperature alone depends on the time.
bool heat_changes_in_time(const Config& config);

/// The values that identify the model (KeyInfo::identifies_model), in the order of the keys. A key that has its default
/// is among them if there is a default to be written.
std::vector<ConfiguredValue> identifying_values(const Config& config);

/// The values of all keys.
std::vector<ConfiguredValue> all_values(const Config& config);

}  // namespace creepcontact::config
