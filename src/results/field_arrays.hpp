#pragma once
/// Nodal and element arrays of a snapshot as the field files take them; bodies one after the other.

#include <vector>

#include "creepcontact/io/fields/field_writer.hpp"
#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::results {

/// The output variables with a point_array, and body.
std::vector<io::FieldData> point_arrays(Snapshot& snapshot);
/// Element means: the output variables with a cell_array, evaluated of the means of stress and creep strain, and body.
std::vector<io::FieldData> cell_arrays(Snapshot& snapshot);

}  // namespace creepcontact::results
