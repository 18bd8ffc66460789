#pragma once
/// [heat]: the temperature of all bodies by conduction, before anything else is known of the model.

#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/heat/figures.hpp"
#include "creepcontact/mechanics/temperature_field.hpp"
#include "model_links.hpp"
#include "shared_nodes.hpp"

namespace creepcontact::model {

struct ComputedTemperature {
  mechanics::TemperatureField field;
  /// If its temperature is part of the state, the field is that at the start. The meshes are those it was made with.
  creep::HeatModel heat;
  heat::Figures figures;
};

/// Integrates the temperature over the run, or finds the steady one. Tells what it took.
/// @throws ModelError naming the place of what is not possible; SolverError if the integration fails
/// Cost: an elastic factorisation needs about ten times as long as one of these; there are some dozens
ComputedTemperature computed_temperature(const config::Config& config, const mesh::Mesh& whole,
                                         const BodyMeshes& meshes, const SharedNodes& shared, const ModelLinks& links);

/// The model of heat on the meshes of the assembly, with interfaces that know the contact nodes of their pairs.
creep::HeatModel of_assembly(creep::HeatModel heat, const config::Config& config, const creep::Assembly& assembly);

}  // namespace creepcontact::model
