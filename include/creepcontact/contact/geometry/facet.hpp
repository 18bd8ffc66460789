#pragma once
/// Geometry of one face of a contact surface: position, normal, projection onto a plane and back.

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/geometry/polygon.hpp"
#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::contact {

using ShapeValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 9, 1>;

/// A plane with two axes; lengths and areas in it are true ones.
struct Plane {
  Vector3 origin, normal, axis1, axis2;

  static Plane through(const Vector3& origin, const Vector3& normal);
  Eigen::Vector2d project(const Vector3& x) const { return {axis1.dot(x - origin), axis2.dot(x - origin)}; }
  Eigen::Vector2d project_direction(const Vector3& d) const { return {axis1.dot(d), axis2.dot(d)}; }
};

/// Face with its nodes' coordinates. Faces are seen from outside their body.
class Facet {
 public:
  using Coordinates = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 9, 3>;

  Facet(const mesh::Mesh& mesh, const mesh::Face& face);
  /// A face that is not one of a mesh: nodes() is empty. @param x  one row a node of `type`
  Facet(mesh::CellType type, Coordinates x);

  const fem::ReferenceElement& element() const { return *element_; }
  /// Linear element on the corners: carries the multipliers.
  const fem::ReferenceElement& corner_element() const { return *corner_element_; }
  const std::vector<std::int64_t>& nodes() const { return nodes_; }
  Index n_nodes() const { return x_.rows(); }
  int n_corners() const { return n_corners_; }
  Vector3 node_position(int i) const { return x_.row(i).transpose(); }

  /// True if positions are linear in the reference coordinates: flat, with straight edges evenly divided.
  bool is_affine() const { return is_affine_; }

  Vector3 position(const Vector3& xi) const;
  /// Normal times the surface Jacobian |dx/dxi1 x dx/dxi2|.
  Vector3 area_vector(const Vector3& xi) const;
  const Vector3& centre_xi() const { return centre_xi_; }
  Vector3 centre() const { return position(centre_xi_); }
  Vector3 area_vector_at_centre() const { return area_vector(centre_xi_); }
  /// By the element's own rule.
  double surface_area() const;
  /// Longest distance between two corners.
  double diameter() const { return diameter_; }
  const Eigen::AlignedBox3d& box() const { return box_; }

  /// The face as straight-edged convex pieces, projected; counter-clockwise seen against the plane's normal.
  /// One piece where the face's edges project to straight lines, else triangles about its centre, whose outer edges
  /// keep the area under every curved edge.
  /// @param flipped  true for a face seen from behind (the master, whose normal opposes the plane's)
  std::vector<Polygon> pieces(const Plane& plane, bool flipped) const;

  /// Reference coordinates of the point that projects onto p, by Newton's method. The face goes on beyond its edges.
  /// @param xi  start of the iteration; the point if one was found @returns false if there is none
  bool unproject(const Plane& plane, const Eigen::Vector2d& p, Vector3& xi) const;
  /// The same for the point where the line from `origin` along `direction` meets the face.
  bool meet_line(const Vector3& origin, const Vector3& direction, Vector3& xi) const;

 private:
  /// Coefficients of xi1^a xi2^b, a, b = 0, 1, 2: one column each, and those of the derivatives.
  using Polynomial = Eigen::Matrix<double, 3, 9>;

  void fit_polynomial();
  std::array<Vector3, 2> tangents(const Vector3& xi) const;
  /// Corners and, on curved edges, points between them.
  Polygon outline(const Plane& plane) const;

  const fem::ReferenceElement* element_;
  const fem::ReferenceElement* corner_element_;
  std::vector<std::int64_t> nodes_;
  int n_corners_;
  Coordinates x_;
  Polynomial polynomial_;
  bool is_affine_ = false;
  Vector3 centre_xi_;
  double diameter_ = 0;
  Eigen::AlignedBox3d box_;
};

std::vector<Facet> make_facets(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces);

}  // namespace creepcontact::contact
