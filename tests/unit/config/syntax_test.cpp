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
  expect_syntax("integrator = cvode_bdf", 14, {"'cvode_bdf'", "quotation marks: integrator = \"cvode_bdf\""});
  expect_syntax("law = norton", 8, {"'norton'", "quotation marks: law = \"norton\""});
  expect_syntax("c = { law = norton, A = 1 }", 14, {"'norton'", "quotation marks: law = \"norton\""});
  expect_syntax("title = My first run # one", 9, {"'My first run'", "quotation marks: title = \"My first run\""});
  expect_syntax("file = ../mesh.msh", 8, {"'../mesh.msh'", "quotation marks: file = \"../mesh.msh\""});
  expect_syntax("on = [bore, rim]", 7, {"'bore'", "quotation marks: \"bore\""});
  expect_syntax("title = \"run", 13, {"no closing quotation mark"});
  expect_syntax("file = \"C:\\mesh.msh\"", 12, {"backslash", "write / in paths", "single quotation marks"});
}

TEST(ConfigSyntax, Numbers) {
  expect_syntax("A = 1,5e-3", 6, {"'1,5e-3'", "decimal comma", "1.5e-3"});
  expect_syntax("c = { A = 1,5, n = 2 }", 14, {"'1,5'", "decimal comma", "1.5"});
  expect_syntax("step = 1.", 10, {"'1.'", "digits on both sides", "1.0"});
  expect_syntax("step = 010", 11, {"'010'", "zeros"});
  expect_syntax("step = 1e-3 h", 13, {"'1e-3 h'", "without units"});
  expect_syntax("pressure = 100*t", 12, {"'100*t'", "expression", "quotation marks: pressure = \"100*t\""});
  expect_syntax("fields = True", 10, {"'True'", "fields = true"});
}

TEST(ConfigSyntax, Lines) {
  expect_syntax("// a comment", 1, {"comment", "#"});
  expect_syntax("step : 1", 6, {"'step : 1'", "key = value"});
  expect_syntax("end = 5", 7, {"the key", "second time"});
  expect_syntax("output = { first = 1,\n count = 3 }", 22, {"braces", "without a comma after its last key"});
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
  expect("[supports]" + support, 12, {"supports: ", "[supports]", "allowed: [[supports]]"});
  expect("[materials.steel.creep]\nlaw = \"norton\"\n", 12,
         {"materials.steel.creep: ", "[materials.steel.creep]", "allowed: [[materials.steel.creep]]"});
  expect("[supports]" + support + "[supports]" + support, 15, {"[supports]", "line 12", "[[supports]]"});
  expect("[supports]" + support + "[[supports]]" + support, 15, {"[supports]", "line 12", "[[supports]]"});
  expect("[bodies.block]\nregion = \"b\"\n", 12, {"[bodies.block]", "line 3"});
  expect("[[output]]\nfields = false\n", 12, {"output: ", "[[output]]", "allowed: [output]"});
  expect("[[materials.gold]]\nyoung_modulus = 1\npoisson_ratio = 0\n", 12,
         {"materials.gold: ", "[[materials.gold]]", "allowed: [materials.gold]"});
}

TEST(ConfigSyntax, StudyForARunAndRunForAStudy) {
  const std::string study = "base = \"block.toml\"\n[[axes]]\nkey = \"time.step\"\nvalues = [1, 2]\n";
  ASSERT_EQ(mistakes(study).size(), 1u);
  EXPECT_TRUE(creepcontact::test::says(mistakes(study)[0],
                                       {"cases/block.toml: ", "'base'", "creepcontact study cases/block.toml"}));
  try {
    parse_study(minimal, "cases/block.toml");
    FAIL() << "no mistake found";
  } catch (const ConfigError& error) {
    EXPECT_TRUE(creepcontact::test::says(error.what(), {"cases/block.toml: ", "creepcontact run cases/block.toml"}));
  }
}

}  // namespace
}  // namespace creepcontact::config
