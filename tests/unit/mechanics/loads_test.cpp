/// Resultants of loads, their course in time, and nodal normals.
#include "creepcontact/mechanics/loads.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "creepcontact/base/error.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"

namespace creepcontact::test {
namespace {

using mechanics::Load;

constexpr std::array surfaces{"x0", "x1", "y0", "y1", "z0", "z1"};

/// On the nodes.
std::vector<double> forces_of(Load& load, const mesh::Mesh& mesh, double t = 0.0) {
  std::vector<double> forces(3 * (mesh.nodes.size() + mechanics::Discretization(mesh).n_inner()), 0.0);
  load.add(t, forces);
  forces.resize(3 * mesh.nodes.size());
  return forces;
}

Vector3 moment(const mesh::Mesh& mesh, const std::vector<double>& forces) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) sum += mesh.nodes[i].cross(Vector3::Map(&forces[3 * i]));
  return sum;
}

/// A quarter-ring: radii 1 and 2, angle 0 to 90 degrees, height 1; y becomes the angle.
mesh::Mesh ring_sector(CellType type, std::array<int, 3> divisions) {
  return mapped(box_mesh(type, divisions), [](const Vector3& x) {
    const double angle = std::numbers::pi / 2 * x[1];
    return Vector3((1 + x[0]) * std::cos(angle), (1 + x[0]) * std::sin(angle), x[2]);
  });
}

class SurfaceLoads : public testing::TestWithParam<CellType> {};
INSTANTIATE_TEST_SUITE_P(Types, SurfaceLoads, testing::ValuesIn(mesh::volume_cell_types()),
                         [](const auto& type) { return std::string(mesh::name(type.param)); });

TEST_P(SurfaceLoads, PressureOnAClosedCurvedSurfaceHasNoResultant) {
  const mesh::Mesh body = mapped(box_mesh(GetParam(), {2, 2, 2}), [](const Vector3& x) {
    return Vector3(x[0] + 0.2 * x[1] * x[1], x[1] - 0.1 * x[2] * x[0], x[2] + 0.15 * std::sin(x[0] + x[1]));
  });
  std::vector<mesh::Face> faces;
  for (const auto* surface : surfaces)
    for (mesh::Face& face : mesh::boundary_faces(body, surface)) faces.push_back(std::move(face));
  const auto load = mechanics::pressure_load(body, faces, 3.0);
  const std::vector<double> forces = forces_of(*load, body);
  EXPECT_GT(largest(forces), 0.01);
  EXPECT_LT(resultant(forces).norm(), 1e-14);
  EXPECT_LT(moment(body, forces).norm(), 1e-14);
}

TEST_P(SurfaceLoads, PressureOnABoreActsOnItsProjection) {
  const mesh::Mesh sector = ring_sector(GetParam(), {1, 3, 2});
  const auto load = mechanics::pressure_load(sector, mesh::boundary_faces(sector, "x0"), 2.0);
  EXPECT_LT((resultant(forces_of(*load, sector)) - Vector3(2, 2, 0)).norm(), 1e-13);
}

TEST_P(SurfaceLoads, TractionThatVariesLinearlyIsIntegratedExactly) {
  const mesh::Mesh box = box_mesh(GetParam(), {2, 2, 2}, {1, 2, 3});
  const auto load = mechanics::traction_load(
      box, mesh::boundary_faces(box, "z1"),
      {Function::expression("x + y", {"x", "y"}), 0.0, Function::expression("2*x*t", {"x", "t"})});
  EXPECT_LT((resultant(forces_of(*load, box, 0.0)) - Vector3(3, 0, 0)).norm(), 1e-13);
  EXPECT_LT((resultant(forces_of(*load, box, 2.0)) - Vector3(3, 0, 4)).norm(), 1e-13);
  EXPECT_LT((resultant(forces_of(*load, box, 1.0)) - Vector3(3, 0, 2)).norm(), 1e-13);
  // moment of the first component about the y axis: 3 * integral (x + y); of the third: - integral x * 2 x t
  EXPECT_NEAR(moment(box, forces_of(*load, box, 0.0))[1], 9.0, 1e-12);
}

