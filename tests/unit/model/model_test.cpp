#include "creepcontact/model/model.hpp"

#include <sstream>

#include "creepcontact/base/error.hpp"
#include "creepcontact/run/check.hpp"
#include "support/run/blocks.hpp"

namespace creepcontact::run::test {
namespace {

using Indices = std::vector<std::size_t>;

TEST(Model, BodiesAndPairsOfTheConfiguration) {
  const Case blocks;
  const Model model = build_model(blocks.config());
  ASSERT_EQ(model.bodies().size(), 2U);
  EXPECT_EQ(find_body(model.bodies(), "upper"), 1U);
  EXPECT_EQ(find_body(model.bodies(), "none"), 2U);
  EXPECT_EQ(bodies_with(model.bodies(), "symmetry_x"), (Indices{0, 1}));
  EXPECT_EQ(bodies_with(model.bodies(), "top"), Indices{1});
  EXPECT_EQ(bodies_with(model.bodies(), "none"), Indices{});
  EXPECT_EQ(model.bodies()[0].discretization().n_elements(), 12U);
  EXPECT_EQ(model.bodies()[1].discretization().n_elements(), 16U);
  ASSERT_EQ(model.pairs().size(), 1U);
  EXPECT_EQ(model.pairs()[0].name, "lower_top-upper_bottom");
  EXPECT_EQ(model.pairs()[0].slave_surface, "lower_top");
  EXPECT_EQ(model.pairs()[0].slave_body, 0U);
  EXPECT_EQ(model.pairs()[0].master_body, 1U);
}

TEST(Model, SlaveAsAskedForOrTheCoarserSide) {
  const Case blocks;
  EXPECT_EQ(build_model(blocks.config("", {"contacts.0.slave=upper_bottom"})).pairs()[0].slave_body, 1U);
  // the lower block has 2 x 3 faces in the joint, the upper one 2 x 4
  EXPECT_EQ(build_model(blocks.config("", {"contacts.0.slave=auto"})).pairs()[0].slave_body, 0U);
  // a body softer by more than ten times goes first, however fine
  EXPECT_EQ(
      build_model(blocks.config("", {"contacts.0.slave=auto", "materials.hard.young_modulus=1"})).pairs()[0].slave_body,
      1U);
}

TEST(Model, ContactSolverAsConfigured) {
  const Case blocks;
  const Model usual = build_model(blocks.config());
  EXPECT_TRUE(usual.solver.use_schwarz);
  EXPECT_EQ(usual.solver.schwarz.acceleration, contact::SchwarzOptions::Acceleration::cg);
  EXPECT_EQ(usual.solver.schwarz.alpha, (std::vector<std::optional<double>>(2)));
  EXPECT_EQ(usual.solver.schwarz.damping, 1.0);
  const Model other = build_model(
      blocks.config("[contact_solver]\nalpha = 0.3\nacceleration = 'aitken'\ntolerance = 1e-6\nmax_iterations = 17\n"));
  EXPECT_EQ(other.solver.schwarz.acceleration, contact::SchwarzOptions::Acceleration::aitken);
  EXPECT_EQ(other.solver.schwarz.alpha, (std::vector<std::optional<double>>{0.3, 0.3}));
  EXPECT_EQ(other.solver.schwarz.tolerance, 1e-6);
  EXPECT_EQ(other.solver.schwarz.max_iterations, 17);
  const Model apart = build_model(blocks.config("[contact_solver]\nalpha = { upper = 0.4 }\ndamping = 0.5\n"));
  EXPECT_EQ(apart.solver.schwarz.alpha, (std::vector<std::optional<double>>{{}, 0.4}));
  EXPECT_EQ(apart.solver.schwarz.damping, 0.5);
  EXPECT_FALSE(build_model(blocks.config("[contact_solver]\nmethod = 'active_set'\n")).solver.use_schwarz);
}

TEST(Model, SurfaceMeshedOnceBetweenTwoBodies) {
  const Case blocks(joined_blocks());
  for (const char* slave : {"lower_top", "upper_bottom"}) {
    const Model model = build_model(blocks.config("", {std::string("contacts.0.slave=") + slave}));
    EXPECT_EQ(bodies_with(model.bodies(), "lower_top"), (Indices{0, 1}));
    ASSERT_EQ(model.pairs().size(), 1U);
    EXPECT_NE(model.pairs()[0].slave_body, model.pairs()[0].master_body);
    EXPECT_EQ(model.pairs()[0].slave_surface, slave);
    EXPECT_EQ(model.pairs()[0].slave_body, slave == std::string("lower_top") ? 0U : 1U);
    // each body has nodes of its own there
    EXPECT_EQ(model.bodies()[0].mesh().nodes.size(), 27U);
    EXPECT_EQ(model.bodies()[1].mesh().nodes.size(), 27U);
  }
}

TEST(Model, KinksOfTablesBecomeBreakpoints) {
  const Case blocks;
  const std::string tables = R"(
[[loads]]
on = "side_x"
pressure = { t = [0.25, 1], values = [0, 1] }
[[loads]]
on = "side_x"
traction = [0, { t = [1.25, 5], values = [0, 1] }, 0]
[[loads]]
at = [2, 1, 1]
force = [0, 0, { t = [1.5, 1.75], values = [0, 1] }]
[[loads]]
body = "lower"
body_force = [{ t = [2, 2.25], values = [0, 1] }, 0, 0]
[[loads]]
body = "upper"
rotation = { angular_velocity = { t = [2.5, 2.75], values = [0, 1] }, density = { t = [2.6, 2.65], values = [0, 1] } }
[temperature]
value = { t = [-1, 0, 3], values = [0, 20, 30] }
)";
  const Model model = build_model(blocks.config(
      tables, {"time.breakpoints=[0.125, 3.75]", "time.end=4", "contacts.0.gap={t=[3.25,3.5],values=[0,-0.01]}",
               "supports.3.displacement.z={t=[0,0.5,4],values=[0,-0.01,0]}"}));
  // those within (0, end), each once
  const std::vector<double> expected{0.125, 0.25, 0.5,  1,    1.25, 1.5,  1.75, 2,   2.25,
                                     2.5,   2.6,  2.65, 2.75, 3,    3.25, 3.5,  3.75};
  EXPECT_EQ(model.breakpoints, expected);
}

/// The line of the message that begins with a place and a key names the facts.
void expect_line(const std::string& message, const std::string& place, std::string_view key,
                 std::initializer_list<std::string_view> facts) {
  const std::string begin = place + std::string(key);
  const std::size_t found = message.find(begin);
  ASSERT_NE(found, std::string::npos) << begin << "\n--- in\n" << message;
  EXPECT_TRUE(says(message.substr(found, message.find('\n', found) - found), facts));
}

TEST(ModelMistakes, AllInOneGoWithTheirPlaces) {
  const Case blocks;
  const std::string more = R"(
[[supports]]
on = "botom"
displacement = { x = 0 }
[[supports]]
on = "top_edge"
displacement = { normal = 0 }
[[loads]]
on = "topp"
pressure = 1
[[loads]]
on = "side_y"
body = "upper"
traction = [1, 0, 0]
[[loads]]
on = "lower"
pressure = 1
[[loads]]
on = "bottom"
body = "upper"
pressure = 1
[[contacts]]
between = ["lower_tip", "upper_bottom"]
)";
  const config::Config config = blocks.config(more);
  const std::string message = message_of<ModelError>([&] { build_model(config); });
  const std::string all = "bottom, lower_top, side_x, side_y, symmetry_x, symmetry_y, top, upper_bottom";
  const auto expect = [&](const std::string& text, std::string_view key,
                          std::initializer_list<std::string_view> facts) {
    expect_line(message, blocks.position(text, more), key, facts);
  };
  expect("\"botom\"", "supports[4].on: ", {"'botom'", "'bottom'"});
  expect("\"top_edge\"", "supports[5].on: ", {"'top_edge'", "surface"});
  expect("\"topp\"", "loads[0].on: ", {"'topp'", "'top'", all});
  expect("\"lower\"\npressure", "loads[2].on: ", {"'lower'", "volume", "surface"});
  expect("\"bottom\"\nbody", "loads[3].on: ", {"'bottom'", "body 'upper'"});
  expect("\"lower_tip\"", "contacts[1].between[0]: ", {"surface 'lower_tip'"});
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 5) << message;
}

