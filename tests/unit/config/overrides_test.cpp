#include "config_fixture.hpp"
#include "support/says.hpp"

namespace creepcontact::config {
namespace {

const std::string with_lists = minimal + R"([[contacts]]
between = ["a", "b"]
[[materials.steel.creep]]
law = "norton"
A = 1e-20
n = 7
)";

TEST(ConfigOverrides, Values) {
  const Config config =
      parse_text(with_lists, {"time.end=1e3", "time.output=[1, 2]", "contact_solver.alpha=0.5", "title=\"two words\"",
                              "units=mm and N", "time.step = stable", "mesh.file=block.geo", "mesh.parameters.h=2"});
  EXPECT_EQ(config.time.end, 1000.0);
  EXPECT_EQ(config.time.output, (std::vector<double>{0, 1, 2, 1000}));
  EXPECT_EQ(config.contact_solver.alpha.all, 0.5);
  EXPECT_EQ(config.title, "two words");
  EXPECT_EQ(config.units, "mm and N");
  EXPECT_EQ(config.time.step.mode, StepMode::stable);
  EXPECT_EQ(config.mesh.parameters.at("h"), 2.0);
}

TEST(ConfigOverrides, EntriesOfLists) {
  const Config config = parse_text(with_lists, {"contacts.0.gap=-0.1", "materials.steel.creep.0.n=5",
                                                "materials.steel.creep[0].A=2", "contacts.0.between.1=c"});
  EXPECT_EQ(config.contacts[0].gap({}), -0.1);
  EXPECT_EQ(config.contacts[0].between[1].name, "c");
  EXPECT_EQ(config.materials[0].creep[0].parameters[1].values[0]({}), 5.0);
  EXPECT_EQ(config.materials[0].creep[0].parameters[0].values[0]({}), 2.0);
}

TEST(ConfigOverrides, TheLastOneCounts) {
  EXPECT_EQ(parse_text(minimal, {"time.end=1", "time.end=2"}).time.end, 2.0);
}

TEST(ConfigOverrides, AnExpressionIsAString) {
  const Config config = parse_text(minimal + "[[loads]]\non = \"a\"\npressure = 1\n", {"loads.0.pressure=100*t"});
  EXPECT_EQ(std::get<Pressure>(config.loads[0].kind).value({.t = 2}), 200.0);
}

TEST(ConfigOverrides, AWholeTableReplaces) {
  const std::string series = minimal + "output = { first = 20, count = 3 }\n";
  EXPECT_EQ(parse_text(series, {"time.output={ count = 2 }"}).time.output, (std::vector<double>{0, 50, 100}));
  EXPECT_EQ(parse_text(series, {"time.output.count=2"}).time.output, (std::vector<double>{0, 20, 100}));
}

TEST(ConfigOverrides, Mistakes) {
  const auto expect = [](const std::string& override_text, std::initializer_list<std::string_view> facts) {
    const std::vector<std::string> lines = mistakes(with_lists, {override_text});
    ASSERT_EQ(lines.size(), 1u) << override_text;
    EXPECT_TRUE(lines[0].starts_with("--set " + override_text + ": ")) << lines[0];
    EXPECT_TRUE(creepcontact::test::says(lines[0], facts));
  };
  expect("time.ende=1", {"time.ende: ", "'end'"});
  expect("tiem.end=1", {"tiem: ", "'time'"});
  expect("materials.stel.young_modulus=1", {"materials.stel: ", "'steel'"});
  expect("contacts.1.gap=0", {"contacts.1: ", "'1'", "0 to 0"});
  expect("contacts.gap=0", {"contacts.gap: ", "'gap'"});
  expect_mistake(minimal, {"--set contacts.0.gap=1: contacts: ", "table", "list"}, {"contacts.0.gap=1"});
  expect("time.end", {"no '='", "key.path=value"});
  expect("=1", {"valid key", "'='", "key.path=value"});
  expect("time..end=1", {"valid key", "'='"});
  expect("time.end.x=1", {"time.end: ", ">= 0"});
}

TEST(ConfigOverrides, BrokenListIsNoWord) {
  const std::vector<std::string> lines = mistakes(minimal, {"time.output=[1, 2"});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].rfind("--set time.output=[1, 2: ", 0), 0u) << lines[0];
}

}  // namespace
}  // namespace creepcontact::config
