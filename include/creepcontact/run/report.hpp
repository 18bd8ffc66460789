#pragma once
/// The outcome of a run as text for people.

#include <string>

#include "creepcontact/run/summary.hpp"

namespace creepcontact::run {

/// What came out: contact forces and stresses at the start, at their largest and at the end, contacts that opened,
/// damage, life and rupture; and in one line what it cost. Empty if nothing has come out.
std::string report(const Summary& summary);

/// What it cost in detail: steps, solves, accuracy, time, memory, processes. Empty if no step was made.
std::string details(const Summary& summary);

/// One sentence or two for each thing that was off; empty if all went well.
std::vector<std::string> advice(const Summary& summary);

}  // namespace creepcontact::run
