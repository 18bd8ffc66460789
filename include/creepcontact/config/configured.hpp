#pragma once
/// What a configuration says, as data: recorded while it is read, so that no kind of key can be forgotten by those who
/// need all of them (breakpoints, the fingerprint of a checkpoint).

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
  /// Of no other variables than x, y, z and t.
  bool is_of_position_and_time() const;
};

/// The value of a key that identifies the model (KeyInfo::identifies_model).
struct ConfiguredValue {
  std::string key;   ///< full: "contacts[0].gap"
  std::string text;  ///< the same for equal values: 1.0 and 1 are both "1"
};

}  // namespace creepcontact::config
