// Which facets see each other, and what they share.
#include "../../../src/contact/geometry/segments.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "support/contact/curved_pair.hpp"

namespace creepcontact {
namespace {

using contact::Facet;
using mesh::CellType;

double covered_area(const std::vector<Facet>& slave, const std::vector<Facet>& master) {
  const contact::Segmentation segmentation(slave, master);
  double area = 0;
  for (std::size_t f = 0; f < slave.size(); ++f)
    for (const contact::Segment& segment : segmentation.segments(f))
      for (const contact::SegmentPoint& point : segment.points) area += point.weight;
  return area;
}

std::vector<Facet> facets_of(const test::Part& part) {
  return contact::make_facets(part.mesh, part.surface().faces);
}

TEST(Segments, CoverEveryFacetOnceHoweverTheMeshesLie) {
  for (const CellType type : {CellType::hex8, CellType::tet4, CellType::tet10, CellType::hex20}) {
    const test::Part lower(test::box_mesh(type, {7, 5, 1}, Vector3::Ones(), {0, 0, -1}), "z1");
    const test::Part upper(test::box_mesh(type, {4, 6, 1}, {1, 1, 1}, {0.3, -0.2, 0.1}), "z0");
    EXPECT_NEAR(covered_area(facets_of(lower), facets_of(upper)), 0.7 * 0.8, 1e-12) << mesh::name(type);
    EXPECT_NEAR(covered_area(facets_of(upper), facets_of(lower)), 0.7 * 0.8, 1e-12) << mesh::name(type);
  }
}

TEST(Segments, DoNotDependOnTheOriginOfCoordinates) {
  const Vector3 far(3e3, -5e3, 1e4);
  const test::Part lower(test::box_mesh(CellType::hex20, {4, 3, 1}, Vector3::Ones(), far - Vector3::UnitZ()), "z1");
  const test::Part upper(test::box_mesh(CellType::tet10, {3, 3, 1}, Vector3::Ones(), far), "z0");
  EXPECT_NEAR(covered_area(facets_of(lower), facets_of(upper)), 1.0, 1e-8);
}

// Curved in-plane edges are divided, and must still enclose the facet's area.
TEST(Segments, KeepTheAreaOfFacetsWithCurvedEdges) {
  for (const CellType type : {CellType::hex20, CellType::hex27, CellType::tet10}) {
    const auto bent = [](const Vector3& x) {
      return Vector3(x.x() + 0.15 * x.x() * (1 - x.x()) * x.y(), x.y() - 0.2 * x.x() * x.y() * (1 - x.y()), x.z());
    };
    const test::Part lower(test::mapped(test::box_mesh(type, {3, 2, 1}, Vector3::Ones(), {0, 0, -1}), bent), "z1");
    const test::Part upper(test::box_mesh(type, {2, 2, 1}, Vector3::Ones()), "z0");
    EXPECT_NEAR(covered_area(facets_of(lower), facets_of(upper)), 1.0, 1e-5) << mesh::name(type);
    EXPECT_NEAR(covered_area(facets_of(upper), facets_of(lower)), 1.0, 1e-5) << mesh::name(type);
  }
}

TEST(Segments, PartnersAreThoseThatShareSegments) {
  const test::Part lower(test::box_mesh(CellType::hex8, {6, 6, 1}, Vector3::Ones(), {0, 0, -1}), "z1");
  for (const double height : {0.0, 0.3, 4.0}) {
    const test::Part upper(test::box_mesh(CellType::tet4, {2, 2, 1}, {0.45, 0.6, 1}, {0.1, 0.2, height}), "z0");
    const std::vector<Facet> slave = facets_of(lower), master = facets_of(upper);
    const contact::Segmentation segmentation(slave, master);
    int partners = 0;
    for (std::size_t f = 0; f < slave.size(); ++f) {
      EXPECT_EQ(segmentation.covered_part(f) > 0, !segmentation.segments(f).empty()) << f;
      partners += segmentation.covered_part(f) > 0;
    }
    EXPECT_EQ(partners, height > 1 ? 0 : 4 * 4) << "too far, or those under the smaller box";
  }
}

TEST(Segments, OfMastersOneBehindTheOtherTheNearestIsMet) {
  const test::Part lower(test::box_mesh(CellType::hex8, {2, 2, 1}, Vector3::Ones(), {0, 0, -1}), "z1");
  const test::Part near(test::box_mesh(CellType::hex8, {3, 2, 1}, {1, 1, 0.1}, {0, 0, 0.01}), "z0");
  const test::Part far(test::box_mesh(CellType::hex8, {2, 3, 1}, {1, 1, 0.1}, {0, 0, 0.3}), "z0");
  std::vector<Facet> masters = facets_of(far);
  for (const Facet& facet : facets_of(near)) masters.push_back(facet);
  const std::vector<Facet> slave = facets_of(lower);
  const contact::Segmentation segmentation(slave, masters);
  for (std::size_t f = 0; f < slave.size(); ++f)
    for (const contact::Segment& segment : segmentation.segments(f)) EXPECT_GE(segment.master, facets_of(far).size());
  EXPECT_NEAR(covered_area(slave, masters), 1.0, 1e-12);
}

// Contact on two faces of a block at once, one of them with a face of no area, the other surface seen edge-on by it.
TEST(Segments, SliversAndFacesSeenEdgeOnAreNoError) {
  const test::Part block(test::box_mesh(CellType::hex8, {3, 3, 3}, Vector3::Ones(), {0, 0, -1}), "z1");
  const test::Part cap(test::box_mesh(CellType::tet4, {2, 2, 2}), "z0");
  contact::Surface slave = block.surface(), master = cap.surface();
  for (const mesh::Face& face : mesh::boundary_faces(block.mesh, "x1")) slave.faces.push_back(face);
  for (const mesh::Face& face : mesh::boundary_faces(cap.mesh, "x0")) master.faces.push_back(face);
  for (contact::Surface* side : {&slave, &master}) {
    const mesh::Face first = side->faces.front();
    side->faces.push_back({CellType::tri3, {first.nodes[0], first.nodes[1], first.nodes[1]}});
    side->faces.push_back({CellType::tri3, {first.nodes[0], first.nodes[0], first.nodes[0]}});
  }
  for (const bool swapped : {false, true}) {
    const auto coupling =
        contact::mortar_coupling(swapped ? master : slave, swapped ? slave : master, contact::ContactType::unilateral);
    double area = 0;
    for (int i = 0; i < coupling.n_rows(); ++i) {
      const auto& node = coupling.nodes[i];
      EXPECT_GT(coupling.area[i], 0);
      EXPECT_NEAR(node.normal.norm(), 1, 1e-14);
      area += coupling.area[i];
    }
    EXPECT_NEAR(area, 1.0, 1e-12);
    EXPECT_TRUE(coupling.slave_rows.coeffs().isFinite().all());
    EXPECT_TRUE(coupling.master_rows.coeffs().isFinite().all());
    EXPECT_TRUE(coupling.geometric_gap.allFinite());
  }
  EXPECT_NO_THROW(contact::first_is_better_slave(slave, master));
}

}  // namespace
}  // namespace creepcontact
