#include "segments.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace creepcontact::contact {
namespace {

constexpr double max_distance_in_diameters = 3.0;
constexpr double bulge_in_diameters = 0.25;  // of a curved face beyond the box of its nodes
constexpr double min_segment_area = 1e-12;   // of the slave facet's area
constexpr double min_area = 1e-10;           // of the squared diameter
constexpr double covered_twice = 1.001;      // more of a facet's area: masters lie one behind the other
constexpr double edge_on_cosine = 0.05;      // the surface bends away from the facet's plane

/// How the overlap of two pieces is integrated: products of two shape functions and a hat.
const fem::QuadratureRule& segment_rule(const Facet& slave, const Facet& master, bool in_pieces) {
  static const fem::QuadratureRule exact = fem::triangle(6);  // where shape functions are polynomials of the place
  static const fem::QuadratureRule fine = fem::triangle(8);   // where they are rational functions
  static const fem::QuadratureRule of_pieces = fem::triangle(5);
  if (in_pieces) return of_pieces;
  return slave.is_affine() && master.is_affine() ? exact : fine;
}

std::vector<Eigen::AlignedBox3d> boxes(const std::vector<Facet>& facets) {
  std::vector<Eigen::AlignedBox3d> result;
  result.reserve(facets.size());
  for (const Facet& facet : facets) result.push_back(facet.box());
  return result;
}

Eigen::Vector2d mean(const Polygon& polygon) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : polygon) sum += corner;
  return sum / static_cast<double>(polygon.size());
}

}  // namespace

Segmentation::Segmentation(const std::vector<Facet>& slave, const std::vector<Facet>& master)
    : slave_(slave), master_(master), master_boxes_(boxes(master)) {
  double longest = 0;
  for (const auto* side : {&slave, &master})
    for (const Facet& facet : *side) longest = std::max(longest, facet.diameter());
  reach_ = max_distance_in_diameters * longest;
}

Segmentation::Outline Segmentation::outline(const Facet& slave) const {
  const Vector3 area_vector = slave.area_vector_at_centre();
  if (!(area_vector.norm() > min_area * slave.diameter() * slave.diameter())) return {};
  Outline result{Plane::through(slave.centre(), area_vector), {}, 0};
  result.pieces = slave.pieces(result.plane, false);
  for (const Polygon& piece : result.pieces) result.area += area(piece);
  return result;
}

std::vector<std::size_t> Segmentation::candidates(const Facet& slave, const Plane& plane) const {
  const Vector3 margin = Vector3::Constant(bulge_in_diameters * reach_ / max_distance_in_diameters);
  Eigen::AlignedBox3d column = slave.box();
  column.extend(slave.box().translated(reach_ * plane.normal)).extend(slave.box().translated(-reach_ * plane.normal));
  return master_boxes_.meeting({column.min() - margin, column.max() + margin});
}

std::vector<Segment> Segmentation::segments(std::size_t slave_facet) const {
  const Facet& slave = slave_[slave_facet];
  const Outline seen = outline(slave);
  std::vector<Segment> result;
  if (seen.pieces.empty()) return result;
  for (const std::size_t m : candidates(slave, seen.plane)) {
    Segment segment{m, {}};
    cut(seen, master_[m], [&](const Polygon& overlap, bool in_pieces) {
      integrate(slave, seen.plane, master_[m], overlap, segment_rule(slave, master_[m], in_pieces), segment.points);
    });
    if (!segment.points.empty()) result.push_back(std::move(segment));
  }
  double covered = 0;
  for (const Segment& segment : result)
    for (const SegmentPoint& point : segment.points) covered += point.weight;
  if (covered > covered_twice * slave.surface_area()) keep_nearest(slave, seen.plane, result);
  return result;
}

