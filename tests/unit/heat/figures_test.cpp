/// How fast bodies follow their surfaces, and how fine their elements are.
#include "creepcontact/heat/figures.hpp"

#include <gtest/gtest.h>

#include "support/mechanics/meshes.hpp"
#include "support/mechanics/sections.hpp"

namespace creepcontact::heat {
namespace figures_tests {
namespace {

using namespace test;
using enum CellType;

/// A slab of 3 x 2 x 1, conductivity 4, heat capacity times density 10, in units of time of a tenth.
Definition slab(const mesh::Mesh& mesh) {
  Definition all;
  all.bodies = {{"slab", &mesh, {4.0}, {}, 5.0, 2.0}};
  all.time_unit = 0.1;
  return all;
}

SurfaceFlow film_on(const mesh::Mesh& mesh, const std::string& on, Function h, Function fluid) {
  return {SurfaceFlow::Kind::film, 0, mesh::boundary_faces(mesh, on), std::move(h), std::move(fluid)};
}

TEST(HeatFigures, OfSlabsHeatedFromOneSideAndFromTwo) {
  const std::vector<double> start{20.0};
  for (const CellType type : {hex8, hex20, tet10, wedge15}) {
    const mesh::Mesh mesh = box_mesh(type, {6, 4, 2}, {3, 2, 1});
    Definition all = slab(mesh);
    EXPECT_EQ(figures(all, start, 1).bodies[0].depth, 0) << "insulated";
    all.flows = {film_on(mesh, "x0", 8.0, 120.0)};
    const Figures one = figures(all, start, 1);
    EXPECT_NEAR(one.bodies[0].depth, 3, 1e-12);
    EXPECT_NEAR(one.bodies[0].time, 9 / (4.0 / 10) / 0.1, 1e-9);
    EXPECT_NEAR(one.films[0].element_size, 0.5, type == hex8 || type == hex20 ? 1e-12 : 0.26);
    EXPECT_NEAR(one.films[0].biot, 8 * one.films[0].element_size / 4, 1e-12);
    all.flows.push_back(film_on(mesh, "x0", 1.0, 120.0));  // on the same surface
    all.given = {{0, mesh::group_nodes(mesh, "x1"), 50.0}};
    EXPECT_NEAR(figures(all, start, 1).bodies[0].depth, 1.5, 1e-12);
  }
}

TEST(HeatFigures, OfATube) {
  mesh::Section axisymmetric;
  axisymmetric.analysis = settings::Analysis::axisymmetric;
  const mesh::Mesh mesh = section_mesh(quad8, {8, 2}, {2, 1}, {1, 0}, axisymmetric);
  Definition all = slab(mesh);
  all.flows = {film_on(mesh, "x1", 8.0, 0.0)};
  // pi (9 - 1) over 2 pi 3
  EXPECT_NEAR(figures(all, std::vector<double>{0.0}, 1).bodies[0].depth, 4.0 / 3, 1e-12);
}

TEST(HeatFigures, FindTheLargestCoefficientAndTheJumpsOfTheFluid) {
  const mesh::Mesh mesh = box_mesh(hex8, {2, 2, 2}, {1, 1, 1});
  Definition all = slab(mesh);
  const auto of = [](const std::string& text) { return Function::expression(text, {"x", "y", "z", "t", "T"}); };
  all.flows = {film_on(mesh, "x0", of("1 + 6*t*(1 - t)*(1 + y)"), 90.0)};
  const Figures figures_of_film = figures(all, std::vector<double>{20.0}, 1);
  const FilmFigures& film = figures_of_film.films[0];
  EXPECT_NEAR(film.coefficient, 1 + 1.5 * 1.5, 1e-3) << "half way through the run, at the nodes in the middle";
  EXPECT_NEAR(film.jumps.first, 70, 1e-12);
  EXPECT_EQ(film.jumps.later, 0);
}

}  // namespace
}  // namespace figures_tests
}  // namespace creepcontact::heat
