#pragma once
/// The scalars in the field files of a run, by name.

#include <string>
#include <vector>

#include "creepcontact/io/fields/field_reader.hpp"
#include "creepcontact/io/tables/model_record.hpp"

namespace creepcontact::report {

/// A scalar of a file: a record whose array has the name that the file uses ("von_mises [MPa]").
using Field = io::RecordedField;

/// The scalars of the file; those that matter most to strength come first: von Mises stress, contact pressure, creep
/// strain,
/// ...
/// @param known  labels and units; arrays that are not among them are called as in the file
std::vector<Field> fields_of(const io::FieldFile& file, const std::vector<io::RecordedField>& known);

/// One value per point; NaN: none.
std::vector<double> values_of(const Field& field, const io::FieldFile& file);

/// Name of the array of displacements in the file; empty if there is none.
std::string displacement_array(const io::FieldFile& file);

/// @throws ConfigError naming the nearest name and all of them, if there is none
const Field& field_named(const std::string& name, const std::vector<Field>& fields);

}  // namespace creepcontact::report
