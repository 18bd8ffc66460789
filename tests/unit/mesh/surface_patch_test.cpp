/// Simple surfaces are told from their facets, and surfaces of two bodies find each other.
#include "creepcontact/mesh/surface_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace creepcontact::mesh {
namespace surface_patch_tests {
namespace {

using std::numbers::pi;

/// Facets of a surface over two parameters from 0 to 1, in n x m strips. @param outward  turns the normals
std::vector<Facet> facets(const std::function<Vector3(double, double)>& x, int n, int m, bool outward = true) {
  std::vector<Facet> result;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const auto at = [&](int a, int b) { return x((i + a) / double(n), (j + b) / double(m)); };
      const Facet one{{at(0, 0), at(1, 0), at(1, 1)}}, other{{at(0, 0), at(1, 1), at(0, 1)}};
      for (Facet facet : {one, other}) {
        if (!outward) std::swap(facet.corners[1], facet.corners[2]);
        result.push_back(facet);
      }
    }
  return result;
}

const Vector3 origin{3, -2, 7};
const Matrix3 turn = Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()).toRotationMatrix();

Vector3 placed(double x, double y, double z) {
  return origin + turn * Vector3(x, y, z);
}

std::function<Vector3(double, double)> cylinder(double radius, double length, double angle) {
  return [=](double u, double v) {
    return placed(radius * std::cos(angle * u), radius * std::sin(angle * u), length * (v - 0.5));
  };
}

void expect_axis(const SurfaceShape& shape) {
  EXPECT_NEAR(std::abs(shape.axis.dot(turn.col(2))), 1, 1e-7);
}

TEST(SurfaceShape, OfAPlaneHasTheNormalOfItsFacets) {
  const SurfaceShape shape = fit_shape(facets([](double u, double v) { return placed(10 * u, 4 * v, 2); }, 3, 2));
  EXPECT_EQ(shape.kind, ShapeKind::plane);
  EXPECT_NEAR(shape.axis.dot(turn.col(2)), 1, 1e-9);
}

TEST(SurfaceShape, OfCylindersWhateverTheirArcAndSide) {
  for (const double angle : {2 * pi, pi / 2, pi / 8})
    for (const bool outward : {true, false})
      for (const int strips : {1, 3}) {
        const SurfaceShape shape = fit_shape(facets(cylinder(8, 20, angle), angle > 3 ? 24 : 6, strips, outward));
        ASSERT_EQ(shape.kind, ShapeKind::cylinder) << angle << ", " << strips << ": " << name_of(shape.kind);
        EXPECT_NEAR(shape.radius, 8, 1e-5);
        EXPECT_EQ(shape.is_hollow, !outward);
        expect_axis(shape);
        EXPECT_NEAR((shape.center - origin).norm(), 0, 1e-4) << "the middle of its length";
      }
}

TEST(SurfaceShape, OfACone) {
  const SurfaceShape shape = fit_shape(facets(
      [](double u, double v) {
        const double r = 6 - 3 * v;
        return placed(r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), 10 * v);
      },
      24, 4));
  ASSERT_EQ(shape.kind, ShapeKind::cone);
  EXPECT_NEAR(shape.radius, 6, 1e-5);
  EXPECT_NEAR(shape.minor_radius, 3, 1e-5);
  EXPECT_FALSE(shape.is_hollow);
  expect_axis(shape);
}

TEST(SurfaceShape, OfASphere) {
  const SurfaceShape shape = fit_shape(facets(
      [](double u, double v) {
        const double polar = 0.4 + 1.2 * v, angle = 2 * u;
        return placed(7 * std::sin(polar) * std::cos(angle), 7 * std::sin(polar) * std::sin(angle),
                      7 * std::cos(polar));
      },
      8, 8, false));
  ASSERT_EQ(shape.kind, ShapeKind::sphere);
  EXPECT_NEAR(shape.radius, 7, 1e-6);
  EXPECT_NEAR((shape.center - origin).norm(), 0, 1e-5);
}

TEST(SurfaceShape, OfATorusSuchAsAFillet) {
  const SurfaceShape shape = fit_shape(facets(
      [](double u, double v) {
        const double r = 12 + 3 * std::cos(pi / 2 * v);
        return placed(r * std::cos(pi * u), r * std::sin(pi * u), 3 * std::sin(pi / 2 * v));
      },
      16, 5));
  ASSERT_EQ(shape.kind, ShapeKind::torus);
  EXPECT_NEAR(shape.radius, 12, 1e-4);
  EXPECT_NEAR(shape.minor_radius, 3, 1e-4);
  expect_axis(shape);
}

