#pragma once
/// How well the forces at an output time balance.

#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::results {

/// Largest force of a free dof that neither loads nor contact balance, |T^T (integral B^T sigma - F - contact)|,
/// relative to the largest nodal force of a body, |integral B^T sigma|. 0 if all of them are zero. The stabilisation of
/// elements with reduced integration counts as unbalanced. Cost: two element loops per body.
double equilibrium_residual(Snapshot& snapshot);

}  // namespace creepcontact::results
