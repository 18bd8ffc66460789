/// One body in several pairs whose surfaces meet in an edge, and the balance of forces between bodies.

#include <Eigen/LU>

#include "verification/boxes.hpp"
#include "verification/contact_state.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace {

using test::Box;

struct Slaves {
  std::string name, floor, wall, back;
  int order;
};

class CornerContact : public testing::TestWithParam<Slaves> {};

// A cube pressed into the corner between a floor (below), a wall (at its x side) and a back (at its y side): its three
// contact surfaces share three edges and a corner. All else slides, so every body is under uniform stress.
TEST_P(CornerContact, UniformStatesOnAllSides) {
  const Slaves& slaves = GetParam();
  // Apart by a little in the mesh, which the given gap of 0 overrides: coincident edges of layered meshes confuse Gmsh.
  const double apart = 1e-3;
  const std::vector<Box> boxes{{"cube", {0, 0, 0}, {1, 1, 1}, {3, 2, 4}},
                               {"floor", {0, 0, -2 - apart}, {1, 1, 2}, {2, 3, 2}},
                               {"wall", {1 + apart, 0, 0}, {2, 1, 1}, {2, 3, 2}},
                               {"back", {0, 1 + apart, 0}, {1, 2, 1}, {2, 2, 4}}};
  constexpr double nu = 0.3;
  const Eigen::Vector3d pushed(0.004, 0.007, 0.01), moduli(3e3, 1e3, 5e2);  // along x, y, z; wall, back, floor
  constexpr double cube = 2e3, depth = 2;
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = " + std::to_string(slaves.order) + "\n" +
                     test::body("cube", cube, nu) + test::body("wall", moduli.x(), nu) +
                     test::body("back", moduli.y(), nu) + test::body("floor", moduli.z(), nu);
  toml += test::support("cube_x0", "x", "0.004") + test::support("cube_y0", "y", "0.007") +
          test::support("cube_z1", "z", "-0.01");
  toml += test::support("floor_x0", "x") + test::support("floor_y0", "y") + test::support("floor_z0", "z");
  toml += test::support("wall_x1", "x") + test::support("wall_y0", "y") + test::support("wall_z0", "z");
  toml += test::support("back_x0", "x") + test::support("back_y1", "y") + test::support("back_z0", "z");
  toml += test::contact_table("floor_z1", "cube_z0", "slave = \"" + slaves.floor + "\"") +
          test::contact_table("cube_x1", "wall_x0", "slave = \"" + slaves.wall + "\"") +
          test::contact_table("cube_y1", "back_y0", "slave = \"" + slaves.back + "\"") + "[time]\nend = 1\n";
  for (const char* name : {"cube", "floor", "wall", "back"})
    for (const char* reduce : {"min", "max"})
      for (const char* component : {"xx", "yy", "zz", "xy", "yz", "zx"})
        toml += test::probe(std::string(name) + "_" + component + "_" + reduce, std::string("stress_") + component,
                            "body = \"" + std::string(name) + "\"\nreduce = \"" + reduce + "\"");
  const test::ContactState state = test::contact_state(toml, test::boxes_geo(boxes));

  // Along each axis i the cube and its neighbour are squeezed by pushed_i under the pressures p:
  // p_i (1/cube + depth/E_i) - nu/cube (p_j + p_k) = pushed_i
  Eigen::Matrix3d flexibility = Eigen::Matrix3d::Constant(-nu / cube);
  flexibility.diagonal() = (depth / moduli.array() + 1 / cube).matrix();
  const Eigen::Vector3d p = flexibility.inverse() * pushed;
  ASSERT_GT(p.minCoeff(), 0);
  const std::map<std::string, Eigen::Vector3d> exact{
      {"cube", -p}, {"wall", {-p.x(), 0, 0}}, {"back", {0, -p.y(), 0}}, {"floor", {0, 0, -p.z()}}};
  const std::map<std::string, int> axis{{"floor_z1/cube_z0", 2}, {"cube_x1/wall_x0", 0}, {"cube_y1/back_y0", 1}};
  const double tolerance = 1e-8 * p.maxCoeff();
  for (const auto& [body, stress] : exact)
    for (const std::string reduce : {"_min", "_max"}) {
      EXPECT_NEAR(state.probes.at(body + "_xx" + reduce), stress.x(), tolerance) << body << reduce;
      EXPECT_NEAR(state.probes.at(body + "_yy" + reduce), stress.y(), tolerance) << body << reduce;
      EXPECT_NEAR(state.probes.at(body + "_zz" + reduce), stress.z(), tolerance) << body << reduce;
      for (const std::string shear : {"_xy", "_yz", "_zx"})
        EXPECT_NEAR(state.probes.at(body + shear + reduce), 0, tolerance) << body << shear << reduce;
    }
  for (const auto& [pair, points] : state.pairs)
    for (const test::ContactPoint& point : points) EXPECT_NEAR(point.pressure, p[axis.at(pair)], tolerance) << pair;
}