TEST(SurfaceShape, OfAFreeFormIsNone) {
  const SurfaceShape shape = fit_shape(
      facets([](double u, double v) { return placed(10 * u, 10 * v, std::sin(4 * u) * std::cos(3 * v)); }, 8, 8));
  EXPECT_EQ(shape.kind, ShapeKind::other);
}

TEST(SmoothPatches, OfABoxAreItsSides) {
  Mesh mesh;  // three cubes of 1 x 2 x 1 in a row
  for (int i = 0; i < 4; ++i)
    for (const auto& [y, z] : {std::pair{0, 0}, {2, 0}, {2, 1}, {0, 1}}) mesh.nodes.emplace_back(i, y, z);
  CellBlock cubes{CellType::hex8, {}};
  for (std::int64_t i = 0; i < 3; ++i)
    for (const std::int64_t side : {0, 4})
      for (std::int64_t k = 0; k < 4; ++k) cubes.connectivity.push_back(4 * i + side + k);
  mesh.blocks = {cubes};
  const std::vector<SurfacePatch> patches = smooth_patches(mesh, "box", 5, 0.7);
  ASSERT_EQ(patches.size(), 6);
  double area = 0;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    EXPECT_EQ(patches[i].number, 5 + static_cast<int>(i));
    EXPECT_EQ(patches[i].shape.kind, ShapeKind::plane);
    EXPECT_NEAR(patches[i].normal.dot(patches[i].shape.axis), 1, 1e-12);
    area += patches[i].area;
  }
  EXPECT_NEAR(area, 2 * (6 + 3 + 2), 1e-12);
  // A group that has a part of a side is a piece of its own.
  mesh.blocks.push_back({CellType::quad4, {0, 1, 5, 4}});
  mesh.groups["part"] = {"part", 2, {{1, 0}}};
  const std::vector<SurfacePatch> split = smooth_patches(mesh, "box", 1, 0.7);
  ASSERT_EQ(split.size(), 7);
  EXPECT_EQ(std::ranges::count_if(split, [](const SurfacePatch& patch) { return patch.faces.size() == 1; }), 3);
}

/// Two bodies of facets alone, in one list of nodes.
struct Pair {
  std::vector<Vector3> nodes;
  std::vector<SurfacePatch> patches;

  void add(const std::string& body, const std::vector<Facet>& all) {
    std::vector<Face> faces;
    for (const Facet& facet : all) {
      Face& face = faces.emplace_back(Face{CellType::tri3, {}});
      for (const Vector3& corner : facet.corners) {
        face.nodes.push_back(std::ssize(nodes));
        nodes.push_back(corner);
      }
    }
    patches.push_back(surface_patch(static_cast<int>(patches.size()) + 1, body, faces, nodes));
  }
};

TEST(FacingPatches, OfAShaftInAHoleHaveTheDistanceOfTheCylinders) {
  for (const double clearance : {0.1, 0.0, -0.05}) {
    Pair pair;
    pair.add("shaft", facets(cylinder(8, 20, 2 * pi), 24, 4));
    pair.add("hub", facets(cylinder(8 + clearance, 10, 2 * pi), 17, 3, false));
    const std::vector<FacingPatches> found = facing_patches(pair.patches, pair.nodes, 0.5);
    ASSERT_EQ(found.size(), 1) << clearance;
    EXPECT_TRUE(found[0].is_exact);
    EXPECT_NEAR(found[0].mean, clearance, 1e-5);
    EXPECT_NEAR(found[0].area, 2 * pi * 8 * 10, 0.03 * 2 * pi * 8 * 10) << "all of the hub";
  }
}

TEST(FacingPatches, OfPlanesThatOverlapInPart) {
  const auto plane = [](double x, double z) {
    return [=](double u, double v) { return Vector3(x + 10 * u, 10 * v, z); };
  };
  Pair pair;
  pair.add("below", facets(plane(0, 0), 10, 10));
  pair.add("above", facets(plane(4, 0.02), 10, 10, false));
  pair.add("above", facets(plane(0, 5), 10, 10, false));  // far
  pair.add("beside", facets(plane(0, 0.02), 10, 10));     // looks the same way
  const std::vector<FacingPatches> found = facing_patches(pair.patches, pair.nodes, 0.5);
  ASSERT_EQ(found.size(), 1 + 1) << "the one that looks the same way faces the other one";
  EXPECT_EQ(found[0].first, 0);
  EXPECT_EQ(found[0].second, 1);
  EXPECT_NEAR(found[0].mean, 0.02, 1e-9);
  EXPECT_NEAR(found[0].area, 60, 7);
  EXPECT_NEAR(found[0].angle, 0, 1e-6);
}

}  // namespace
}  // namespace surface_patch_tests
}  // namespace creepcontact::mesh
