#pragma once
/// The sections of a report about one run.

#include "drawings.hpp"
#include "html.hpp"
#include "run_data.hpp"

namespace creepcontact::report {

/// How a run ended, in a sentence; empty for one that was completed.
std::string ending(const RunData& run);

/// "60915"
std::string number(double value);
/// "60915 N"; without a unit if it is not known.
std::string with_unit(double value, const std::string& unit);

/// @param number  of the run, for the ids of the page; from 1 @param level  of the headings: "h2" for a single run
void add_answer(const RunData& run, Html& page, const std::string& level);
void add_histories(const RunData& run, Drawings& drawings, Html& page, const std::string& level);
void add_fields(const RunData& run, std::size_t number, Drawings& drawings, Html& page, const std::string& level);
void add_inputs(const RunData& run, Drawings& drawings, Html& page, const std::string& level);
void add_accuracy(const RunData& run, Drawings& drawings, Html& page, const std::string& level);
/// How the report came about: files, versions, dates.
void add_origin(const RunData& run, Html& page, const std::string& level);

}  // namespace creepcontact::report
