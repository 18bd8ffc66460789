#pragma once
/// The solid that a mesh represents: itself, or the body whose section it is.

#include <numbers>

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/settings/analysis.hpp"

namespace creepcontact::mesh {

struct Section {
  settings::Analysis analysis = settings::Analysis::solid;
  double thickness = 1;     ///< [length] of plane sections
  double axial_length = 1;  ///< [length] displacement of the axial node (Mesh) per unit of axial strain; of any size

  /// Whether distorted elements with reduced integration (hex20, plane quad8) get the projection against locking that
  /// regular ones do not need; false: plain displacement elements.
  bool project_distorted = true;

  bool is_axisymmetric() const { return analysis == settings::Analysis::axisymmetric; }
  bool has_axial_node() const { return analysis == settings::Analysis::generalized_plane_strain; }
  /// Dimension of the cells that carry material: 3, or 2 in sections.
  int dimension() const { return analysis == settings::Analysis::solid ? 3 : 2; }
  /// What integrals over the mesh are multiplied with: 1 in a solid, the thickness [length], or the circumference
  /// 2 pi x [length].
  double depth(const Vector3& x) const {
    if (is_axisymmetric()) return 2 * std::numbers::pi * x.x();
    return dimension() == 3 ? 1 : thickness;
  }
};

}  // namespace creepcontact::mesh
