#pragma once
/// Heat at places: its flux in bodies, and what passes the nodes of contact.

#include <span>
#include <vector>

#include "creepcontact/heat/conduction.hpp"
#include "creepcontact/mechanics/discretization.hpp"

namespace creepcontact::heat {

/// -k(T) grad T at the integration points of a body, n_points x 3.
/// @param T  of its nodes @param elements  of the body, or of a part of it
std::vector<double> flux(const Conductor& body, const mechanics::Discretization& elements, std::span<const double> T);

/// Means over the linear functions of contact nodes: they are right where the flow at single points is not, at large
/// conductances.
struct NodeOfInterface {
  double jump = 0;         ///< temperature of the first surface less that of the second
  double conductance = 0;  ///< flow per area over the jump; where there is no jump, its mean
};

/// @param T  by body, of their nodes @param n_nodes  of contact, of all pairs
/// @returns one per contact node; zeros where no interface is
std::vector<NodeOfInterface> at_contact_nodes(const Definition& definition, std::span<const std::vector<double>> T,
                                              double t, const ContactAtNodes& contact, std::size_t n_nodes);

}  // namespace creepcontact::heat
