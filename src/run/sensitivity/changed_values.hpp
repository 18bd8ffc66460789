#pragma once
/// The configurations from which derivatives are taken: each has one value changed a little.

#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"

namespace creepcontact::run {

/// A number of a configuration, and the configurations with more and less of it.
struct ChangedValue {
  std::string key;  ///< "contacts[0].gap"
  double value = 0;
  double change = 0;                    ///< a typical one, > 0: results are differentiated with respect to value/change
  config::Config more = {}, less = {};  ///< with value + and - relative_change * change
};

/// Small enough for the second derivatives of results, large enough for the rounding errors of their differences.
constexpr double relative_change = 1e-5;

/// One for each key of [sensitivity]. @param config  complete
/// @throws ConfigError with one line per mistake: keys that the configuration does not have, values that are not
/// numbers, and settings with which there are no derivatives
std::vector<ChangedValue> changed_values(const config::Config& config);

}  // namespace creepcontact::run
