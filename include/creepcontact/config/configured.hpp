#pragma once
/// Functions and values of a configuration as data, recorded while it is read. Code that needs all of them
/// (breakpoints, the fingerprint of a checkpoint) then cannot forget a kind of key.

#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"

namespace creepcontact::config {

/// A function of the configuration: a number, an expression or a table.
struct ConfiguredFunction {
  std::string key;  ///< full: "loads[0].traction[2]"
  Function value;
  std::vector<std::string> variables;  ///< that the key allows

  bool may_depend_on(const std::string& variable) const;
  /// True if it may depend on x, y, z and t only.
  bool is_of_position_and_time() const;
};

/// The value of a key that identifies the model (KeyInfo::identifies_model).
struct ConfiguredValue {
  std::string key;   ///< full: "contacts[0].gap"
  std::string text;  ///< the same for equal values: 1.0 and 1 are both "1"
};

}  // namespace creepcontact::config
