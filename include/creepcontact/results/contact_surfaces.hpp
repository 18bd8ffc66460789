#pragma once
/// The slave surface of every contact pair, and what contact does at its nodes, as the field files take them.

#include <vector>

#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/io/field_writer.hpp"

namespace creepcontact::results {

/// Surfaces that share nodes have copies of them: each pair has values of its own.
class ContactSurfaces {
 public:
  /// @param assembly  must outlive the object
  explicit ContactSurfaces(const creep::Assembly& assembly);

  bool empty() const { return surfaces_.empty(); }
  /// The faces of all surfaces, one surface after the other; the names of the contacts as text.
  io::FieldMesh mesh() const;
  /// displacement, contact_pressure, gap. The gap is not a number where no part of the master is opposite.
  std::vector<io::FieldData> point_arrays(const creep::Equilibrium& at) const;
  /// contact: the number of the pair.
  std::vector<io::FieldData> cell_arrays() const;
  /// contact_pressure and gap at the nodes of all bodies, 0 where there are none. A node of several surfaces has those
  /// of the one that presses most.
  std::vector<io::FieldData> on_bodies(const creep::Equilibrium& at) const;

 private:
  struct Surface {
    std::size_t pair;
    std::vector<std::int64_t> nodes;  ///< of the slave body
    std::vector<mesh::Face> faces;    ///< nodes by their place in `nodes`
  };
  struct Values {
    std::vector<double> pressure, gap;  ///< by `Surface::nodes`
  };
  const contact::Pair& pair(const Surface& surface) const;
  const mesh::Mesh& body(const Surface& surface) const;
  Values values(const Surface& surface, const creep::Equilibrium& at) const;

  const creep::Assembly& assembly_;
  std::vector<Surface> surfaces_;
};

}  // namespace creepcontact::results
