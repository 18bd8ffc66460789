#include "creepcontact/base/error.hpp"
#include "support/run/probing.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

/// Four blocks around the z axis, cut from one mesh: "a", "b", "c", "d" against the clock, from z = 0 to 1.
const std::string quarters = R"(SetFactory("OpenCASCADE");
e = 1e-3;
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {-1.5, 0, 0, 1.5, 1, 1};
Box(3) = {-1.5, -1, 0, 1.5, 1, 1};
Box(4) = {0, -1, 0, 1, 1, 1};
BooleanFragments{ Volume{1:4}; Delete; }{}
Transfinite Curve{:} = 3;
Transfinite Surface{:};
Recombine Surface{:};
Transfinite Volume{:};
Physical Volume("a") = Volume In BoundingBox{-e, -e, -e, 1 + e, 1 + e, 1 + e};
Physical Volume("b") = Volume In BoundingBox{-2, -e, -e, e, 1 + e, 1 + e};
Physical Volume("c") = Volume In BoundingBox{-2, -2, -e, e, e, 1 + e};
Physical Volume("d") = Volume In BoundingBox{-e, -2, -e, 2, e, 1 + e};
Physical Surface("bottom") = Surface In BoundingBox{-9, -9, -e, 9, 9, e};
Physical Surface("top") = Surface In BoundingBox{-9, -9, 1 - e, 9, 9, 1 + e};
Physical Surface("end") = Surface In BoundingBox{-9, -9, -e, -1.5 + e, 9, 9};
Physical Surface("face") = Surface In BoundingBox{1 - e, -9, -e, 9, 9, 9};
ab() = Surface In BoundingBox{-e, -e, -e, e, 1 + e, 1 + e};
Physical Surface("a_b") = {ab()};
Physical Surface("b_a") = {ab()};
)";

const std::string common = R"(
[mesh]
file = "blocks.geo"
order = 2
[materials.steel]
young_modulus = 100
poisson_ratio = 0.3
creep = [{ law = "norton", A = 1e-3, n = 3 }]
[materials.brass]
young_modulus = 100
poisson_ratio = 0.3
creep = [{ law = "norton", A = 1e-3, n = 3 }]
[[supports]]
on = "end"
displacement = { normal = 0 }
[[supports]]
on = "bottom"
displacement = { x = 0, y = "0.01*x", z = 0 }
[[loads]]
on = "face"
traction = ["1+y", 0.5, "0.3*z"]
[time]
end = 2
integrator = "explicit_euler"
step = 0.25
[output]
fields = false
directory = "results"
)";

std::string body(const std::string& name, const std::string& regions, const std::string& material = "steel") {
  return "[bodies." + name + "]\nregion = " + regions + "\nmaterial = '" + material + "'\n";
}
const std::string four = body("a", "'a'") + body("b", "'b'", "brass") + body("c", "'c'") + body("d", "'d'", "brass");
const std::string tie = "mesh.share_nodes=tie";

std::string mistakes(const Case& blocks, const std::string& text, const std::vector<std::string>& overrides = {}) {
  const config::Config config = blocks.parse(text, overrides);
  return message_of<ModelError>([&] { build_model(config); });
}

TEST(SharedNodes, BodiesThatWouldComeApart) {
  const Case blocks(quarters);
  const std::string said = mistakes(blocks, common + four);
  const std::string position = (blocks / "case.toml").string() + ":3:8: mesh.file: ";
  for (const char* pair : {"'a' and 'b'", "'b' and 'c'", "'c' and 'd'", "'a' and 'd'"})
    EXPECT_TRUE(says(said, {position + "bodies " + pair, "21 nodes", "type = \"tied\"", "mesh.share_nodes = \"tie\""}));
  for (const char* pair : {"'a' and 'c'", "'b' and 'd'"})  // their edge is held as soon as the faces are
    EXPECT_FALSE(contains(said, pair)) << said;
}

TEST(SharedNodes, WithTheOtherMistakes) {
  const Case blocks(quarters);
  const std::string said = mistakes(blocks, common + four, {"supports.0.on=ende"});
  EXPECT_TRUE(says(said, {"group 'ende'", "'end'"}));
  EXPECT_TRUE(says(said, {"'a' and 'b'", "21 nodes"}));
}

