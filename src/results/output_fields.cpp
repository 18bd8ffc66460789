#include "creepcontact/results/output_fields.hpp"

#include <algorithm>
#include <iterator>

#include "field_arrays.hpp"

namespace creepcontact::results {

io::FieldMesh OutputFieldMaker::mesh() const {
  io::FieldMesh mesh;
  io::TextArray names{"bodies", {}};
  for (const mechanics::Body& body : assembly_.bodies()) {
    mesh.append(body.mesh());
    names.values.push_back(body.name());
  }
  mesh.texts.push_back(std::move(names));
  return mesh;
}

OutputFields OutputFieldMaker::at(Snapshot& snapshot) const {
  OutputFields fields{point_arrays(snapshot), cell_arrays(snapshot), {}};
  if (surfaces_.empty()) return fields;
  std::ranges::move(surfaces_.on_bodies(snapshot.equilibrium()), std::back_inserter(fields.at_points));
  fields.on_contacts = surfaces_.point_arrays(snapshot.equilibrium(), snapshot.heat_of_contact());
  return fields;
}

}  // namespace creepcontact::results
