// Nodal normals of contact surfaces against the exact ones.
#include "creepcontact/contact/geometry/surface_normals.hpp"

#include <gtest/gtest.h>

#include "support/contact/curved_pair.hpp"

namespace creepcontact {
namespace {

using mesh::CellType;

contact::SurfaceNormals normals_of(const test::Part& part) {
  const contact::Surface surface = part.surface();
  return contact::surface_normals(contact::make_facets(part.mesh, surface.faces), part.constraints);
}

template <typename Exact>
double largest_error(const test::Part& part, const Exact& exact) {
  const contact::Surface surface = part.surface();
  const contact::SurfaceNormals normals = normals_of(part);
  double largest = 0;
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
    for (std::size_t i = 0; i < surface.faces[f].nodes.size(); ++i) {
      const Vector3& x = part.mesh.nodes[surface.faces[f].nodes[i]];
      largest = std::max(largest, (normals.normal_of_node[f][i] - exact(x)).norm());
    }
  return largest;
}

Vector3 radial(const Vector3& x) {
  return Vector3(x.x(), 0, x.z()).normalized();
}

Vector3 from_centre(const Vector3& x) {
  return x.normalized();
}

TEST(SurfaceNormals, AreExactOnCylindersDividedAlongTheirAxis) {
  for (const int layers : {1, 2, 3})
    for (const bool symmetric : {true, false})
      EXPECT_LT(largest_error(test::cylinder({.divisions = {5, layers, 1}, .irregular = 0.4}, symmetric), radial),
                1e-13)
          << layers << " layers, planes of symmetry: " << symmetric;
  for (const CellType type : {CellType::hex8, CellType::tet4})  // long faces
    for (const int n : {16, 24, 40})
      EXPECT_LT(largest_error(test::cylinder({.type = type, .divisions = {n, 2, 1}}), radial), 1e-11)
          << mesh::name(type) << ' ' << n;
  // Inner surface: the normal points to the axis.
  EXPECT_LT(largest_error(test::cylinder({.divisions = {5, 2, 1}, .is_inner = false}),
                          [](const Vector3& x) { return Vector3(-radial(x)); }),
            1e-13);
}

TEST(SurfaceNormals, SlopesThatMeetASupportedPlaneObliquelyStayStraight) {
  for (const CellType type : {CellType::hex8, CellType::tet10, CellType::hex20})
    for (const double slope : {0.1, 0.3, 1.0}) {
      const mesh::Mesh box = test::box_mesh(type, {3, 2, 1});
      const test::Part part(
          test::mapped(box, [&](const Vector3& x) { return Vector3(x.x(), x.y(), x.z() + slope * x.x()); }), "z1",
          {{"x0", Vector3::UnitX()}, {"y0", Vector3::UnitY()}});
      EXPECT_LT(largest_error(part, [&](const Vector3&) { return Vector3(-slope, 0, 1).normalized(); }), 1e-12)
          << mesh::name(type) << ' ' << slope;
    }
}

TEST(SurfaceNormals, AreExactOnSpheresOfLinearFacesUpToTheOpenCorners) {
  for (const CellType type : {CellType::hex8, CellType::tet4, CellType::wedge6})
    for (const bool symmetric : {true, false})
      EXPECT_LT(
          largest_error(test::sphere({.type = type, .divisions = {5, 4, 1}, .irregular = 0.3}, symmetric), from_centre),
          1e-13)
          << mesh::name(type) << ", planes of symmetry: " << symmetric;
}

TEST(SurfaceNormals, AreOfSecondOrderOnQuadraticFaces) {
  for (const CellType type : {CellType::tet10, CellType::hex20, CellType::hex27})
    for (const bool spherical : {false, true}) {
      const auto error = [&](int n) {
        const test::Shell shell{.type = type, .divisions = {2 * n, n, 1}, .irregular = 0.2};
        return spherical ? largest_error(test::sphere(shell), from_centre)
                         : largest_error(test::cylinder(shell), radial);
      };
      const double coarse = error(8), fine = error(16);
      EXPECT_GT(std::log2(coarse / fine), 1.8) << mesh::name(type) << " sphere " << spherical;
      EXPECT_LT(fine, 2e-3);
    }
}

// On a saddle-like surface, with open edges all round, triangles and quadrilaterals divided unevenly.
TEST(SurfaceNormals, AreOfSecondOrderOnAnySmoothSurfaceUpToTheOpenEdges) {
  const auto height = [](double x, double y) { return 0.3 * x * x - 0.2 * y * y + 0.2 * x * y + 0.1 * x * x * x; };
  for (const CellType type : {CellType::hex8, CellType::tet4}) {
    const auto error = [&](int n) {
      const test::Part part(
          test::mapped(test::box_mesh(type, {n, n, 1}),
                       [&](const Vector3& x) { return Vector3(x.x(), x.y(), x.z() + height(x.x(), x.y())); }),
          "z1");
      return largest_error(part, [](const Vector3& x) {
        return Vector3(-0.6 * x.x() - 0.2 * x.y() - 0.3 * x.x() * x.x(), 0.4 * x.y() - 0.2 * x.x(), 1).normalized();
      });
    };
    const double coarse = error(8), fine = error(16);
    EXPECT_GT(std::log2(coarse / fine), 1.8) << mesh::name(type) << ": " << coarse << ", " << fine;
  }
}

TEST(SurfaceNormals, ArePlaneOnPlanesAndSplitAtCreases) {
  const mesh::Mesh box = test::box_mesh(CellType::hex8, {3, 2, 2});
  const test::Part top(box, "z1");
  EXPECT_LT(largest_error(top, [](const Vector3&) { return Vector3::UnitZ(); }), 1e-15);
  std::vector<mesh::Face> faces = mesh::boundary_faces(box, "z1");
  for (const mesh::Face& face : mesh::boundary_faces(box, "x1")) faces.push_back(face);
  const auto normals = contact::surface_normals(contact::make_facets(box, faces), top.constraints);
  EXPECT_EQ(normals.multipliers.size(), 4u * 3 + 3 * 3) << "the edge's nodes have a multiplier on either side";
  for (const contact::MultiplierNode& node : normals.multipliers) EXPECT_NEAR(node.normal.maxCoeff(), 1.0, 1e-15);
}

TEST(SurfaceNormals, FacesWithoutAreaTakeTheNormalOfTheirNeighbours) {
  mesh::Mesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}};
  const std::vector<mesh::Face> faces{{CellType::tri3, {3, 2, 4}},  // its three nodes on one line
                                      {CellType::tri3, {0, 1, 2}},
                                      {CellType::tri3, {0, 2, 3}}};
  const mechanics::Constraints free(mesh.nodes, {});
  const auto normals = contact::surface_normals(contact::make_facets(mesh, faces), free);
  EXPECT_EQ(normals.multipliers.size(), 5u);
  for (const contact::MultiplierNode& node : normals.multipliers)
    EXPECT_LT((node.normal - Vector3::UnitZ()).norm(), 1e-14);
}

}  // namespace
}  // namespace creepcontact
