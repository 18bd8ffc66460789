#pragma once
/// Geometry of one face of a contact surface: position, normal, projection onto a plane and back.
///
/// An edge of a section is a strip: a quadrilateral that extends along z, whose two layers have the same nodes. Sums
/// over the layers are the one-dimensional shape functions and dual functions of the edge exactly, so curves need no
/// algorithms of their own.

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/geometry/polygon.hpp"
#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::contact {

/// Values of shape functions at one point, at most nine.
using ShapeValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 9, 1>;

/// A plane with two orthonormal axes; projection preserves lengths and areas in the plane.
struct Plane {
  Vector3 origin, normal, axis1, axis2;

  static Plane through(const Vector3& origin, const Vector3& normal);
  Eigen::Vector2d project(const Vector3& x) const { return {axis1.dot(x - origin), axis2.dot(x - origin)}; }
  Eigen::Vector2d project_direction(const Vector3& d) const { return {axis1.dot(d), axis2.dot(d)}; }
};

/// How edges of a section become strips.
struct Strip {
  double depth = 0;            ///< [length] of the strips; 0: the faces are those of a solid
  mesh::Section section = {};  ///< whose depth integrals over the strips have
};

/// Strips about as deep as the edges are long. @param mesh  that the faces belong to
Strip strip_of(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces);

/// A face with the coordinates of its nodes. Its normal points out of its body. Immutable.
class Facet {
 public:
  using Coordinates = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 9, 3>;

  /// @param strip  the same for all facets that meet
  Facet(const mesh::Mesh& mesh, const mesh::Face& face, const Strip& strip);
  /// A face that is not part of a mesh: nodes() is empty. @param x  coordinates, one row per node of `type`
  Facet(mesh::CellType type, Coordinates x);

  const fem::ReferenceElement& element() const { return *element_; }
  /// Linear element on the corners, which carries the multipliers.
  const fem::ReferenceElement& corner_element() const { return *corner_element_; }
  const std::vector<std::int64_t>& nodes() const { return nodes_; }
  Index n_nodes() const { return x_.rows(); }
  int n_corners() const { return n_corners_; }
  Vector3 node_position(int i) const { return x_.row(i).transpose(); }

  /// True if the position is linear in the reference coordinates: a flat face with straight, evenly divided edges.
  bool is_affine() const { return is_affine_; }

  Vector3 position(const Vector3& xi) const;
  /// Normal times the surface Jacobian |dx/dxi1 x dx/dxi2|.
  Vector3 area_vector(const Vector3& xi) const;
  const Vector3& centre_xi() const { return centre_xi_; }
  Vector3 centre() const { return position(centre_xi_); }
  Vector3 area_vector_at_centre() const { return area_vector(centre_xi_); }
  /// Area of the body's surface over that of the facet: 1, or for a strip the depth of the section over its own.
  double area_ratio(const Vector3& position) const {
    return strip_.depth > 0 ? strip_.section.depth(position) / strip_.depth : 1;
  }
  /// A point of a strip in the plane z = 0 of its section; otherwise the point itself.
  Vector3 in_section(const Vector3& point) const { return strip_.depth > 0 ? Vector3(point.x(), point.y(), 0) : point; }
  /// Area of the body's surface, by the quadrature rule of the element.
  double surface_area() const;
  /// Largest distance between two corners.
  double diameter() const { return diameter_; }
  const Eigen::AlignedBox3d& box() const { return box_; }

  /// The projected face as convex polygons, counter-clockwise as seen against the normal of the plane. One polygon if
  /// the edges project to straight lines, else triangles around the centre; their outer edges preserve the area under
  /// each curved edge.
  /// @param flipped  true for a face seen from behind (the master, whose normal opposes that of the plane)
  std::vector<Polygon> pieces(const Plane& plane, bool flipped) const;

  /// Reference coordinates of the point that projects onto p, by Newton's method. The face is continued beyond its
  /// edges.
  /// @param xi  in: start of the iteration; out: the point, if found @returns false if none was found
  bool unproject(const Plane& plane, const Eigen::Vector2d& p, Vector3& xi) const;
  /// Finds the intersection of the face with the line from `origin` along `direction`, as unproject().
  bool meet_line(const Vector3& origin, const Vector3& direction, Vector3& xi) const;

 private:
  /// Coefficients of xi1^a xi2^b, a, b = 0, 1, 2, of the position, one column each.
  using Polynomial = Eigen::Matrix<double, 3, 9>;

  void fit_polynomial();
  std::array<Vector3, 2> tangents(const Vector3& xi) const;
  /// Corners and, on curved edges, additional points between them.
  Polygon outline(const Plane& plane) const;

  const fem::ReferenceElement* element_;
  const fem::ReferenceElement* corner_element_;
  std::vector<std::int64_t> nodes_;
  int n_corners_;
  Coordinates x_;
  Polynomial polynomial_;
  bool is_affine_ = false;
  Strip strip_ = {};
  Vector3 centre_xi_;
  double diameter_ = 0;
  Eigen::AlignedBox3d box_;
};

/// One per face, in their order. @param strip  as the constructor of Facet takes it; by default that of the faces
std::vector<Facet> make_facets(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces, const Strip& strip);
std::vector<Facet> make_facets(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces);

}  // namespace creepcontact::contact
