#pragma once
/// Several runs side by side.

#include <vector>

#include "drawings.hpp"
#include "html.hpp"
#include "run_data.hpp"

namespace creepcontact::report {

/// Tables with one column per run, and the histories of all runs overlaid.
void add_comparison(const std::vector<RunData>& runs, Drawings& drawings, Html& page);

}  // namespace creepcontact::report
