#pragma once
/// Nodal and element arrays of a snapshot as the field files take them; bodies one after the other.

#include <vector>

#include "creepcontact/io/field_writer.hpp"
#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::results {

/// displacement, stress, creep_strain, von_mises, creep_strain_equivalent, temperature, body; damage and life_fraction
/// if a material has them.
std::vector<io::FieldData> point_arrays(Snapshot& snapshot);
/// Element means: stress, creep_strain, von_mises, body.
std::vector<io::FieldData> cell_arrays(Snapshot& snapshot);

}  // namespace creepcontact::results
