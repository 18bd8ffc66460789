#pragma once
/// Reference elements: shape functions, their derivatives, faces, and the quadrature for stiffness and stress.

#include <vector>

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/fem/quadrature.hpp"
#include "creepcontact/mesh/cell_faces.hpp"
#include "creepcontact/mesh/cell_type.hpp"
#include "creepcontact/mesh/section.hpp"

namespace creepcontact::fem {

using mesh::CellType;

/// Polynomials of the position on which a field within an element is projected.
enum class Projection {
  none,
  constant,
  linear  ///< in physical coordinates
};

/// Immutable; one instance per type, from reference_element(). Node numbering is that of Gmsh.
/// Reference domains: line, quadrilateral, hexahedron [-1,1]^d; triangle, tetrahedron: unit simplex; wedge: unit
/// triangle x [-1,1].
class ReferenceElement {
 public:
  /// Local nodes in the Gmsh order of the type of the face; by the right-hand rule the normal points out of the cell.
  using Face = mesh::LocalFace;

  virtual ~ReferenceElement() = default;
  CellType type() const { return type_; }
  int dimension() const { return mesh::dimension(type_); }
  int n_nodes() const { return mesh::n_nodes(type_); }
  /// Reference coordinates of the nodes, n_nodes x 3 (unused coordinates zero).
  const Eigen::MatrixX3d& nodes() const { return nodes_; }
  /// Faces of volume cells, edges of surface cells; empty for other cells.
  const std::vector<Face>& faces() const { return faces_; }
  /// Quadrature for stiffness, stress and creep state. Points: tet4 1, tet10 8, hex8 8, hex20 8, hex27 27, wedge6 6,
  /// wedge15 12; in sections tri3 1, tri6 6, quad4 4, quad8 4 (but see fem::bulk_rule()), quad9 9. Precondition: a
  /// volume or surface type.
  const QuadratureRule& bulk_rule() const { return bulk_rule_; }
  /// Quadrature for loads on curves and surfaces: exact for a pressure that varies like the shape functions, also on
  /// curved faces. Volumes: as bulk_rule().
  const QuadratureRule& rule() const { return rule_; }
  /// Projection of the volumetric strain in stiffness and stress, against locking in incompressible deformation such as
  /// creep: constant in hex8 and wedge6 (B-bar), linear in quadratic elements. Precondition: a volume element.
  Projection volumetric_strain() const {
    if (mesh::order(type_) == 2) return Projection::linear;
    return type_ == CellType::tet4 || type_ == CellType::tri3 ? Projection::none : Projection::constant;
  }
  /// True if elements close to a parallelepiped are not projected: in such hex20 the reduced integration avoids locking
  /// by itself, and they resist hourglass modes better without projection.
  bool projects_distorted_elements_only() const { return type_ == CellType::hex20 || type_ == CellType::quad8; }
  /// True for linear tetrahedra, wedges and triangles: with any projection they are too stiff in incompressible
  /// deformation.
  bool locks() const { return type_ == CellType::tet4 || type_ == CellType::wedge6 || type_ == CellType::tri3; }

  /// Shape functions at xi. @param shape  size n_nodes
  virtual void shape(const Vector3& xi, Eigen::Ref<Eigen::VectorXd> shape) const = 0;
  /// Derivatives with respect to xi. @param gradient  n_nodes x 3, unused columns zero
  virtual void gradient(const Vector3& xi, Eigen::Ref<Eigen::MatrixX3d> gradient) const = 0;

 protected:
  ReferenceElement(CellType type, Eigen::MatrixX3d nodes, std::vector<Face> faces, QuadratureRule rule,
                   QuadratureRule bulk_rule)
      : type_(type),
        nodes_(std::move(nodes)),
        faces_(std::move(faces)),
        rule_(std::move(rule)),
        bulk_rule_(std::move(bulk_rule)) {}

 private:
  CellType type_;
  Eigen::MatrixX3d nodes_;
  std::vector<Face> faces_;
  QuadratureRule rule_, bulk_rule_;
};

/// For every mesh::CellType except point1. Cost: none after the first call.
const ReferenceElement& reference_element(CellType type);

/// Quadrature of the elements of a mesh: ReferenceElement::bulk_rule(), but 3 x 3 points for quad8 in axisymmetric
/// sections: 2 x 2 points do not integrate the radius times the Jacobian of curved edges, and miss a uniform stress by
/// an error of first order. Precondition: a volume or surface type
const QuadratureRule& bulk_rule(CellType type, const mesh::Section& section);

}  // namespace creepcontact::fem
