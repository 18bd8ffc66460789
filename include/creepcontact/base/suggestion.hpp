#pragma once
/// "did you mean": the nearest of some names.

#include <string>
#include <string_view>
#include <vector>

namespace creepcontact {

/// Letters to insert, delete, replace or swap with the next one, each counted as 2; a wrong case counts 1.
int edit_distance(std::string_view a, std::string_view b);

/// The first of the nearest names. Names that begin with the word, or have it as one of the parts that underscores
/// separate, come before all others. Empty if every name takes changes of more than a third of the word's letters.
std::string nearest(std::string_view name, const std::vector<std::string>& names);

/// "; did you mean 'x'?" for the nearest name; empty if none is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& names);

}  // namespace creepcontact
