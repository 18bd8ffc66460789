#include "creepcontact/contact/geometry/facet.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {
namespace {

constexpr int subdivisions = 4;     // of a curved edge
constexpr double straight = 1e-7;   // of the chord's length: an edge that bulges less
constexpr double min_bend = 1e-10;  // of the diameter

/// 1, x, x^2
Vector3 powers(double x) {
  return {1, x, x * x};
}
Vector3 derivatives(double x) {
  return {0, 1, 2 * x};
}

/// Products a_i b_j at 3 i + j.
Eigen::Matrix<double, 9, 1> products(const Vector3& a, const Vector3& b) {
  Eigen::Matrix<double, 9, 1> result;
  for (Index i = 0; i < 3; ++i) result.segment<3>(3 * i) = a[i] * b;
  return result;
}

/// The face itself, or the strip of an edge: a quadrilateral whose nodes occur on both layers, and in between.
mesh::Face quadrilateral(const mesh::Face& face) {
  const auto& n = face.nodes;
  if (face.type == mesh::CellType::line2) return {mesh::CellType::quad4, {n[0], n[1], n[1], n[0]}};
  if (face.type == mesh::CellType::line3)
    return {mesh::CellType::quad9, {n[0], n[1], n[1], n[0], n[2], n[1], n[2], n[0], n[2]}};
  return face;
}

/// @param face  as quadrilateral() returns it
Facet::Coordinates coordinates(const mesh::Mesh& mesh, const mesh::Face& face, double strip_depth) {
  Facet::Coordinates x(static_cast<int>(face.nodes.size()), 3);
  for (std::size_t i = 0; i < face.nodes.size(); ++i) x.row(i) = mesh.nodes[face.nodes[i]].transpose();
  if (mesh.section.dimension() == 2) x.col(2) += strip_depth / 2 * fem::reference_element(face.type).nodes().col(1);
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

Facet::Facet(const mesh::Mesh& mesh, const mesh::Face& face, const Strip& strip)
    : Facet(quadrilateral(face).type, coordinates(mesh, quadrilateral(face), strip.depth)) {
  nodes_ = quadrilateral(face).nodes;
  strip_ = strip;
}

Facet::Facet(mesh::CellType type, Coordinates x)
    : element_(&fem::reference_element(type)), n_corners_(mesh::n_corners(type)), x_(std::move(x)) {
  corner_element_ = &fem::reference_element(n_corners_ == 3 ? mesh::CellType::tri3 : mesh::CellType::quad4);
  centre_xi_ = n_corners_ == 3 ? Vector3(1.0 / 3, 1.0 / 3, 0) : Vector3(0, 0, 0);
  for (int i = 0; i < n_nodes(); ++i) box_.extend(node_position(i));
  for (int i = 0; i < n_corners_; ++i)
    for (int j = 0; j < i; ++j) diameter_ = std::max(diameter_, (x_.row(i) - x_.row(j)).norm());
  fit_polynomial();
}

// All shape functions are polynomials of degree 2 at most in either coordinate: nine values tell them.
void Facet::fit_polynomial() {
  const Matrix3 from_values = (Matrix3() << 0, 1, 0, -0.5, 0, 0.5, 0.5, -1, 0.5).finished();  // at -1, 0, 1
  ShapeValues shape(n_nodes());
  polynomial_.setZero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      element_->shape(Vector3(i - 1, j - 1, 0), shape);
      polynomial_ += (x_.transpose() * shape) * products(from_values.col(i), from_values.col(j)).transpose();
    }
  double bend = 0;
  for (const int k : {2, 4, 5, 6, 7, 8}) bend = std::max(bend, polynomial_.col(k).norm());
  is_affine_ = bend <= min_bend * diameter_;
}

Vector3 Facet::position(const Vector3& xi) const {
  return polynomial_ * products(powers(xi.x()), powers(xi.y()));
}

std::array<Vector3, 2> Facet::tangents(const Vector3& xi) const {
  return {polynomial_ * products(derivatives(xi.x()), powers(xi.y())),
          polynomial_ * products(powers(xi.x()), derivatives(xi.y()))};
}

Vector3 Facet::area_vector(const Vector3& xi) const {
  const auto [tangent1, tangent2] = tangents(xi);
  return tangent1.cross(tangent2);
}

Polygon Facet::outline(const Plane& plane) const {
  constexpr int n = subdivisions;
  Polygon result;
  for (int e = 0; e < n_corners_; ++e) {  // node n_corners + e lies on the edge from corner e to e + 1
    const Eigen::Vector2d a = plane.project(node_position(e));
    result.push_back(a);
    if (n_nodes() == n_corners_) continue;
    const Eigen::Vector2d b = plane.project(node_position((e + 1) % n_corners_));
    const Eigen::Vector2d chord = b - a;
    const Eigen::Vector2d bulge = plane.project(node_position(n_corners_ + e)) - 0.5 * (a + b);
    if (std::abs(chord.x() * bulge.y() - chord.y() * bulge.x()) <= straight * chord.squaredNorm()) continue;
    // Each part of the parabola bulges by 1/n^2 of the whole; points that much further out keep the area.
    const double further = 2.0 / 3 / (n * (n - 1));
    for (int k = 1; k < n; ++k) {
      const double t = static_cast<double>(k) / n;
      result.emplace_back(a + t * chord + (4 * t * (1 - t) + further) * bulge);
    }
  }
  return result;
}

double Facet::surface_area() const {
  const fem::QuadratureRule& rule = element_->rule();
  double sum = 0;
  for (int q = 0; q < rule.size(); ++q) {
    const Vector3 xi = rule.points.row(q).transpose();
    sum += rule.weights[q] * area_vector(xi).norm() * area_ratio(position(xi));
  }
  return sum;
}

std::vector<Polygon> Facet::pieces(const Plane& plane, bool flipped) const {
  const Polygon edges = outline(plane);
  std::vector<Polygon> result;
  if (static_cast<int>(edges.size()) == n_corners_) {
    result.push_back(edges);
  } else {
    const Eigen::Vector2d middle = plane.project(centre());
    for (std::size_t i = 0; i < edges.size(); ++i) result.push_back({middle, edges[i], edges[(i + 1) % edges.size()]});
  }
  if (flipped)
    for (Polygon& polygon : result) std::reverse(polygon.begin(), polygon.end());
  std::erase_if(result, [](const Polygon& polygon) { return !(area(polygon) > 0); });  // edge-on faces
  return result;
}

bool Facet::unproject(const Plane& plane, const Eigen::Vector2d& p, Vector3& xi) const {
  // Steps this small are squared by the next one, and round-off far from the origin of coordinates stays below them.
  constexpr double step_tolerance = 1e-9;
  constexpr double max_reference_distance = 10;
  for (int iteration = 0; iteration < 25; ++iteration) {
    const Eigen::Vector2d residual = plane.project(position(xi)) - p;
    const auto [tangent1, tangent2] = tangents(xi);
    Eigen::Matrix2d jacobian;
    jacobian << plane.project_direction(tangent1), plane.project_direction(tangent2);
    const Eigen::Vector2d step = jacobian.inverse() * residual;
    if (!step.allFinite()) return false;
    xi.head<2>() -= step;
    if (step.norm() < step_tolerance) return true;
    if (xi.head<2>().norm() > max_reference_distance) return false;
  }
  return false;
}

bool Facet::meet_line(const Vector3& origin, const Vector3& direction, Vector3& xi) const {
  return unproject(Plane::through(origin, direction), Eigen::Vector2d::Zero(), xi);
}

Strip strip_of(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces) {
  if (mesh.section.dimension() == 3) return {};
  double length = 0;
  for (const mesh::Face& face : faces) length += (mesh.nodes[face.nodes[1]] - mesh.nodes[face.nodes[0]]).norm();
  return {length / static_cast<double>(faces.size()), mesh.section};
}

std::vector<Facet> make_facets(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces, const Strip& strip) {
  std::vector<Facet> facets;
  facets.reserve(faces.size());
  for (const mesh::Face& face : faces) facets.emplace_back(mesh, face, strip);
  return facets;
}

std::vector<Facet> make_facets(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces) {
  return make_facets(mesh, faces, strip_of(mesh, faces));
}

}  // namespace creepcontact::contact
