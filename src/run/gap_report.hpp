#pragma once
/// What `check` says of the gap of a contact and of the distance between its surfaces in the mesh.

#include <optional>
#include <string>

#include "creepcontact/model/model.hpp"

namespace creepcontact::run {

/// "gap 0, distance in the mesh 0 to 0.02"
std::string gap_text(const config::Contact& contact, const contact::Pair& pair);

/// A warning if surfaces are drawn apart or overlapping, and their given gap (at t = 0) differs from the distance in
/// the mesh. Only a distance above a thousandth of the size of the smaller body (the diagonal of its box) counts. The
/// difference must exceed this thousandth plus a twentieth of the distance. Surfaces drawn as touching may be given any
/// gap: an interference, or a parabola.
std::optional<std::string> gap_warning(const model::Model& model, const contact::Pair& pair);

}  // namespace creepcontact::run
