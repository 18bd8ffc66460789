#pragma once
/// Several runs side by side.

#include <vector>

#include "drawings.hpp"
#include "html.hpp"
#include "run_data.hpp"
#include "run_labels.hpp"

namespace creepcontact::report {

/// The keys of the configuration that differ, with the values of all runs.
void add_differences(const std::vector<InputDifference>& differences, const std::vector<RunData>& runs, Html& page);
/// Tables with one column per run.
void add_compared_results(const std::vector<RunData>& runs, Html& page);
/// The histories of all runs overlaid, a figure per probe.
void add_overlays(const std::vector<RunData>& runs, Drawings& drawings, Html& page);
/// One picture per run, in a row.
void add_compared_pictures(const std::vector<RunData>& runs, Drawings& drawings, Html& page);
void add_compared_accuracy(const std::vector<RunData>& runs, Html& page);
void add_compared_appendix(const std::vector<RunData>& runs, Html& page);

}  // namespace creepcontact::report
