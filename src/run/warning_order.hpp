#pragma once
/// Which warnings come first.

#include <string>
#include <vector>

namespace creepcontact::run {

/// Sorted by consequence: what makes results mean something else, what makes them inaccurate, what costs time, what
/// concerns files; in their order within each.
std::vector<std::string> by_consequence(std::vector<std::string> warnings);

}  // namespace creepcontact::run
