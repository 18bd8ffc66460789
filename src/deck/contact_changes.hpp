#pragma once
/// *MODEL CHANGE, TYPE=CONTACT PAIR: pairs that are out of the model in some steps.

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "draft.hpp"
#include "element_faces.hpp"

namespace creepcontact::deck {

/// Names of two surfaces in upper case, the lesser first.
using SurfacePair = std::pair<std::string, std::string>;
SurfacePair surface_pair(const std::string& a, const std::string& b);

/// 1 while a pair is removed, else 0; the pairs that are never removed are not in it.
using Removals = std::map<SurfacePair, Course>;
Removals removals_of_pairs(Draft& draft);

/// A distance larger than any displacement: the size of the model.
double distance_of_removed(const Deck& deck);
/// Precondition: both have faces. The distance of two surfaces if it is the same all over the slave; negative where
/// they overlap.
std::optional<double> even_distance(const Deck& deck, const std::vector<ElementFace>& slave,
                                    const std::vector<ElementFace>& master);

}  // namespace creepcontact::deck
