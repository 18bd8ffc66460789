#pragma once
/// The sections of a report about one run.

#include "drawings.hpp"
#include "html.hpp"
#include "run_data.hpp"

namespace creepcontact::report {

/// How a run ended, in a sentence; empty for one that was completed.
std::string ending(const RunData& run);

/// The sentences and tables of results, and the assessment that the configuration has.
void add_answer(const RunData& run, Html& page);
void add_histories(const RunData& run, Drawings& drawings, Html& page);
/// Per cycle, and the way of each body in the interaction diagram; nothing if the run has no cycles.
void add_cycles(const RunData& run, Drawings& drawings, Html& page);
void add_fields(const RunData& run, Drawings& drawings, Html& page);
/// The view that turns, for screens. @param number  of the run, for the ids of the page; from 1
void add_viewer(const RunData& run, std::size_t number, Html& page);
/// @param others  runs that the inputs are compared with: a cell that differs is marked
void add_inputs(const RunData& run, const std::vector<RunData>& others, Drawings& drawings, Html& page);
void add_accuracy(const RunData& run, Html& page);
/// Steps, cost, and how the results came about.
void add_appendix(const RunData& run, Drawings& drawings, Html& page);

}  // namespace creepcontact::report
