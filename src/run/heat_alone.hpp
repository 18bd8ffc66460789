#pragma once
/// Runs that compute the temperature alone.

#include "creepcontact/config/config.hpp"

namespace creepcontact::run {

/// Without probes of mechanics, and the expressions and events that name them, if only the heat is computed; tells of
/// them. Else as it is.
config::Config with_what_is_computed(config::Config config);

}  // namespace creepcontact::run
