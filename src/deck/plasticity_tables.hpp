#pragma once
/// [materials.<name>.plasticity] of *PLASTIC.

#include "draft.hpp"

namespace creepcontact::deck {

/// Whether a material has a yield stress. One of zero, next to *CREEP, is creep alone.
bool yields(const Material& material);
/// Sets the plasticity of a material from its *PLASTIC; what cannot be is among draft.impossible. A yield stress of
/// zero next to creep is creep without an elastic range: nothing is set.
void make_plasticity(Draft& draft, const Material& material, config::Material& made);

}  // namespace creepcontact::deck
