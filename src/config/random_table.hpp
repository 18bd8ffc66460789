#pragma once
/// The table [random] of a study.

#include "creepcontact/config/random.hpp"
#include "creepcontact/config/study.hpp"
#include "diagnostics.hpp"
#include "value.hpp"

namespace creepcontact::config {

Value<Random> random_table();

/// What the keys, their correlations and the rest of the study demand of each other; completes Random::factor.
void check_random(Study& study, Diagnostics& errors);

}  // namespace creepcontact::config
