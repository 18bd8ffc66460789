#pragma once
/// The problem of heat that [heat] and the bodies, contacts and links of a configuration make.

#include "creepcontact/heat/conduction.hpp"
#include "model_links.hpp"
#include "model_parts.hpp"
#include "shared_nodes.hpp"

namespace creepcontact::model {

/// Warns of temperatures that are given twice; tells of films in contacts. The meshes must outlive it.
/// @throws ModelError naming the entry of [heat]
heat::Definition heat_definition(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes,
                                 const SharedNodes& shared, const ModelLinks& links);

}  // namespace creepcontact::model