TEST(ModelMistakes, RegionsOfAllBodies) {
  const Case blocks;
  const config::Config config = blocks.config("", {"bodies.lower.region=lowr", "bodies.upper.region=top"});
  const std::string message = message_of<ModelError>([&] { build_model(config); });
  EXPECT_TRUE(says(message, {"volume 'lowr'", "'lower'"}));
  EXPECT_TRUE(says(message, {"'top'", "surface", "volume"}));
}

TEST(ModelMistakes, LoadsAndContactsThatDoNotFit) {
  const Case blocks;
  const std::string more = R"(
[[loads]]
at = [2, 1, 0.9]
force = [0, 0, 1]
[[contacts]]
between = ["lower_top", "bottom"]
[[contacts]]
between = ["side_y", "side_x"]
slave = "side_y"
)";
  const config::Config config = blocks.config(more);
  const std::string message = message_of<ModelError>([&] { build_model(config); });
  expect_line(message, blocks.position("[[loads]]", more),
              "loads[0]: ", {"(2, 1, 0.9)", "(2, 1, 1)", "body 'upper'", "0.1"});
  expect_line(message, blocks.position("[[contacts]]\nbetween = [\"lower_top\", \"bottom\"]", more),
              "contacts[1]: ", {"'lower_top'", "'bottom'", "body 'lower'"});
  expect_line(message, blocks.position("[[contacts]]\nbetween = [\"side_y\"", more), "contacts[2]: ", {});
}

