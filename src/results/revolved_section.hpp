#pragma once
/// Pictures of axisymmetric models: the section turned about the axis y through the full circle.

#include "creepcontact/io/fields/field_writer.hpp"

namespace creepcontact::results {

class RevolvedSection {
 public:
  /// @param section  points and surface cells in the plane z = 0 @param segments  around the circle, at least 3
  RevolvedSection(const io::FieldMesh& section, int segments);

  /// Solid cells; quadratic ones have points halfway between the segments.
  io::FieldMesh mesh() const;
  /// Values at the points of mesh() from those at the points of the section. Vectors and tensors turn with the section;
  /// arrays with component names of their own, such as principal stresses, do not.
  std::vector<io::FieldData> at_points(const std::vector<io::FieldData>& section) const;
  /// Values of the cells of mesh() from those of the cells of the section.
  std::vector<io::FieldData> at_cells(const std::vector<io::FieldData>& section) const;

 private:
  int n_layers() const { return 2 * segments_; }
  Matrix3 turn(double layer) const;
  /// @param layers  directions, in half segments from the plane of the section
  io::FieldData repeated(const io::FieldData& section, const std::vector<double>& layers) const;
  std::vector<io::FieldData> repeated(const std::vector<io::FieldData>& section,
                                      const std::vector<double>& layers) const;

  io::FieldMesh section_;
  int segments_;
};

}  // namespace creepcontact::results
