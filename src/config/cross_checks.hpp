#pragma once
/// Checks that need more than one table: references by name, names given twice, temperature.

#include "creepcontact/config/config.hpp"
#include "diagnostics.hpp"
#include "item.hpp"

namespace creepcontact::config {

/// @param root  the document that the configuration was read from
void cross_check(const Config& config, const Item& root, Diagnostics& errors);

}  // namespace creepcontact::config
