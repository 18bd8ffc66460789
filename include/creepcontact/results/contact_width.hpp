#pragma once
/// Resolution of contact zones by the slave mesh.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/contact/geometry/contact_grid.hpp"
#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"

namespace creepcontact::results {

/// Width of the contact zone in slave elements, as an odd number: 2 k - 1 if the innermost row is the k-th row from the
/// edge of the zone. Only open rows count as an edge: where the zone reaches the end of the surface it is assumed to
/// continue, as at a plane of symmetry. If there are several connected zones, the narrowest counts, ignoring those with
/// less than a tenth of the force.
/// @param force_of_row  contact force per row of the grid; rows without force are open
/// @returns nullopt if nothing is in contact, or no zone has an edge since the contact covers the surface
std::optional<int> elements_across(const contact::ContactGrid& grid, const Eigen::VectorXd& force_of_row);

/// The width of the contact zone of a unilateral pair in this state.
std::optional<int> elements_across(const creep::Assembly& assembly, const contact::Pair& pair,
                                   const creep::Equilibrium& at);

/// What to say of a contact whose zone is so many slave elements wide; empty: it is wide enough. @param when  "at the
/// end"
std::string narrow_contact_text(const contact::Pair& pair, int width, const std::string& when);

/// One message per unilateral contact with a zone narrower than four slave elements. @param when  "at the end"
std::vector<std::string> narrow_contacts(const creep::Assembly& assembly, const creep::Equilibrium& at,
                                         const std::string& when);

}  // namespace creepcontact::results
