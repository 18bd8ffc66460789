#pragma once
/// The slave surfaces of all contact pairs with their contact values, as needed for the field files.

#include <vector>

#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/io/fields/field_writer.hpp"
#include "creepcontact/results/contact_values.hpp"

namespace creepcontact::results {

/// Each pair has its own values: nodes shared by several surfaces are duplicated.
class ContactSurfaces {
 public:
  /// @param assembly  must outlive the object
  explicit ContactSurfaces(const creep::Assembly& assembly);

  bool empty() const { return surfaces_.empty(); }
  /// The faces of all surfaces, surface by surface, with the names of the contacts as text.
  io::FieldMesh mesh() const;
  /// Nodal arrays displacement, contact_pressure and gap; with friction in the model also contact_traction (vector, on
  /// the slave), contact_shear, slip and contact_status. The gap is NaN where the master is not opposite.
  std::vector<io::FieldData> point_arrays(const creep::Equilibrium& at,
                                          std::span<const heat::NodeOfInterface> heat = {}) const;
  /// Cell array contact: the number of the pair.
  std::vector<io::FieldData> cell_arrays() const;
  /// contact_pressure and gap at the nodes of all bodies, 0 elsewhere. A node of several surfaces gets the values of
  /// the one with the largest pressure.
  std::vector<io::FieldData> on_bodies(const creep::Equilibrium& at) const;

 private:
  struct Surface {
    std::size_t pair;
    std::vector<std::int64_t> nodes;  ///< numbers in the slave body
    std::vector<mesh::Face> faces;    ///< their nodes are indices into `nodes`
  };
  using Values = std::vector<ContactValues>;  // per entry of Surface::nodes; gap NaN: the master is not opposite
  const contact::Pair& pair(const Surface& surface) const;
  const mesh::Mesh& body(const Surface& surface) const;
  Values values(const Surface& surface, const creep::Equilibrium& at,
                std::span<const heat::NodeOfInterface> heat = {}) const;

  const creep::Assembly& assembly_;
  std::vector<Surface> surfaces_;
};

}  // namespace creepcontact::results
