#pragma once
/// The criteria of runs, met or not: the first that a customer looks for.

#include <vector>

#include "html.hpp"
#include "run_data.hpp"

namespace creepcontact::report {

/// "met", "NOT met" or "not judged"
const char* verdict(const io::Summary::Criterion& criterion);

/// "93 %" of what is allowed, "-" if it was not judged. A value beyond its limit never shows as 100 %.
std::string utilisation(const io::Summary::Criterion& criterion);

/// A section, or nothing if the run has no criteria.
void add_criteria(const RunData& run, Html& page);

/// One table with a column per run.
void add_criteria(const std::vector<RunData>& runs, Html& page);

}  // namespace creepcontact::report
