#pragma once
/// Integration over the parts of a slave facet that lie opposite to master facets.

#include <vector>

#include "creepcontact/contact/facet.hpp"

namespace creepcontact::contact {

/// One quadrature point of a segment.
struct SegmentPoint {
  Vector3 slave_xi, master_xi;
  double weight = 0;  ///< slave surface area that belongs to it
};

/// What one master facet covers of one slave facet.
struct Segment {
  std::size_t master = 0;  ///< index of the facet
  std::vector<SegmentPoint> points;
};

/// Candidate lookup and cutting for one pair of surfaces.
class Segmentation {
 public:
  Segmentation(const std::vector<Facet>& slave, const std::vector<Facet>& master);

  /// All segments of a slave facet. Facets whose normals do not oppose each other, or that are further apart than a few
  /// facet diameters, do not see each other.
  std::vector<Segment> segments(std::size_t slave_facet) const;
  /// Indices of the master facets that a slave facet overlaps in projection.
  std::vector<std::size_t> partners(std::size_t slave_facet) const;

 private:
  void cut(const Facet& slave, const Plane& plane, const std::vector<Polygon>& slave_pieces, const Facet& master,
           std::vector<SegmentPoint>& points) const;
  bool may_touch(const Facet& slave, const Facet& master) const;

  const std::vector<Facet>& slave_;
  const std::vector<Facet>& master_;
  double reach_ = 0;
};

}  // namespace creepcontact::contact
