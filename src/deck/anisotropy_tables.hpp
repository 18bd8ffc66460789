#pragma once
/// Keys of materials with axes, and the axes of bodies.

#include "draft.hpp"

namespace creepcontact::deck {

/// Sets the elasticity. Precondition: it is not isotropic, and has rows
void make_orthotropic(Draft& draft, const Material& material, config::Material& made);
/// Sets the ratios of *POTENTIAL.
void make_hill(Draft& draft, const Material& material, config::Material& made);
/// Sets the axes of a body that has an *ORIENTATION.
void make_axes(Draft& draft, const DeckBody& body, config::Body& made);

}  // namespace creepcontact::deck
