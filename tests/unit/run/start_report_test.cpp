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
  EXPECT_TRUE(contains(text,
                       "contact 'lower_top-upper_bottom': normal force 2, peak pressure 1, the whole surface is "
                       "in contact\n"))
      << text;
  // stress / E over A stress^n
  EXPECT_TRUE(contains(text, "body 'lower': largest von Mises stress 1 at ")) << text;
  EXPECT_TRUE(contains(text, "; relaxes within 10 (0.5 time.end), fastest within 10 (0.5 time.end) at ")) << text;
  EXPECT_TRUE(contains(text, "; relaxes within 5 (0.25 time.end), fastest within 5 (0.25 time.end) at ")) << text;
  EXPECT_TRUE(text.ends_with("no mistakes found\n")) << text;
  EXPECT_FALSE(std::filesystem::exists(blocks / "results"));
}

TEST(StartReport, HardeningFromAnInfiniteRateOn) {
  // A q^n t^m = 1 / E
  const std::string text =
      start_of(Case(), {"materials.soft.creep=[{ law = 'time_hardening', A = 1e-3, n = 4, m = 0.5 }]"});
  EXPECT_TRUE(contains(text, "; relaxes within 100 (25 time.end), fastest within 100 ")) << text;
}

TEST(StartReport, BodiesThatDoNotRelax) {
  const Case blocks;
  EXPECT_TRUE(contains(start_of(blocks, {"materials.soft.creep=[]"}), "body 'lower': largest von Mises stress 1 at "));
  EXPECT_TRUE(contains(start_of(blocks, {"materials.soft.creep=[]"}), "), elastic\n"));
  const std::string later = start_of(blocks, {"supports.3.displacement.z=-0.025*t"});
  EXPECT_TRUE(contains(later, "touches, no force\n") && contains(later, "no stress that would relax\n")) << later;
  // strains of a Kelvin element end at a tenth of the elastic ones
  const std::string bounded =
      start_of(blocks, {"materials.soft.creep=[{ law = 'kelvin_voigt', compliance = 1e-3, time = 1 }]"});
  EXPECT_TRUE(contains(bounded, "; at this stress and temperature its creep never comes up to the elastic strain\n"))
      << bounded;
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

void expect_same(const Refusals& refusals, const std::string& text) {
  EXPECT_TRUE(contains(refusals.run, text)) << refusals.run;
  EXPECT_EQ(refusals.run, refusals.check);
  EXPECT_EQ(refusals.run, refusals.start);
}

TEST(StartReport, RunAndCheckRefuseTheSame) {
  const Case blocks;
  const Overrides lifted{"supports.3.on=side_x", "supports.3.displacement={x=0}",
                         "loads=[{on='top', traction=[0, 0, 1]}]"};
  expect_same(refusals<ModelError>(blocks, lifted), "the loads move the assembly along this motion and no contact");
  const Overrides unloaded{"supports.3.displacement.z=0"};
  expect_same(refusals<ModelError>(blocks, unloaded), "the bodies are not loaded");
  expect_same(refusals<ConfigError>(blocks, {}, "blocks.geo/below"), "is not a directory; choose another directory");
  expect_same(refusals<ConfigError>(blocks, {}, "blocks.geo"), "is a file; choose another directory");
  expect_same(refusals<ConfigError>(blocks, {}, "none", true), "there is no checkpoint");
}

TEST(StartReport, WhatASolveAloneShows) {
  const Case blocks;
  const Overrides pascals{"materials.soft.young_modulus=1e8", "materials.hard.young_modulus=2e8"};
  const std::string refused = message_of<ModelError>([&] { start_of(blocks, pascals); });
  EXPECT_TRUE(contains(refused, "body 'lower' would relax ")) << refused;
  EXPECT_EQ(refused, refusals<ModelError>(blocks, pascals).run);
}

TEST(StartReport, OutputDirectoriesAreCheckedBeforeMeshing) {
  const Case blocks;
  config::Config config = blocks.config();
  config.mesh.file = blocks / "none.geo";
  std::ostringstream report;
  EXPECT_TRUE(
      contains(message_of<ConfigError>([&] { check(config, report, {.output = (blocks / "blocks.geo").string()}); }),
               "is a file"));
}

TEST(StartReport, TwiceAsManySubstepsOfTheFirstLoad) {
  const std::string text = start_of(Case(), {"contacts.0.friction=0.2", "contact_solver.initial_substeps=4"});
  EXPECT_TRUE(contains(text, "    contact_solver.initial_substeps = 8 instead of 4 changes the normal force by "))
      << text;
  EXPECT_TRUE(contains(text, ", largest slip ")) << text;
}

}  // namespace
}  // namespace creepcontact::run::test