TEST(SharedNodes, AContactCoversThem) {
  const Case blocks(quarters);
  const std::string two = body("a", "'a'") + body("b", "'b'");
  const std::string contact = "[[contacts]]\nbetween = ['a_b', 'b_a']\n";
  EXPECT_TRUE(says(mistakes(blocks, common + two), {"21 nodes"}));
  for (const char* type : {"type = 'tied'\n", ""}) {
    const Model model = build_model(blocks.parse(common + two + contact + type));
    EXPECT_EQ(model.pairs().size(), 1u);
  }
  testing::internal::CaptureStderr();
  EXPECT_EQ(build_model(blocks.parse(common + two + contact, {tie})).pairs().size(), 1u);
  EXPECT_TRUE(says(testing::internal::GetCapturedStderr(), {"mesh.share_nodes = \"tie\""}));
}

TEST(SharedNodes, AContactCoversAPart) {
  const Case blocks(quarters);
  // the joint of the two halves is two surfaces, and the contact is on one of them
  const std::string halves = body("right", "['a', 'd']") + body("left", "['b', 'c']");
  const std::string contact = "[[contacts]]\nbetween = ['a_b', 'b_a']\n";
  const std::string said = mistakes(blocks, common + halves + contact);
  EXPECT_TRUE(says(said, {"'right' and 'left'", "37 nodes", "16"}));
  EXPECT_EQ(build_model(blocks.parse(common + halves + contact, {tie})).pairs().size(), 2u);
}

TEST(SharedNodes, AnEdgeHoldsNothing) {
  const Case blocks(quarters);
  for (const std::vector<std::string>& overrides : {std::vector<std::string>{}, {tie}}) {
    const std::string said = mistakes(blocks, common + body("a", "'a'") + body("c", "'c'"), overrides);
    EXPECT_TRUE(says(said, {"'a' and 'c'", "5 nodes", "edge"}));
    EXPECT_FALSE(contains(said, "mesh.share_nodes")) << said;
  }
}

TEST(SharedNodes, SupportsMustNotMoveThemApart) {
  const Case blocks(quarters);
  const std::string moved =
      "[[supports]]\non = 'top'\nbody = 'a'\ndisplacement = { z = 0.1 }\n"
      "[[supports]]\non = 'top'\nbody = 'b'\ndisplacement = { z = 0.2 }\n";
  const std::string said = mistakes(blocks, common + body("a", "'a'") + body("b", "'b'") + moved, {tie});
  EXPECT_TRUE(says(said, {"supports", "node (", "'a' and 'b'", "(0, "}));
}

/// History of a run with fixed steps. @param joint  the body at a place of the joint
Table history(const Case& blocks, const std::string& bodies, const std::string& joint,
              const std::vector<std::string>& overrides) {
  const std::string probes = probe_tables({{"u_end", "displacement_y", "at = [1, 1, 1]"},
                                           {"u_top", "displacement_x", "on = 'top'"},
                                           {"u_joint", "displacement_z", "at = [0, 0.5, 0.7], body = '" + joint + "'"},
                                           {"s_a", "stress_xx", "at = [0.9, 0.9, 0.4]"},
                                           {"s_c", "stress_zx", "at = [-1.4, -0.9, 0.6]"},
                                           {"creep", "creep_strain_equivalent", "at = [-1.4, 0.9, 0.1]"},
                                           {"reaction", "reaction_x", "on = 'end'"}});
  RunOptions options;
  const Summary result = run(blocks.parse(probes + common + bodies, overrides), options);
  EXPECT_EQ(result.exit_status, 0) << result.message;
  return Table(blocks / "results" / "history.csv");
}

/// Supports on the shared nodes, an edge that four bodies share, stresses that vary over the joints.
TEST(SharedNodes, TiedBodiesMoveAsOne) {
  const Case blocks(quarters);
  const Table one = history(blocks, body("all", "['a', 'b', 'c', 'd']"), "all", {});
  ASSERT_EQ(one.rows(), 2);
  EXPECT_GT(std::abs(one.column("u_end")[1] / one.column("u_end")[0] - 1), 0.01) << "creep matters";
  for (const char* method : {"contact_solver.method=schwarz", "contact_solver.method=active_set"}) {
    const Table tied = history(blocks, four, "b", {tie, method});
    ASSERT_EQ(tied.rows(), one.rows());
    for (const std::string& name : one.names()) {
      const std::vector<double>&expected = one.column(name), &found = tied.column(name);
      for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-8 * std::abs(expected[i]) + 1e-12) << name;
    }
  }
}

}  // namespace
}  // namespace creepcontact::run::test
