#include "creepcontact/contact/facet.hpp"

#include <algorithm>
#include <cmath>

namespace creepcontact::contact {
namespace {

using Gradient = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 9, 3>;

constexpr int subdivisions = 4;  // of a curved edge: a parabola is then met to 1/64 of its height

/// Straight-edged cells that divide the reference triangle or square, counter-clockwise.
std::vector<std::vector<Vector3>> reference_cells(int n_corners) {
  std::vector<std::vector<Vector3>> cells;
  const int n = subdivisions;
  if (n_corners == 3) {
    const auto at = [](int i, int j) { return Vector3(double(i) / subdivisions, double(j) / subdivisions, 0); };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        cells.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < n) cells.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  } else {
    const auto at = [](int i, int j) { return Vector3(2.0 * i / subdivisions - 1, 2.0 * j / subdivisions - 1, 0); };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {  // two triangles: always convex, however the face is curved
        cells.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        cells.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  return cells;
}

Facet::Coordinates coordinates(const mesh::Mesh& mesh, const mesh::Face& face) {
  Facet::Coordinates x(static_cast<int>(face.nodes.size()), 3);
  for (std::size_t i = 0; i < face.nodes.size(); ++i)
    x.row(static_cast<int>(i)) = mesh.nodes[static_cast<std::size_t>(face.nodes[i])].transpose();
  return x;
}

}  // namespace

Plane Plane::through(const Vector3& origin, const Vector3& normal) {
  Plane plane;
  plane.origin = origin;
  plane.normal = normal.normalized();
  plane.axis1 = plane.normal.unitOrthogonal();
  plane.axis2 = plane.normal.cross(plane.axis1);
  return plane;
}

Facet::Facet(const mesh::Mesh& mesh, const mesh::Face& face) : Facet(face.type, coordinates(mesh, face)) {
  nodes_ = face.nodes;
}

Facet::Facet(mesh::CellType type, Coordinates x)
    : element_(&fem::reference_element(type)), n_corners_(mesh::n_corners(type)), x_(std::move(x)) {
  corner_element_ = &fem::reference_element(n_corners_ == 3 ? mesh::CellType::tri3 : mesh::CellType::quad4);
  centre_xi_ = n_corners_ == 3 ? Vector3(1.0 / 3, 1.0 / 3, 0) : Vector3(0, 0, 0);
  for (int i = 0; i < n_nodes(); ++i) box_.extend(node_position(i));
  for (int i = 0; i < n_corners_; ++i)
    for (int j = 0; j < i; ++j) diameter_ = std::max(diameter_, (x_.row(i) - x_.row(j)).norm());
}

Vector3 Facet::position(const Vector3& xi) const {
  ShapeValues shape(n_nodes());
  element_->shape(xi, shape);
  return x_.transpose() * shape;
}

Vector3 Facet::area_vector(const Vector3& xi) const {
  Gradient gradient(n_nodes(), 3);
  element_->gradient(xi, gradient);
  const Vector3 tangent1 = x_.transpose() * gradient.col(0);
  const Vector3 tangent2 = x_.transpose() * gradient.col(1);
  return tangent1.cross(tangent2);
}

bool Facet::has_curved_edges(const Plane& plane) const {
  if (n_nodes() == n_corners_) return false;
  for (int e = 0; e < n_corners_; ++e) {  // node n_corners + e lies on the edge from corner e to e + 1
    const Eigen::Vector2d a = plane.project(x_.row(e).transpose());
    const Eigen::Vector2d b = plane.project(x_.row((e + 1) % n_corners_).transpose());
    const Eigen::Vector2d middle = plane.project(x_.row(n_corners_ + e).transpose());
    const Eigen::Vector2d chord = b - a;
    const Eigen::Vector2d offset = middle - a;
    if (std::abs(chord.x() * offset.y() - chord.y() * offset.x()) > 1e-7 * chord.squaredNorm()) return true;
  }
  return false;
}

std::vector<Polygon> Facet::pieces(const Plane& plane, bool flipped) const {
  std::vector<Polygon> result;
  if (!has_curved_edges(plane)) {
    Polygon polygon;
    for (int i = 0; i < n_corners_; ++i) polygon.push_back(plane.project(x_.row(i).transpose()));
    result.push_back(std::move(polygon));
  } else {
    static const auto triangle_cells = reference_cells(3);
    static const auto square_cells = reference_cells(4);
    for (const auto& cell : n_corners_ == 3 ? triangle_cells : square_cells) {
      Polygon polygon;
      for (const Vector3& xi : cell) polygon.push_back(plane.project(position(xi)));
      result.push_back(std::move(polygon));
    }
  }
  if (flipped)
    for (Polygon& polygon : result) std::reverse(polygon.begin(), polygon.end());
  std::erase_if(result, [](const Polygon& polygon) { return !(area(polygon) > 0); });  // edge-on faces
  return result;
}

bool Facet::unproject(const Plane& plane, const Eigen::Vector2d& p, Vector3& xi) const {
  // Steps this small are squared by the next one, and round-off far from the origin of coordinates stays below them.
  constexpr double small_step = 1e-9;
  constexpr double far_outside = 10;
  ShapeValues shape(n_nodes());
  Gradient gradient(n_nodes(), 3);
  for (int iteration = 0; iteration < 25; ++iteration) {
    element_->shape(xi, shape);
    element_->gradient(xi, gradient);
    const Eigen::Vector2d residual = plane.project(x_.transpose() * shape) - p;
    Eigen::Matrix2d jacobian;
    for (int k = 0; k < 2; ++k) jacobian.col(k) = plane.project_direction(x_.transpose() * gradient.col(k));
    const Eigen::Vector2d step = jacobian.inverse() * residual;
    if (!step.allFinite()) return false;
    xi.head<2>() -= step;
    if (step.norm() < small_step) return true;
    if (xi.head<2>().norm() > far_outside) return false;
  }
  return false;
}

bool Facet::meet_line(const Vector3& origin, const Vector3& direction, Vector3& xi) const {
  return unproject(Plane::through(origin, direction), Eigen::Vector2d::Zero(), xi);
}

std::vector<Facet> make_facets(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces) {
  std::vector<Facet> facets;
  facets.reserve(faces.size());
  for (const mesh::Face& face : faces) facets.emplace_back(mesh, face);
  return facets;
}

}  // namespace creepcontact::contact
