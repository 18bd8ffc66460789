#pragma once
/// Suggestions for mistyped names: "did you mean 'x'?"

#include <string>
#include <string_view>
#include <vector>

namespace creepcontact {

/// Cost of the edits that turn a into b: 2 per letter inserted, deleted, replaced or swapped with the next one, 1 per
/// wrong case.
int edit_distance(std::string_view a, std::string_view b);

/// The nearest name; the first of several. Names that begin with the word, or contain it as one of the parts separated
/// by underscores, are preferred to all others. Empty if for every name more than a third of the letters would change.
std::string nearest(std::string_view name, const std::vector<std::string>& names);

/// "; did you mean 'x'?" with the nearest name; empty if none is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& names);

}  // namespace creepcontact
