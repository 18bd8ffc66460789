#pragma once
/// Arrays of the field files as CalculiX names them.

#include <vector>

#include "creepcontact/io/fields/field_writer.hpp"
#include "creepcontact/io/fields/frd_writer.hpp"

namespace creepcontact::results {

/// @param at_points  point_arrays() of a snapshot, and of its contact surfaces
std::vector<io::FrdField> frd_fields(const std::vector<io::FieldData>& at_points);

}  // namespace creepcontact::results
