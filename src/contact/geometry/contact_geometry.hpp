#pragma once
/// Normal, opposite point and gap at the quadrature points of a contact pair.

#include <span>
#include <vector>

#include "creepcontact/contact/geometry/surface_normals.hpp"
#include "creepcontact/mechanics/rigid_motion.hpp"
#include "segments.hpp"

namespace creepcontact::contact {

struct ContactPoint {
  Vector3 slave_xi;
  Vector3
      master_xi;  ///< where the line along `normal` meets the master facet: equal and opposite forces have no moment
  Vector3 on_slave;
  Vector3 normal;
  double weight = 0;
  double gap = 0;  ///< along the normal, between the smooth surfaces that the facets represent
};

/// Geometry of one pair. The facets must outlive it.
class ContactGeometry {
 public:
  /// @param sliding  relative rigid-body modes to which the normals are made perpendicular
  ContactGeometry(const std::vector<Facet>& slave, const SurfaceNormals& slave_normals,
                  const std::vector<Facet>& master, const SurfaceNormals& master_normals,
                  std::span<const mechanics::RigidMotion> sliding);

  std::vector<ContactPoint> points(std::size_t slave_facet, const Segment& segment) const;

 private:
  struct Sliding {
    mechanics::RigidMotion motion;
    double least = 0;  // a displacement below it has no direction
  };

  Vector3 normal_at(std::size_t slave_facet, const Vector3& xi, const Vector3& x) const;
  double gap(std::size_t slave_facet, std::size_t master_facet, const ContactPoint& point) const;

  const std::vector<Facet>& slave_;
  const std::vector<Facet>& master_;
  const SurfaceNormals& slave_normals_;
  std::vector<Sliding> sliding_;
  std::vector<Facet> smooth_slave_, smooth_master_;
};

}  // namespace creepcontact::contact
