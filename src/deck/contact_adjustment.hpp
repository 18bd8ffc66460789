#pragma once
/// *CONTACT PAIR, ADJUST: nodes of the slave surface that begin on the master surface.

#include <map>
#include <optional>
#include <string>

#include "node_to_face_ties.hpp"

namespace creepcontact::deck {

/// Nodes of a slave surface that ADJUST reaches, with their points on the master surface.
struct Reach {
  std::map<std::int64_t, NearestPoint> near;
  std::size_t n_nodes = 0;  ///< of the surface
  bool all_near() const { return near.size() == n_nodes; }
};

/// @param adjust  value of ADJUST: a distance, or a set of nodes
/// @param problem  gets why there is nothing to say of it
std::optional<Reach> adjust_reach(const Deck& deck, const std::string& adjust, const std::vector<ElementFace>& slave,
                                  const std::vector<ElementFace>& master, std::string& problem);

/// Moves the nodes that ADJUST reaches onto the master surfaces, where it does not reach all of a slave surface: if it
/// does, the surfaces touch whatever the mesh says.
void adjust_contacts(Deck& deck);

}  // namespace creepcontact::deck
