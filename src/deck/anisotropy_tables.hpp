#pragma once
/// Keys of materials with axes, and the axes of bodies.

#include "draft.hpp"

namespace creepcontact::deck {

/// Elasticity within the table of a material. Precondition: it is not isotropic, and has rows
void write_orthotropic(Draft& draft, const Material& material);
/// *POTENTIAL, within the table of a material.
void write_hill(Draft& draft, const Material& material);
/// *ORIENTATION, within the table of a body that has one.
void write_axes(Draft& draft, const DeckBody& body);

}  // namespace creepcontact::deck