void Segmentation::keep_nearest(const Facet& slave, const Plane& plane, std::vector<Segment>& segments) const {
  const auto distance = [&](const Facet& master, const SegmentPoint& point) {
    return std::abs(plane.normal.dot(master.position(point.master_xi) - slave.position(point.slave_xi)));
  };
  const auto is_inside = [](const Facet& facet, const Vector3& xi) {
    constexpr double margin = 1e-9;
    if (facet.n_corners() == 3) return xi.x() > margin && xi.y() > margin && xi.x() + xi.y() < 1 - margin;
    return std::abs(xi.x()) < 1 - margin && std::abs(xi.y()) < 1 - margin;
  };
  const double same = 1e-6 * slave.diameter();
  std::vector<Segment> nearest;
  for (const Segment& segment : segments) {
    Segment kept{segment.master, {}};
    for (const SegmentPoint& point : segment.points) {
      const double own = distance(master_[segment.master], point);
      const Eigen::Vector2d p = plane.project(slave.position(point.slave_xi));
      const bool hidden = std::any_of(segments.begin(), segments.end(), [&](const Segment& other) {
        SegmentPoint opposite;
        return other.master != segment.master && find_points(slave, plane, master_[other.master], p, opposite) &&
               is_inside(master_[other.master], opposite.master_xi) &&
               distance(master_[other.master], opposite) < own - same;
      });
      if (!hidden) kept.points.push_back(point);
    }
    if (!kept.points.empty()) nearest.push_back(std::move(kept));
  }
  segments = std::move(nearest);
}

double Segmentation::covered_part(std::size_t slave_facet) const {
  const Facet& slave = slave_[slave_facet];
  const Outline seen = outline(slave);
  if (seen.pieces.empty()) return 0;
  double covered = 0;
  for (const std::size_t m : candidates(slave, seen.plane))
    cut(seen, master_[m], [&](const Polygon& overlap, bool) {
      SegmentPoint point;
      if (find_points(slave, seen.plane, master_[m], mean(overlap), point)) covered += area(overlap);
    });
  return covered / seen.area;
}

template <typename Work>
void Segmentation::cut(const Outline& outline, const Facet& master, const Work& work) const {
  if (!(master.area_vector_at_centre().dot(outline.plane.normal) < 0)) return;
  const std::vector<Polygon> master_pieces = master.pieces(outline.plane, true);
  const bool in_pieces = outline.pieces.size() + master_pieces.size() > 2;
  Polygon overlap, scratch;
  for (const Polygon& a : outline.pieces)
    for (const Polygon& b : master_pieces) {
      clip(a, b, overlap, scratch);
      if (overlap.empty() || area(overlap) < min_segment_area * outline.area) continue;
      work(overlap, in_pieces);
    }
}

void Segmentation::integrate(const Facet& slave, const Plane& plane, const Facet& master, const Polygon& overlap,
                             const fem::QuadratureRule& rule, std::vector<SegmentPoint>& points) const {
  const Eigen::Vector2d& corner = overlap[0];
  for (std::size_t i = 1; i + 1 < overlap.size(); ++i) {
    const Eigen::Vector2d side1 = overlap[i] - corner;
    const Eigen::Vector2d side2 = overlap[i + 1] - corner;
    const double twice_area = side1.x() * side2.y() - side1.y() * side2.x();
    if (!(twice_area > 0)) continue;
    for (int q = 0; q < rule.size(); ++q) {
      SegmentPoint point;
      if (!find_points(slave, plane, master, corner + rule.points(q, 0) * side1 + rule.points(q, 1) * side2, point))
        continue;
      const double cosine = slave.area_vector(point.slave_xi).normalized().dot(plane.normal);
      if (cosine < edge_on_cosine) continue;
      point.weight = rule.weights[q] * twice_area / cosine * slave.area_ratio(slave.position(point.slave_xi));
      points.push_back(point);
    }
  }
}

bool Segmentation::find_points(const Facet& slave, const Plane& plane, const Facet& master, const Eigen::Vector2d& p,
                               SegmentPoint& point) const {
  point.slave_xi = slave.centre_xi();
  point.master_xi = master.centre_xi();
  if (!slave.unproject(plane, p, point.slave_xi) || !master.unproject(plane, p, point.master_xi)) return false;
  return std::abs(plane.normal.dot(master.position(point.master_xi) - slave.position(point.slave_xi))) <= reach_;
}

}  // namespace creepcontact::contact
