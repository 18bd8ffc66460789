#include <fmt/format.h>

#include "config_fixture.hpp"
#include "creepcontact/config/study.hpp"
#include "support/says.hpp"

namespace creepcontact::config {
namespace {

/// The place in line 12, where what is appended to `minimal` begins, and the facts of the message.
void expect_syntax(const std::string& appended, int column, std::initializer_list<std::string_view> facts) {
  const std::vector<std::string> lines = mistakes(minimal + appended + '\n');
  ASSERT_EQ(lines.size(), 1u) << appended;
  EXPECT_TRUE(lines[0].starts_with(fmt::format("cases/block.toml:12:{}: ", column))) << lines[0];
  EXPECT_TRUE(creepcontact::test::says(lines[0], facts)) << appended;
}

TEST(ConfigSyntax, TextWithoutQuotationMarks) {
  expect_syntax("integrator = cvode_bdf", 14, {"'cvode_bdf'", "integrator = \"cvode_bdf\""});
  expect_syntax("law = norton", 8, {"'norton'", "law = \"norton\""});
  expect_syntax("c = { law = norton, A = 1 }", 14, {"'norton'", "law = \"norton\""});
  expect_syntax("title = My first run # one", 9, {"'My first run'", "title = \"My first run\""});
  expect_syntax("file = ../mesh.msh", 8, {"'../mesh.msh'", "file = \"../mesh.msh\""});
  expect_syntax("on = [bore, rim]", 7, {"'bore'", "\"bore\""});
  expect_syntax("title = \"run", 13, {"quotation mark"});
  expect_syntax("file = \"C:\\mesh.msh\"", 12, {"backslash", "/", "quotation marks"});
}

TEST(ConfigSyntax, Numbers) {
  expect_syntax("A = 1,5e-3", 6, {"'1,5e-3'", "comma", "1.5e-3"});
  expect_syntax("c = { A = 1,5, n = 2 }", 14, {"'1,5'", "comma", "1.5"});
  expect_syntax("step = 1.", 10, {"'1.'", "1.0"});
  expect_syntax("step = 010", 11, {"'010'", "zeros"});
  expect_syntax("step = 1e-3 h", 13, {"'1e-3 h'", "units"});
  expect_syntax("pressure = 100*t", 12, {"'100*t'", "expression", "pressure = \"100*t\""});
  expect_syntax("fields = True", 10, {"'True'", "fields = true"});
}

TEST(ConfigSyntax, Lines) {
  expect_syntax("// a comment", 1, {"comment", "#"});
  expect_syntax("step : 1", 6, {"'step : 1'", "key = value"});
  expect_syntax("end = 5", 7, {"second"});
  expect_syntax("output = { first = 1,\n count = 3 }", 22, {"braces", "comma"});
}

TEST(ConfigSyntax, LongLines) {
  for (const std::string& begin : {std::string("title = a"), std::string("[a"), std::string("A = 1,5")}) {
    const std::vector<std::string> lines = mistakes(minimal + begin + std::string(1000000, 'a'));
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_LT(lines[0].size(), 1000u);
  }
}

TEST(ConfigSyntax, OneBracketOrTwo) {
  const std::string support = "\non = \"a\"\ndisplacement = { x = 0 }\n";
  const auto expect = [](const std::string& appended, int line, std::initializer_list<std::string_view> facts) {
    const std::vector<std::string> lines = mistakes(minimal + appended);
    ASSERT_EQ(lines.size(), 1u) << appended;
    EXPECT_TRUE(lines[0].starts_with(fmt::format("cases/block.toml:{}:1: ", line))) << lines[0];
    EXPECT_TRUE(creepcontact::test::says(lines[0], facts)) << appended;
  };
  expect("[supports]" + support, 12, {"supports: ", "[supports]", "[[supports]]"});
  expect("[materials.steel.creep]\nlaw = \"norton\"\n", 12,
         {"materials.steel.creep: ", "[materials.steel.creep]", "[[materials.steel.creep]]"});
  expect("[supports]" + support + "[supports]" + support, 15, {"[supports]", "line 12", "[[supports]]"});
  expect("[supports]" + support + "[[supports]]" + support, 15, {"[supports]", "line 12", "[[supports]]"});
  expect("[bodies.block]\nregion = \"b\"\n", 12, {"[bodies.block]", "line 3"});
  expect("[[output]]\nfields = false\n", 12, {"output: ", "[[output]]", "[output]"});
  expect("[[materials.gold]]\nyoung_modulus = 1\npoisson_ratio = 0\n", 12,
         {"materials.gold: ", "[[materials.gold]]", "[materials.gold]"});
}

TEST(ConfigSyntax, StudyForARunAndRunForAStudy) {
  const std::string study = "base = \"block.toml\"\n[[axes]]\nkey = \"time.step\"\nvalues = [1, 2]\n";
  ASSERT_EQ(mistakes(study).size(), 1u);
  EXPECT_TRUE(creepcontact::test::says(mistakes(study)[0],
                                       {"cases/block.toml: ", "'base'", "creepcontact study cases/block.toml"}));
  EXPECT_TRUE(creepcontact::test::says(
      creepcontact::test::message_of<ConfigError>([] { parse_study(minimal, "cases/block.toml"); }),
      {"cases/block.toml: ", "creepcontact run cases/block.toml"}));
}

}  // namespace
}  // namespace creepcontact::config
