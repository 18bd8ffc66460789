#include "creepcontact/contact/geometry/facing_points.hpp"

#include <algorithm>

#include "segments.hpp"

namespace creepcontact::contact {
namespace {

/// A face turned by some sectors, and the face of the mesh that it is.
void append_turned(const std::vector<Facet>& own, const Sector& sector, int sectors, std::vector<Facet>& facets,
                   std::vector<std::size_t>& own_of) {
  for (std::size_t f = 0; f < own.size(); ++f) {
    Facet::Coordinates x(own[f].n_nodes(), 3);
    for (int i = 0; i < own[f].n_nodes(); ++i) x.row(i) = sector.turned(own[f].node_position(i), sectors).transpose();
    facets.emplace_back(own[f].element().type(), std::move(x));
    own_of.push_back(f);
  }
}

ShapeValues shape_values(const fem::ReferenceElement& element, const Vector3& xi) {
  Eigen::VectorXd shape(element.n_nodes());
  element.shape(xi, shape);
  return shape;
}

}  // namespace

std::vector<FacingFaces> facing_faces(const mesh::Mesh& first, const std::vector<mesh::Face>& first_faces,
                                      const mesh::Mesh& second, const std::vector<mesh::Face>& second_faces,
                                      const std::optional<Sector>& sector) {
  const Strip strip = strip_of(first, first_faces);
  const std::vector<Facet> slaves = make_facets(first, first_faces, strip);
  const std::vector<Facet> own = make_facets(second, second_faces, strip);
  std::vector<Facet> masters = own;
  std::vector<std::size_t> own_of(own.size());
  for (std::size_t f = 0; f < own.size(); ++f) own_of[f] = f;
  if (sector)
    for (const int n : sector->neighbours()) append_turned(own, *sector, n, masters, own_of);
  const Segmentation segmentation(slaves, masters);
  std::vector<FacingFaces> result;
  for (std::size_t f = 0; f < slaves.size(); ++f) {
    const Facet& slave = slaves[f];
    for (const Segment& segment : segmentation.segments(f)) {
      const Facet& master = masters[segment.master];
      FacingFaces made;
      made.first_nodes = slave.nodes();
      made.second_nodes = own[own_of[segment.master]].nodes();
      made.size = std::max(slave.diameter(), master.diameter());
      for (const SegmentPoint& point : segment.points) {
        const Vector3 position = slave.position(point.slave_xi);
        made.points.push_back({slave.in_section(position), point.weight, shape_values(slave.element(), point.slave_xi),
                               shape_values(master.element(), point.master_xi),
                               shape_values(slave.corner_element(), point.slave_xi)});
      }
      result.push_back(std::move(made));
    }
  }
  return result;
}

}  // namespace creepcontact::contact
