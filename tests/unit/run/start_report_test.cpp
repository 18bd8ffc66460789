#include "../../../src/run/start_report.hpp"

#include <fmt/format.h>

#include <sstream>

#include "creepcontact/base/error.hpp"
#include "creepcontact/run/check.hpp"
#include "creepcontact/run/run.hpp"
#include "support/run/blocks.hpp"

namespace creepcontact::run::test {
namespace {

using Overrides = std::vector<std::string>;

std::string start_of(const Case& blocks, const Overrides& overrides = {}) {
  std::ostringstream report;
  check(blocks.config("", overrides), report, {.output = (blocks / "results").string(), .start = true});
  return report.str();
}

TEST(StartReport, UniformStress) {
  const Case blocks;
  const std::string text = start_of(blocks, {"time.end=20"});
  EXPECT_TRUE(says(text, {"contact 'lower_top-upper_bottom': ", "force 2,", "pressure 1,", "whole"}));
  // stress / E over A stress^n
  EXPECT_TRUE(says(text, {"body 'lower': ", "stress 1 at ", " 10 (0.5 time.end)", " 10 (0.5 time.end) at "}));
  EXPECT_TRUE(says(text, {"body 'upper': ", "stress 1 at ", " 5 (0.25 time.end)", " 5 (0.25 time.end) at "}));
  EXPECT_TRUE(text.ends_with("no mistakes found\n")) << text;
  EXPECT_FALSE(std::filesystem::exists(blocks / "results"));
}

TEST(StartReport, HardeningFromAnInfiniteRateOn) {
  // A q^n t^m = 1 / E
  const std::string text =
      start_of(Case(), {"materials.soft.creep=[{ law = 'time_hardening', A = 1e-3, n = 4, m = 0.5 }]"});
  EXPECT_TRUE(says(text, {" 100 (25 time.end)", " 100 "}));
}

TEST(StartReport, BodiesThatDoNotRelax) {
  const Case blocks;
  EXPECT_TRUE(says(start_of(blocks, {"materials.soft.creep=[]"}), {"body 'lower': ", "stress 1 at ", "), elastic\n"}));
  const std::string later = start_of(blocks, {"supports.3.displacement.z=-0.025*t"});
  EXPECT_TRUE(says(later, {"touches"}));
  EXPECT_TRUE(says(later, {"body 'lower': ", "no stress"}));
  // strains of a Kelvin element end at a tenth of the elastic ones
  const std::string bounded =
      start_of(blocks, {"materials.soft.creep=[{ law = 'kelvin_voigt', compliance = 1e-3, time = 1 }]"});
  EXPECT_TRUE(says(bounded, {"body 'lower': ", "never", "elastic strain\n"}));
}

/// What a run and a check are refused with.
struct Refusals {
  std::string run, check, start;
};

template <class Kind>
Refusals refusals(const Case& blocks, const Overrides& overrides, const std::string& output = "results",
                  bool resume = false) {
  const std::string directory = (blocks / output).string();
  const auto checked = [&](bool start) {
    std::ostringstream report;
    check(blocks.config("", overrides), report, {.output = directory, .resume = resume, .start = start});
  };
  return {message_of<Kind>([&] { run(blocks.config("", overrides), {.output = directory, .resume = resume}); }),
          message_of<Kind>([&] { checked(false); }), message_of<Kind>([&] { checked(true); })};
}

void expect_same(const Refusals& refusals, std::initializer_list<std::string_view> facts) {
  EXPECT_TRUE(says(refusals.run, facts));
  EXPECT_EQ(refusals.run, refusals.check);
  EXPECT_EQ(refusals.run, refusals.start);
}

TEST(StartReport, RunAndCheckRefuseTheSame) {
  const Case blocks;
  const Overrides lifted{"supports.3.on=side_x", "supports.3.displacement={x=0}",
                         "loads=[{on='top', traction=[0, 0, 1]}]"};
  expect_same(refusals<ModelError>(blocks, lifted), {"translation along z", "t = ", "loads"});
  const Overrides unloaded{"supports.3.displacement.z=0"};
  expect_same(refusals<ModelError>(blocks, unloaded), {"not loaded"});
  expect_same(refusals<ConfigError>(blocks, {}, "blocks.geo/below"), {"blocks.geo/below: ", "blocks.geo'", "--output"});
  expect_same(refusals<ConfigError>(blocks, {}, "blocks.geo"), {"blocks.geo: ", "file", "--output"});
  expect_same(refusals<ConfigError>(blocks, {}, "none", true), {"none/checkpoint.h5'", "--resume"});
}

TEST(StartReport, WhatASolveAloneShows) {
  const Case blocks;
  const Overrides pascals{"materials.soft.young_modulus=1e8", "materials.hard.young_modulus=2e8"};
  const std::string refused = message_of<ModelError>([&] { start_of(blocks, pascals); });
  EXPECT_TRUE(says(refused, {"body 'lower'", "material 'soft'", "young_modulus"}));
  EXPECT_EQ(refused, refusals<ModelError>(blocks, pascals).run);
}

TEST(StartReport, OutputDirectoriesAreCheckedBeforeMeshing) {
  const Case blocks;
  config::Config config = blocks.config();
  config.mesh.file = blocks / "none.geo";
  std::ostringstream report;
  EXPECT_TRUE(
      says(message_of<ConfigError>([&] { check(config, report, {.output = (blocks / "blocks.geo").string()}); }),
           {"blocks.geo: ", "file", "--output"}));
}

TEST(StartReport, TwiceAsManySubstepsOfTheFirstLoad) {
  const std::string text = start_of(Case(), {"contacts.0.friction=0.2", "contact_solver.initial_substeps=4"});
  EXPECT_TRUE(says(text, {"contact_solver.initial_substeps = 8", " 4 ", "slip "}));
}

}  // namespace
}  // namespace creepcontact::run::test
