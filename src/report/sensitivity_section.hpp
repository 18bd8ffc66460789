#pragma once
/// Which input moves the answer most.

#include "html.hpp"
#include "run_data.hpp"

namespace creepcontact::report {

/// Nothing if the run has no derivatives.
void add_sensitivities(const RunData& run, Html& page);

}  // namespace creepcontact::report
