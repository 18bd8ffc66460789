#include "contact_geometry.hpp"

#include <algorithm>

#include "smooth_facet.hpp"

namespace creepcontact::contact {
namespace {

constexpr double min_displacement = 1e-8;  // of the motion's largest, and of a displacement's own length
constexpr double along_normal = 0.7;       // cosine: such a motion opens or closes the contact, it does not slide

std::vector<Facet> smooth(const std::vector<Facet>& facets, const SurfaceNormals& normals) {
  std::vector<Facet> result;
  result.reserve(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) result.push_back(smooth_facet(facets[f], normals.normal_of_node[f]));
  return result;
}

/// Far beyond its edges a face says nothing of the surface.
bool is_near_facet(const Facet& facet, const Vector3& xi) {
  constexpr double outside = 0.5;
  if (facet.n_corners() == 3) return xi.x() > -outside && xi.y() > -outside && xi.x() + xi.y() < 1 + outside;
  return std::max(std::abs(xi.x()), std::abs(xi.y())) < 1 + 2 * outside;
}

/// Point near `xi` where the line meets the facet; `xi` itself where it meets it nowhere near.
Vector3 met(const Facet& facet, const Vector3& origin, const Vector3& direction, const Vector3& xi) {
  Vector3 found = xi;
  return facet.meet_line(origin, direction, found) && is_near_facet(facet, found) ? found : xi;
}

}  // namespace

ContactGeometry::ContactGeometry(const std::vector<Facet>& slave, const SurfaceNormals& slave_normals,
                                 const std::vector<Facet>& master, const SurfaceNormals& master_normals,
                                 std::span<const mechanics::RigidMotion> sliding)
    : slave_(slave),
      master_(master),
      slave_normals_(slave_normals),
      smooth_slave_(smooth(slave, slave_normals)),
      smooth_master_(smooth(master, master_normals)) {
  for (const mechanics::RigidMotion& motion : sliding) {
    double largest = 0;
    for (const Facet& facet : slave)
      for (int i = 0; i < facet.n_nodes(); ++i)
        largest = std::max(largest, motion.displacement(facet.node_position(i)).norm());
    sliding_.push_back({motion, min_displacement * largest});
  }
}

std::vector<ContactPoint> ContactGeometry::points(std::size_t slave_facet, const Segment& segment) const {
  const Facet& slave = slave_[slave_facet];
  const Facet& master = master_[segment.master];
  std::vector<ContactPoint> result;
  result.reserve(segment.points.size());
  for (const SegmentPoint& at : segment.points) {
    ContactPoint point{at.slave_xi, at.master_xi, slave.position(at.slave_xi), {}, at.weight, 0};
    point.normal = normal_at(slave_facet, at.slave_xi, point.on_slave);
    point.master_xi = met(master, point.on_slave, point.normal, at.master_xi);
    point.gap = gap(slave_facet, segment.master, point);
    result.push_back(point);
  }
  return result;
}

Vector3 ContactGeometry::normal_at(std::size_t slave_facet, const Vector3& xi, const Vector3& x) const {
  const Facet& facet = slave_[slave_facet];
  ShapeValues shape(facet.n_nodes());
  facet.element().shape(xi, shape);
  Vector3 normal = Vector3::Zero();
  for (int j = 0; j < facet.n_nodes(); ++j) normal += shape[j] * slave_normals_.normal_of_node[slave_facet][j];
  normal.normalize();
  std::vector<Vector3> directions;
  for (const Sliding& sliding : sliding_) {
    const Vector3 displacement = sliding.motion.displacement(x);
    Vector3 rest = displacement;
    for (int pass = 0; pass < 2; ++pass)  // once more: the first pass leaves round-off of the size of what it took away
      for (const Vector3& direction : directions) rest -= direction.dot(rest) * direction;
    if (rest.norm() <= std::max(sliding.least, min_displacement * displacement.norm())) continue;
    rest.normalize();
    if (std::abs(rest.dot(normal)) < along_normal) directions.push_back(rest);
  }
  for (int pass = 0; pass < (directions.empty() ? 0 : 2); ++pass) {
    for (const Vector3& direction : directions) normal -= direction.dot(normal) * direction;
    normal.normalize();
  }
  return normal;
}

double ContactGeometry::gap(std::size_t slave_facet, std::size_t master_facet, const ContactPoint& point) const {
  const auto position = [&](const Facet& facet, const Facet& smooth, const Vector3& xi) {
    const bool is_itself = smooth.n_nodes() == facet.n_nodes();
    return smooth.position(is_itself ? xi : met(smooth, point.on_slave, point.normal, xi));
  };
  const Vector3 on_slave = position(slave_[slave_facet], smooth_slave_[slave_facet], point.slave_xi);
  const Vector3 on_master = position(master_[master_facet], smooth_master_[master_facet], point.master_xi);
  return point.normal.dot(on_master - on_slave);
}

}  // namespace creepcontact::contact
