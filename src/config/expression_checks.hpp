#pragma once
/// Expressions that name other entries: those of probes, and the conditions of events.

#include "creepcontact/config/config.hpp"
#include "diagnostics.hpp"

namespace creepcontact::config {

/// Reports unknown names, mistakes of the language and probes that depend on themselves.
void check_expressions(const Config& config, Diagnostics& errors);

}  // namespace creepcontact::config
