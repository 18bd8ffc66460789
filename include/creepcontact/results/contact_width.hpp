#pragma once
/// How finely the slave surface divides a contact zone.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/contact/geometry/contact_grid.hpp"
#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"

namespace creepcontact::results {

/// Width of the contact zone in slave elements, to the nearest odd number: 2 k - 1 if its innermost row is the k-th
/// from its edge. Only open rows are an edge: where the zone reaches the end of the surface it is taken as going on, as
/// at a plane of symmetry. Of several connected zones the narrowest counts; those that carry less than a tenth of the
/// force do not.
/// @returns nullopt if nothing is in contact, or if no zone has an edge: the contact is as wide as the surface
std::optional<int> elements_across(const contact::ContactGrid& grid, const Eigen::VectorXd& force_of_row);

/// A sentence for each unilateral contact whose zone is less than four slave elements wide.
std::vector<std::string> narrow_contacts(const creep::Assembly& assembly, const creep::Equilibrium& at);

}  // namespace creepcontact::results
