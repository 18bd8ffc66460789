#include "creepcontact/contact/segments.hpp"

#include <algorithm>
#include <cmath>

namespace creepcontact::contact {
namespace {

constexpr double reach_in_diameters = 3.0;
constexpr double smallest_segment = 1e-12;  // of the slave facet's area

/// Exact for the product of two quadratic shape functions and a linear hat on a flat triangle.
const fem::QuadratureRule& segment_rule() {
  static const fem::QuadratureRule rule = fem::triangle(6);
  return rule;
}

}  // namespace

Segmentation::Segmentation(const std::vector<Facet>& slave, const std::vector<Facet>& master)
    : slave_(slave), master_(master) {
  double longest = 0;
  for (const auto* side : {&slave, &master})
    for (const Facet& facet : *side) longest = std::max(longest, facet.diameter());
  reach_ = reach_in_diameters * longest;
}

bool Segmentation::may_touch(const Facet& slave, const Facet& master) const {
  return slave.box().exteriorDistance(master.box()) <= reach_;
}

std::vector<Segment> Segmentation::segments(std::size_t slave_facet) const {
  const Facet& slave = slave_[slave_facet];
  const Plane plane = Plane::through(slave.centre(), slave.area_vector_at_centre());
  const std::vector<Polygon> pieces = slave.pieces(plane, false);

  std::vector<Segment> result;
  for (std::size_t m = 0; m < master_.size(); ++m) {
    if (!may_touch(slave, master_[m])) continue;
    Segment segment{m, {}};
    cut(slave, plane, pieces, master_[m], segment.points);
    if (!segment.points.empty()) result.push_back(std::move(segment));
  }
  return result;
}

std::vector<std::size_t> Segmentation::partners(std::size_t slave_facet) const {
  std::vector<std::size_t> result;
  for (const Segment& segment : segments(slave_facet)) result.push_back(segment.master);
  return result;
}

void Segmentation::cut(const Facet& slave, const Plane& plane, const std::vector<Polygon>& slave_pieces,
                       const Facet& master, std::vector<SegmentPoint>& points) const {
  if (master.area_vector_at_centre().dot(plane.normal) >= 0) return;
  const std::vector<Polygon> master_pieces = master.pieces(plane, true);

  const fem::QuadratureRule& rule = segment_rule();
  double slave_area = 0;
  for (const Polygon& piece : slave_pieces) slave_area += area(piece);
  Polygon overlap, work;
  for (const Polygon& a : slave_pieces)
    for (const Polygon& b : master_pieces) {
      clip(a, b, overlap, work);
      if (overlap.empty() || area(overlap) < smallest_segment * slave_area) continue;
      Eigen::Vector2d middle = Eigen::Vector2d::Zero();
      for (const Eigen::Vector2d& corner : overlap) middle += corner / static_cast<double>(overlap.size());
      for (std::size_t i = 0; i < overlap.size(); ++i) {
        const Eigen::Vector2d side1 = overlap[i] - middle;
        const Eigen::Vector2d side2 = overlap[(i + 1) % overlap.size()] - middle;
        const double twice_area = side1.x() * side2.y() - side1.y() * side2.x();
        if (twice_area <= 0) continue;
        for (int q = 0; q < rule.size(); ++q) {
          const Eigen::Vector2d p = middle + rule.points(q, 0) * side1 + rule.points(q, 1) * side2;
          SegmentPoint point;
          if (!slave.unproject(plane, p, point.slave_xi) || !master.unproject(plane, p, point.master_xi)) continue;
          const double cosine = slave.area_vector(point.slave_xi).normalized().dot(plane.normal);
          if (cosine <= 0) continue;
          point.weight = rule.weights[q] * twice_area / cosine;
          points.push_back(point);
        }
      }
    }
  // What lies too far along the normal is another part of the body's skin.
  std::erase_if(points, [&](const SegmentPoint& point) {
    return std::abs(plane.normal.dot(master.position(point.master_xi) - slave.position(point.slave_xi))) > reach_;
  });
}

}  // namespace creepcontact::contact
