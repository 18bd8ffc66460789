#pragma once
/// What `check` says of the gap of a contact and of the distance between its surfaces in the mesh.

#include <optional>
#include <string>

#include "creepcontact/model/model.hpp"

namespace creepcontact::run {

/// "gap 0, distance in the mesh 0 to 0.02"
std::string gap_text(const config::Contact& contact, const contact::Pair& pair);

/// A sentence if surfaces drawn apart or overlapping by more than a thousandth of the size of the smaller body (the
/// diagonal of its box) have a given gap (at t = 0) that differs from the distance in the mesh by more than that and a
/// twentieth of the distance. Surfaces drawn as touching may be given any gap: an interference, or a parabola.
std::optional<std::string> gap_warning(const model::Model& model, const contact::Pair& pair);

}  // namespace creepcontact::run
