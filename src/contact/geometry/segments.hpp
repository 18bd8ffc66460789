#pragma once
/// Integration over the parts of a slave facet that lie opposite to master facets.

#include <vector>

#include "creepcontact/contact/geometry/facet.hpp"
#include "creepcontact/mesh/box_tree.hpp"

namespace creepcontact::contact {

/// One quadrature point of a segment.
struct SegmentPoint {
  Vector3 slave_xi;
  Vector3 master_xi;  ///< opposite to it along the normal of the slave facet's plane
  double weight = 0;  ///< slave surface area that belongs to it
};

/// What one master facet covers of one slave facet.
struct Segment {
  std::size_t master = 0;  ///< index of the facet
  std::vector<SegmentPoint> points;
};

/// Candidate lookup and cutting for one pair of surfaces, which must outlive it.
class Segmentation {
 public:
  Segmentation(const std::vector<Facet>& slave, const std::vector<Facet>& master);

  /// All segments of a slave facet, each point opposite to the nearest master facet. Facets whose normals do not oppose
  /// each other, or that are further apart than a few facet diameters, do not see each other; facets without area see
  /// nothing.
  std::vector<Segment> segments(std::size_t slave_facet) const;
  /// Part of a slave facet's area, 0 to 1, that master facets cover in projection. Integrates nothing.
  double covered_part(std::size_t slave_facet) const;

 private:
  /// A slave facet as its plane sees it.
  struct Outline {
    Plane plane;
    std::vector<Polygon> pieces;  // none: the facet has no area, or is seen edge-on
    double area = 0;
  };

  Outline outline(const Facet& slave) const;
  std::vector<std::size_t> candidates(const Facet& slave, const Plane& plane) const;
  /// @param work  called with each polygon that both facets share, and whether it is one of the pieces of a face with
  ///   curved edges
  template <typename Work>
  void cut(const Outline& outline, const Facet& master, const Work& work) const;
  /// Where masters lie one behind the other, only the nearest is kept.
  void keep_nearest(const Facet& slave, const Plane& plane, std::vector<Segment>& segments) const;
  void integrate(const Facet& slave, const Plane& plane, const Facet& master, const Polygon& overlap,
                 const fem::QuadratureRule& rule, std::vector<SegmentPoint>& points) const;
  /// Opposite points of the two facets at p; what lies too far along the normal is another part of the body's skin.
  bool find_points(const Facet& slave, const Plane& plane, const Facet& master, const Eigen::Vector2d& p,
                   SegmentPoint& point) const;

  const std::vector<Facet>& slave_;
  const std::vector<Facet>& master_;
  double reach_ = 0;
  mesh::BoxTree master_boxes_;
};

}  // namespace creepcontact::contact
