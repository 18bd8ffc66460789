#pragma once
/// Distances of surfaces; ties of those that do not face each other, as of a bolt that overlaps with its thread.

#include "linear_equations.hpp"

namespace creepcontact::deck {

/// True if the outward normals of both surfaces point the same way, on average.
bool face_alike(const Deck& deck, const std::vector<ElementFace>& slave, const std::vector<ElementFace>& master);

struct NearestPoint {
  double distance = 0;
  Vector3 position = Vector3::Zero();
};
/// For each node of one surface the nearest point of another one; without nodes that have none, far from all.
std::map<std::int64_t, NearestPoint> nearest_points(const Deck& deck, const std::vector<ElementFace>& slave,
                                                    const std::vector<ElementFace>& master);

/// Each node of the slave surface moves as the point of the master surface nearest to it, as in CalculiX.
/// @param tolerance  nodes farther away are left alone; nullopt: a fortieth of the size of the master's faces
/// @param n_components  2 in sections, 3 in solids
std::vector<DeckEquation> tie_nodes_to_faces(const Deck& deck, const std::vector<ElementFace>& slave,
                                             const std::vector<ElementFace>& master, std::optional<double> tolerance,
                                             int n_components, const Place& place);

}  // namespace creepcontact::deck