std::vector<Slaves> all_slaves() {
  std::vector<Slaves> list;
  for (const int order : {1, 2})
    for (const int sides : {0, 1, 2, 3, 4, 5, 6, 7})
      list.push_back({"order_" + std::to_string(order) + "_slaves_" + std::to_string(sides),
                      sides & 1 ? "cube_z0" : "floor_z1", sides & 2 ? "cube_x1" : "wall_x0",
                      sides & 4 ? "cube_y1" : "back_y0", order});
  return list;
}

INSTANTIATE_TEST_SUITE_P(Slaves, CornerContact, testing::ValuesIn(all_slaves()),
                         [](const auto& parameter) { return parameter.param.name; });

class Balance : public testing::TestWithParam<std::string> {};

// A loaded beam, clamped at one end, leans on a post under the other: what the clamp and the post carry is the load.
TEST_P(Balance, ContactForcesAreOppositeAndCarryTheLoad) {
  const std::vector<Box> boxes{{"post", {7, 0, 0}, {2.5, 2, 5}, {3, 4, 4}},
                               {"beam", {0, 0, 5}, {10, 2, 2}, {7, 3, 2}, false}};
  std::string toml =
      "[mesh]\nfile = \"case.geo\"\norder = 2\n" + test::body("post", 1e3, 0.3) + test::body("beam", 3e3, 0.2) +
      "[[loads]]\non = \"beam_z1\"\npressure = \"1 + 0.1*x*y\"\n" +
      test::contact_table("post_z1", "beam_z0", "gap = \"0.2*(x - 8)\"\nslave = \"" + GetParam() + "\"") +
      "[time]\nend = 1\n";
  for (const char* component : {"x", "y", "z"})
    toml +=
        test::support("post_z0", component) + test::support("beam_x0", component) +
        test::probe(std::string("post_") + component, std::string("contact_force_") + component, "on = \"post_z1\"") +
        test::probe(std::string("beam_") + component, std::string("contact_force_") + component, "on = \"beam_z0\"") +
        test::probe(std::string("clamp_") + component, std::string("reaction_") + component, "on = \"beam_x0\"") +
        test::probe(std::string("ground_") + component, std::string("reaction_") + component, "on = \"post_z0\"");
  const test::ContactState state = test::contact_state(toml, test::boxes_geo(boxes));
  const double load = 10 * 2 * 1.0 + 0.1 * 50 * 2;
  const auto& found = state.probes;
  for (const std::string component : {"x", "y", "z"}) {
    const double applied = component == "z" ? -load : 0;
    EXPECT_NEAR(found.at("post_" + component), -found.at("beam_" + component), 1e-9 * load);
    EXPECT_NEAR(found.at("clamp_" + component) + found.at("beam_" + component), -applied, 1e-9 * load);
    EXPECT_NEAR(found.at("ground_" + component) + found.at("post_" + component), 0, 1e-9 * load);
  }
  EXPECT_GT(found.at("beam_z"), 0.2 * load);
  int open = 0;
  for (const test::ContactPoint& point : state.pairs.at("post_z1/beam_z0")) {
    EXPECT_GE(point.pressure, 0);
    EXPECT_GE(point.gap, -1e-10);  // the deflection is about 0.1
    EXPECT_TRUE(point.pressure == 0 || std::abs(point.gap) < 1e-10);
    open += point.pressure == 0;
  }
  EXPECT_GT(open, 0) << "part of the joint must be open";
}

INSTANTIATE_TEST_SUITE_P(Slave, Balance, testing::Values("post_z1", "beam_z0"),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace creepcontact
