#pragma once
/// [heat]: the temperature of all bodies by conduction, before anything else is known of the model.

#include "creepcontact/mechanics/temperature_field.hpp"
#include "model_links.hpp"
#include "shared_nodes.hpp"

namespace creepcontact::model {

/// Integrates the temperature over the run, or finds the steady one. Tells what it took.
/// @throws ModelError naming the place of what is not possible; SolverError if the integration fails
/// Cost: an elastic factorisation needs about ten times as long as one of these; there are some dozens
mechanics::TemperatureField computed_temperature(const config::Config& config, const mesh::Mesh& whole,
                                                 const BodyMeshes& meshes, const SharedNodes& shared,
                                                 const ModelLinks& links);

}  // namespace creepcontact::model
