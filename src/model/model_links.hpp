#pragma once
/// [[cyclic]] and [[rigid]]: links between the nodes of a body, and ties between faces of a sector whose meshes differ.

#include <optional>
#include <vector>

#include "creepcontact/contact/geometry/equation_rows.hpp"
#include "creepcontact/contact/geometry/sector.hpp"
#include "creepcontact/mechanics/node_links.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {

struct ModelLinks {
  /// A face of a sector that has no matching nodes on the other one.
  struct UnmatchedFace {
    std::size_t cyclic = 0, body = 0;  ///< index in the configuration, and of the body
  };
  std::vector<mechanics::NodeLinks> of_body;
  std::vector<UnmatchedFace> unmatched;
  /// Part of a [[rigid]] on one body.
  struct RigidPart {
    std::size_t body = 0, link = 0;  ///< index in of_body[body].rigid
  };
  std::vector<std::vector<RigidPart>> rigid;  ///< by [[rigid]]
};

/// The sector of the whole model: all [[cyclic]] have the same axis and angle. Empty without [[cyclic]].
std::optional<contact::Sector> sector(const config::Config& config);

/// Nodes of the second face match if each lies within 1e-6 of the model's size of the turned position of one of the
/// first; it is then moved there exactly. Errors name the place in the configuration.
ModelLinks make_links(const config::Config& config, const mesh::Mesh& whole, BodyMeshes& meshes,
                      ErrorCollector& errors);

/// Forces and moments of [[rigid]] and [[coupling]].
void add_motion_loads(const config::Config& config, const BodyMeshes& meshes, const ModelLinks& links, Bodies& bodies,
                      ErrorCollector& errors);

/// An equation between displacements of one body, or of two, and its value.
struct MotionEquation {
  const config::Location* location = nullptr;
  std::size_t slave = 0, master = 0;
  contact::LinearEquation equation;
  Function value = 0.0;
};
/// What joins the parts of a [[rigid]] on several bodies, and prescribes motions of [[coupling]].
std::vector<MotionEquation> motion_equations(const config::Config& config, const BodyMeshes& meshes,
                                             const ModelLinks& links, ErrorCollector& errors);

std::string sector_tie_name(const config::Config& config, const ModelLinks::UnmatchedFace& faces);
/// Ties unmatched faces by the mortar method: the second face is the slave.
void append_sector_ties(const config::Config& config, const ModelLinks& links, const Bodies& bodies,
                        std::vector<contact::Pair>& pairs, ErrorCollector& errors);

}  // namespace creepcontact::model