TEST_P(SurfaceLoads, CentrifugalForceOfASector) {
  const mesh::Mesh box = box_mesh(GetParam(), {3, 2, 2}, {2, 1, 1}, {1, 0, 0}, 0.2);
  const mechanics::Discretization body(box);
  const auto load =
      mechanics::centrifugal_load(body, {0, 0, 5}, {0, 0.5, 100}, Function::expression("3*t", {"t"}), 2.0);
  // density omega^2 integral of (x, y - 1/2): 2 * 9 t^2 * (volume 2 * mean x 2, 0)
  EXPECT_LT((resultant(forces_of(*load, box, 1.0)) - Vector3(72, 0, 0)).norm(), 1e-11);
  EXPECT_LT((resultant(forces_of(*load, box, 2.0)) - Vector3(288, 0, 0)).norm(), 1e-11);
}

TEST_P(SurfaceLoads, VolumeForce) {
  const mesh::Mesh box = box_mesh(GetParam(), {2, 2, 2}, {1, 2, 3}, Vector3::Zero(), 0.2);
  const mechanics::Discretization body(box);
  const auto load = mechanics::volume_load(body, {Function::expression("x*t", {"x", "t"}), 0.0, -4.0});
  EXPECT_LT((resultant(forces_of(*load, box, 2.0)) - Vector3(6, 0, -24)).norm(), 1e-12);
  EXPECT_LT((resultant(forces_of(*load, box, 1.0)) - Vector3(3, 0, -24)).norm(), 1e-12);
}

TEST(Loads, AddToWhatIsThere) {
  const mesh::Mesh box = box_mesh(CellType::hex8, {1, 1, 1});
  const auto load = mechanics::point_load(box, 3, {Function::expression("x + t", {"x", "t"}), 2.0, -1.0});
  std::vector<double> forces(24, 10.0);
  load->add(4.0, forces);
  EXPECT_EQ(forces[9], 10.0 + box.nodes[3][0] + 4.0);
  EXPECT_EQ(forces[10], 12.0);
  EXPECT_EQ(forces[11], 9.0);
  EXPECT_EQ(std::count(forces.begin(), forces.end(), 10.0), 21);
}

TEST(Loads, RefuseAnAxisWithoutDirection) {
  const mesh::Mesh box = box_mesh(CellType::hex8, {1, 1, 1});
  const mechanics::Discretization body(box);
  EXPECT_THROW(mechanics::centrifugal_load(body, Vector3::Zero(), Vector3::Zero(), 1.0, 1.0), ModelError);
}

/// Quadratic faces on a cylinder: the mid-side normals are radial by symmetry, those at corners between two faces too.
TEST(NodalNormals, AreRadialOnACylinder) {
  for (const CellType type : {CellType::hex8, CellType::hex20, CellType::hex27}) {
    const mesh::Mesh sector = ring_sector(type, {1, 4, 1});
    const std::vector<std::int64_t> nodes = mesh::group_nodes(sector, "x1");
    const auto normals = mechanics::nodal_normals(sector, mesh::boundary_faces(sector, "x1"), nodes);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Vector3& x = sector.nodes[nodes[i]];
      if (x[0] < 1e-9 || x[1] < 1e-9) continue;  // edges of the sector: a face on one side only
      EXPECT_LT((normals[i] - Vector3(x[0], x[1], 0) / 2).norm(), 1e-12) << mesh::name(type);
    }
  }
}

TEST(NodalNormals, WeightFacesByTheirArea) {
  const mesh::Mesh box = box_mesh(CellType::hex8, {1, 1, 1}, {2, 1, 1});
  std::vector<mesh::Face> faces = mesh::boundary_faces(box, "x1"), top = mesh::boundary_faces(box, "z1");
  faces.insert(faces.end(), top.begin(), top.end());
  for (std::int64_t node = 0; node < 8; ++node) {
    const Vector3& x = box.nodes[node];
    if (x[0] != 2 || x[2] != 1) continue;
    EXPECT_LT((mechanics::nodal_normals(box, faces, {node})[0] - Vector3(1, 0, 2).normalized()).norm(), 1e-14);
  }
}

TEST(NodalNormals, NameANodeOffTheSurface) {
  const mesh::Mesh box = box_mesh(CellType::hex8, {1, 1, 1});
  const auto faces = mesh::boundary_faces(box, "x1");
  EXPECT_THROW(mechanics::nodal_normals(box, faces, mesh::group_nodes(box, "x0")), ModelError);
}

}  // namespace
}  // namespace creepcontact::test
