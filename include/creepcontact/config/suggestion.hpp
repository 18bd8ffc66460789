#pragma once
/// "did you mean": the nearest of some names.

#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::config {

/// Levenshtein distance in halves: a wrong letter counts 2, a wrong case 1.
int edit_distance(std::string_view a, std::string_view b);

/// The first of the nearest names, an abbreviated one before all others; empty if there are none.
std::string nearest(std::string_view name, const std::vector<std::string>& names);

}  // namespace creepcontact::config
