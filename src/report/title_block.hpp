#pragma once
/// The head of a report.

#include <string>
#include <vector>

#include "html.hpp"
#include "run_data.hpp"

namespace creepcontact::report {

/// Title, logo, project, drawing, revision, author, checker, dates. For several runs it has what all have in common.
/// @returns a sentence on what is missing; empty: nothing
std::string add_title_block(const std::vector<RunData>& runs, const std::string& title, Html& page);

/// What the configurations ask, as a section; nothing if they do not say.
void add_question(const std::vector<RunData>& runs, Html& page);

}  // namespace creepcontact::report
