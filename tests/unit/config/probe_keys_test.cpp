/// Parts, sections and expressions of probes; events.

#include "config_fixture.hpp"

namespace creepcontact::config {
namespace {

const std::string stress_probe = minimal + "[[probes]]\nname = \"a\"\nquantity = \"von_mises\"\n";
const std::string section_probe =
    minimal + "[[probes]]\nname = \"a\"\nquantity = \"section_moment_x\"\nbody = \"block\"\n";

TEST(ProbeKeys, AreRead) {
  const Config config = parse_text(stress_probe + R"(on = "s"
where = "x*x + z*z < 40^2 && y > 0"
scale = 1e-3
unit = "kN"
[[probes]]
name = "m"
quantity = "section_moment_x"
body = "block"
section = { origin = [1, 2, 3], normal = [0, 0, 2] }
[[probes]]
name = "about"
quantity = "section_moment_x"
body = "block"
section = { origin = [1, 2, 3], normal = [0, 0, 2] }
origin = [4, 5, 6]
[[probes]]
name = "e"
expression = "2*m + t*later"
[[probes]]
name = "later"
expression = "a^2"
[[events]]
name = "end"
when = "e < 20 || t > 1000"
stop = true
)");
  const Probe& part = config.probes[0];
  EXPECT_EQ((*part.where)({.x = 39, .y = 1}), 1);
  EXPECT_EQ((*part.where)({.x = 39, .y = 1, .z = 39}), 0);
  EXPECT_EQ((*part.where)({.x = 39, .y = -1}), 0);
  EXPECT_EQ(part.scale, 1e-3);
  EXPECT_EQ(part.unit, "kN");
  EXPECT_EQ(config.probes[1].section->normal, (std::array<double, 3>{0, 0, 2}));
  EXPECT_EQ(config.probes[1].origin, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(config.probes[2].origin, (std::array<double, 3>{4, 5, 6}));
  EXPECT_EQ(config.probes[3].expression.name, "2*m + t*later");
  ASSERT_EQ(config.events.size(), 1u);
  EXPECT_EQ(config.events[0].when.name, "e < 20 || t > 1000");
  EXPECT_TRUE(config.events[0].stop);
}

TEST(ProbeKeys, Parts) {
  expect_mistake(stress_probe + "on = \"s\"\nwhere = \"x < \"\n",
                 {"cases/block.toml:16:9: probes[0].where: ", "'x < '"});
  expect_mistake(stress_probe + "on = \"s\"\nwhere = \"t < 1\"\n",
                 {"cases/block.toml:16:9: probes[0].where: ", "'t < 1'"});
  expect_mistake(stress_probe + "on = \"s\"\nwhere = \"x = 1\"\n",
                 {"cases/block.toml:16:9: probes[0].where: ", "'x = 1'", "position 2", "'=='"});
  expect_mistake(stress_probe + "on = \"s\"\nwhere = \"1 < 2\"\n",
                 {"cases/block.toml:16:9: probes[0].where: ", "'1 < 2'", "x, y, z"});
  expect_mistake(stress_probe + "at = [0, 0, 0]\nwhere = \"x < 1\"\n",
                 {"cases/block.toml:16:9: probes[0].where: ", "'on'", "'body'"});
}

TEST(ProbeKeys, Sections) {
  expect_mistake(section_probe, {"cases/block.toml:12:1: probes[0]: ", "'section_moment_x'", "'section'"});
  expect_mistake(section_probe + "section = { origin = [0, 0, 0] }\n",
                 {"cases/block.toml:16:11: probes[0].section.normal: ", "missing"});
  expect_mistake(section_probe + "section = { origin = [0, 0, 0], normal = [0, 0, 0] }\n",
                 {"cases/block.toml:16:42: probes[0].section.normal: ", "[0, 0, 0]"});
  expect_mistake(
      section_probe + "section = { origin = [0, 0, 0], normal = [0, 0, 1] }\non = \"s\"\n",
      {"cases/block.toml:14:12: probes[0].quantity: ", "'section_moment_x'", "'section_moment_x'", "'body'"});
  expect_mistake(stress_probe + "body = \"block\"\nsection = { origin = [0, 0, 0], normal = [0, 0, 1] }\n",
                 {"cases/block.toml:16:11: probes[0].section: ", "'von_mises'", "section_force_x"});
}

TEST(ProbeKeys, Expressions) {
  const std::string probes = stress_probe + "body = \"block\"\n[[probes]]\nname = \"b\"\n";
  expect_mistake(stress_probe + "body = \"block\"\n[[probes]]\nname = \"seal\"\nexpression = \"2*seall\"\n",
                 {"cases/block.toml:18:14: probes[1].expression: ", "'2*seall'", "'seall'", "'seal'", "a, seal, t"});
  expect_mistake(probes + "expression = \"2*(a\"\n", {"cases/block.toml:18:14: probes[1].expression: ", "'2*(a'"});
  expect_mistake(probes + "expression = \"a\"\nquantity = \"von_mises\"\n",
                 {"cases/block.toml:19:12: probes[1].quantity: ", "'expression'"});
  expect_mistake(probes + "expression = \"b + 1\"\n", {"cases/block.toml:18:14: probes[1].expression: ", "'b'", "'b'"});
  expect_mistake(probes + "expression = \"c + 1\"\n[[probes]]\nname = \"c\"\nexpression = \"2*b\"\n",
                 {"cases/block.toml:18:14: probes[1].expression: ", "'b'", "'c'", "'b'"});
  expect_mistake(minimal +
                     "[[probes]]\nname = \"a-b\"\nquantity = \"von_mises\"\nbody = \"block\"\n[[probes]]\nname = "
                     "\"c\"\nexpression = \"2*a-b\"\n",
                 {"cases/block.toml:18:14: probes[1].expression: ", "'2*a-b'", "'a-b'"});
}

TEST(EventKeys, Mistakes) {
  const std::string event = stress_probe + "body = \"block\"\n[[events]]\nname = \"e\"\n";
  expect_mistake(event, {"cases/block.toml:16:1: events[0].when: ", "missing"});
  expect_mistake(event + "when = \"b < 1\"\n", {"cases/block.toml:18:8: events[0].when: ", "'b < 1'", "'b'"});
  expect_mistake(event + "when = \"a << 1\"\n", {"cases/block.toml:18:8: events[0].when: ", "'a << 1'"});
  expect_mistake(event + "when = \"a < 1\"\nstop = 1\n", {"cases/block.toml:19:8: events[0].stop: "});
  expect_mistake(event + "when = \"a < 1\"\n[[events]]\nname = \"e\"\nwhen = \"a < 2\"\n",
                 {"cases/block.toml:19:1: events[1]: ", "'e'", "events[0]"});
  expect_mistake(event + "condition = \"a < 1\"\nwhen = \"a < 1\"\n",
                 {"cases/block.toml:18:1: events[0].condition: ", "'when'"});
}

}  // namespace
}  // namespace creepcontact::config
