// Numbers and keys that are right in kind and beyond all measure.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "config_fixture.hpp"
#include "creepcontact/config/study.hpp"
#include "support/says.hpp"

namespace creepcontact::config {
namespace bounds_tests {
namespace {

const std::string at_12 = "cases/block.toml:12:";

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// Among the mistakes of a configuration is one that names these facts.
void expect_found(const std::string& text, std::initializer_list<std::string_view> facts,
                  const std::vector<std::string>& overrides = {}) {
  const std::vector<std::string> lines = mistakes(text, overrides);
  for (const std::string& line : lines)
    if (creepcontact::test::says(line, facts)) return;
  ADD_FAILURE() << (lines.empty() ? "no mistake found" : lines[0].substr(0, 300)) << "\nin place of\n"
                << fmt::format("{}", fmt::join(facts, ", "));
}

TEST(ConfigBounds, OutputTimes) {
  expect_found(minimal + "output = { count = 2147483647 }\n",
               {at_12 + "20: time.output.count: ", "2147483647", "[2, 100000]"});
  EXPECT_EQ(parse_text(minimal + "output = { count = 1000 }\n").time.output.size(), 1001U);
}

TEST(ConfigBounds, PeriodsThatRepeatPoints) {
  const std::string table = minimal + "[[loads]]\non = \"a\"\npressure = { t = [0, 1e-300], values = [1, 2], period = ";
  expect_found(table + "1e-300 }\n", {"cases/block.toml:14:57: loads[0].pressure.period: ", "2 points", "1e+302"});
  expect_found(table + "1e-3 }\n", {"loads[0].pressure.period: ", "2 points", "1e+06"},
               {"time.end=1e6", "loads.0.pressure.period=1"});
  EXPECT_NO_THROW(parse_text(table + "1e-3 }\n"));
}

TEST(ConfigBounds, FixedSteps) {
  expect_found(minimal + "step = 1e-300\n", {at_12 + "8: time.step: ", "1e+302", "1e-300", "time.end = 100", "1e+09"});
  expect_found(minimal + "step_factor = 1e-300\n", {at_12 + "15: time.step_factor: ", "1e-300"});
}

TEST(ConfigBounds, Iterations) {
  expect_found(minimal + "[contact_solver]\nmax_iterations = 2147483647\n", {"[1, 1000000]"});
  expect_found(minimal + "inner_anderson = 2147483647\n", {"[0, 100]"});
}

TEST(ConfigBounds, KeysOfManyParts) {
  const std::string limit = "20 parts";
  const std::string parts = repeated("a.", 50000) + "a";
  expect_found("[" + parts + "]\nx = 1\n", {"cases/block.toml:1:41: ", limit});
  expect_found("\n[[" + parts + "]]\nx = 1\n", {"cases/block.toml:2:42: ", limit});
  expect_found(parts + " = 1\n", {limit});
  expect_found("x = { " + parts + " = 1 }\n", {limit});
  expect_found("x = { y = 1, " + repeated("\"a=\" . 'b#' .", 25000) + "c = 1 }\n", {limit});
  expect_found(minimal, {"--set " + parts + "=1: ", limit}, {parts + "=1"});
  expect_found(minimal, {limit}, {"time.end={" + parts + "=1}"});
}

TEST(ConfigBounds, DotsThatAreNoKeys) {
  const std::string dots = repeated(".", 100);
  const std::string title = R"(title = "\"a)" + dots + "\"  # " + dots + "\n";
  EXPECT_NO_THROW(parse_text(title + minimal));
  for (const std::string mark : {"\"\"\"", "'''"})
    EXPECT_NO_THROW(parse_text("title = " + mark + "\"'" + dots + "\n" + dots + mark.substr(1) + mark + "\n" + minimal))
        << mark;
  EXPECT_NO_THROW(parse_text("units = ''\ntitle = 'a\\'# " + dots + "\n" + minimal));
  EXPECT_NO_THROW(parse_text(minimal + "output = [" + repeated("1.5, ", 100) + "2]\n"));
  // What comes after a string is seen all the same.
  expect_found("title = \"\"\"a\"\"\"\"\"\n" + repeated("a.", 100) + "a = 1\n",
               {"cases/block.toml:2:40: ", "20 parts"});
}

TEST(ConfigBounds, NestedValues) {
  for (const auto& [open, close] : {std::pair("[", "]"), std::pair("{a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a=", "}")}) {
    expect_found("x = " + repeated(open, 100000) + "1" + repeated(close, 100000), {"cases/block.toml:1:"});
    // As deep as toml++ goes.
    expect_found("x = " + repeated(open, 250) + "1" + repeated(close, 250), {"x: unknown key"});
    const std::string study = "base = 'a.toml'\n[[runs]]\nset.x = " + repeated(open, 250) + "1" + repeated(close, 250);
    EXPECT_EQ(parse_study(study, "study.toml").runs.size(), 1U);
  }
}

TEST(ConfigBounds, RunsOfAStudy) {
  std::string study = "base = 'a.toml'\n";
  for (int axis = 0; axis < 20; ++axis)
    study += fmt::format("[[axes]]\nkey = 'materials.m{}.A'\nvalues = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]\n", axis);
  EXPECT_TRUE(
      creepcontact::test::says(creepcontact::test::message_of<ConfigError>([&] { parse_study(study, "study.toml"); }),
                               {"study.toml:2:1: axes[0]: ", "1e+20 runs", "100000 runs", "zip"}));
}

}  // namespace
}  // namespace bounds_tests
}  // namespace creepcontact::config
