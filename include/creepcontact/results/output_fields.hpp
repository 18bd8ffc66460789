#pragma once
/// The fields of a model at an output time, as arrays.

#include <vector>

#include "creepcontact/io/fields/field_writer.hpp"
#include "creepcontact/results/contact_surfaces.hpp"
#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::results {

/// The fields of one output time, under their names without units.
struct OutputFields {
  std::vector<io::FieldData> at_points;    ///< of the bodies, contact pressure and gap included
  std::vector<io::FieldData> in_cells;     ///< of the bodies
  std::vector<io::FieldData> on_contacts;  ///< at the points of the contact surfaces; empty: there are none
};

/// Makes the fields of a model.
class OutputFieldMaker {
 public:
  /// @param assembly  must outlive the object
  explicit OutputFieldMaker(const creep::Assembly& assembly) : assembly_(assembly), surfaces_(assembly) {}

  /// The bodies one after the other, with their names as the text `bodies`.
  io::FieldMesh mesh() const;
  const ContactSurfaces& surfaces() const { return surfaces_; }
  /// @param snapshot  of the model
  OutputFields at(Snapshot& snapshot) const;

 private:
  const creep::Assembly& assembly_;
  ContactSurfaces surfaces_;
};

}  // namespace creepcontact::results