TEST(ModelMistakes, PointForceWithinItsTolerance) {
  const Case blocks;
  const Model model = build_model(blocks.config("[[loads]]\nat = [2, 1, 0.9]\nforce = [0, 0, 1]\ntolerance = 0.2\n"));
  std::vector<double> forces(3 * model.bodies()[1].mesh().nodes.size());
  const mechanics::BodyConditions at = model.bodies()[1].at(0);
  const auto external = at.external_forces();
  double sum = 0;
  for (std::size_t i = 2; i < external.size(); i += 3) {
    sum += external[i];
    if (external[i] != 0) {
      EXPECT_EQ(model.bodies()[1].mesh().nodes[i / 3], Vector3(2, 1, 1));
    }
  }
  EXPECT_EQ(sum, 1);
}

TEST(FreeBodies, NeedAContactThatHoldsThem) {
  const Case blocks;
  // Nothing but contact holds the upper block along z, nothing at all holds the two along y.
  const std::vector<std::string> loose{"supports.3.on=bottom", "supports.3.displacement.z=0",
                                       "supports.1.on=symmetry_x", "supports.1.displacement={x=0}"};
  std::ostringstream report;
  const std::string unloaded = message_of<ModelError>([&] { check(blocks.config("", loose), report); });
  EXPECT_TRUE(says(unloaded, {"not loaded"}));
  for (const char* part :
       {"rigid-body modes: translation along y\n", "rigid-body modes: translation along y, translation along z",
        "rigid-body motions held by contact only: 2\n",
        "not held by supports or contact, must not be loaded: body 'lower': translation along y\n",
        "not held by supports or contact, must not be loaded: body 'upper': translation along y\n"})
    EXPECT_TRUE(contains(report.str(), part)) << part << "\n--- in\n" << report.str();

  std::vector<std::string> apart = loose;
  apart.insert(apart.end(), {"contacts=[]", "probes=[]"});
  const config::Config without_contact = blocks.config("", apart);
  for (const auto& message : {message_of<ModelError>([&] { const System system(without_contact); }),
                              message_of<ModelError>([&] { check(without_contact, report); })}) {
    EXPECT_TRUE(says(message, {"body 'lower'", "translation along y;"}));
    EXPECT_TRUE(says(message, {"body 'upper'", "translation along y, translation along z, rotation"}));
  }
}

TEST(FreeBodies, FlyOffUnderALoadThatNothingBalances) {
  const Case blocks;
  const std::vector<std::string> loose{"supports.3.on=bottom", "supports.3.displacement.z=0"};
  const auto message = [&](const std::string& load, std::vector<std::string> overrides) {
    const config::Config config = blocks.config("[[loads]]\non = 'top'\n" + load + "\n", overrides);
    return message_of<ModelError>([&] { const System system(config); });
  };
  EXPECT_EQ(message("pressure = 1", loose), "nothing was thrown");
  const std::string pulled = message("pressure = -1", loose);
  EXPECT_TRUE(says(pulled, {"body 'upper'", "translation along z", "t = 0"}));
  std::vector<std::string> sliding = loose;
  sliding.insert(sliding.end(), {"supports.1.on=symmetry_x", "supports.1.displacement={x=0}"});
  const std::string pushed = message("traction = [0, 1, -1]", sliding);
  EXPECT_TRUE(says(pushed, {"body 'upper'", "translation along y", "t = 0"}));
}

TEST(Check, TellsWhatTheModelIs) {
  const Case blocks;
  std::ostringstream report;
  check(blocks.config("", {"materials.hard.creep=[]"}), report);
  const std::string text = report.str();
  for (const char* part :
       {"body 'lower': 12 hex8, 36 nodes, ", "96 integration points", "material 'soft'\n", "rigid-body modes: none",
        "body 'upper': 16 hex8, 45 nodes", "material 'hard' (elastic)",
        "contact 'lower_top-upper_bottom': slave 'lower_top' on 'lower', master 'upper_bottom' on 'upper', 12",
        "unknowns of the time integration: 576", "estimated memory: "})
    EXPECT_TRUE(contains(text, part)) << part << "\n--- in\n" << text;
}

TEST(Check, LooksAtTheProbesToo) {
  const Case blocks;
  const config::Config config = blocks.config("[[probes]]\nname = 'q'\nquantity = 'von_mises'\non = 'tpo'\n");
  std::ostringstream report;
  EXPECT_TRUE(says(message_of<ModelError>([&] { check(config, report); }), {"probes[0]: ", "'tpo'"}));
}

}  // namespace
}  // namespace creepcontact::run::test
