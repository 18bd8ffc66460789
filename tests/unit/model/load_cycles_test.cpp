#include "creepcontact/model/load_cycles.hpp"

#include "creepcontact/base/error.hpp"
#include "support/run/blocks.hpp"

namespace creepcontact::run::test {
namespace {

using Times = std::vector<double>;

/// The blocks for ten cycles of 10, under a pressure on a side.
config::Config with_pressure(const Case& blocks, const std::string& pressure, const std::vector<std::string>& more = {},
                             const std::string& end = "100") {
  std::vector<std::string> overrides{"time.cycle=10", "time.end=" + end};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return blocks.config("[[loads]]\non = 'side_x'\npressure = " + pressure + "\n", overrides);
}

LoadCycles cycles_of(const config::Config& config) {
  return build_model(config).cycles.value();
}

TEST(LoadCycles, EndWithThePeriod) {
  const Case blocks;
  const LoadCycles cycles = cycles_of(with_pressure(blocks, "0.1", {}, "35"));
  EXPECT_EQ(cycles.count(), 3);
  EXPECT_EQ(cycles.begin(0), 0);
  EXPECT_EQ(cycles.end(0), 10);
  EXPECT_EQ(cycles.begin(2), 20);
  EXPECT_EQ(cycles.ending_at(20), 1);
  EXPECT_FALSE(cycles.ending_at(35));
  EXPECT_EQ(cycles.ended_by(29), 2);
  EXPECT_EQ(cycles.ended_by(30), 3);
}

TEST(LoadCycles, APeriodThatDividesTheEndUpToRounding) {
  const Case blocks;
  const Model model = build_model(blocks.config("", {"time.cycle=0.1", "time.end=100"}));
  EXPECT_EQ(model.cycles->count(), 1000);
  EXPECT_EQ(model.cycles->end(999), 100);
  EXPECT_EQ(model.breakpoints.size(), 999U);
}

TEST(LoadCycles, ARepeatedTableRepeatsInAllButTheFirst) {
  const Case blocks;
  const Model model =
      build_model(with_pressure(blocks, "{ t = [0, 2, 8, 9], values = [0, 0.1, 0.1, 0], period = 10 }"));
  EXPECT_FALSE(model.cycles->repeats(0));
  for (int cycle = 1; cycle < 10; ++cycle) EXPECT_TRUE(model.cycles->repeats(cycle)) << model.cycles->difference(cycle);
  EXPECT_EQ(model.breakpoints.size(), 39U);
  EXPECT_EQ(model.distinct_breakpoints(), (Times{2, 8, 9, 10}));
  EXPECT_FALSE(model.cycles->jumps_at(2));
}

/// Samples of a run of a thousand cycles are farther apart than the pieces of one.
TEST(LoadCycles, CornersOfAnExpressionInEveryCycle) {
  const Case blocks;
  const std::string pulses = "'0.1*min(1, mod(t, 10)/0.001, (10 - mod(t, 10))/0.002)'";
  const Times breakpoints = build_model(with_pressure(blocks, pulses, {}, "10000")).breakpoints;
  EXPECT_EQ(breakpoints.size(), 3U * 1000 - 1);
  for (const double corner : {9000.001, 9009.998, 9010.0}) {
    const auto next = std::ranges::lower_bound(breakpoints, corner - 1e-6);
    ASSERT_NE(next, breakpoints.end());
    EXPECT_NEAR(*next, corner, 1e-7);
  }
}

TEST(LoadCycles, WhatDiffersIsNamed) {
  const Case blocks;
  const LoadCycles ramp = cycles_of(with_pressure(blocks, "'0.1*min(t/15, 1)'"));
  EXPECT_EQ(ramp.difference(1), "loads[0].pressure");
  EXPECT_EQ(ramp.difference(2), "loads[0].pressure");
  EXPECT_EQ(ramp.difference(3), "");
  const LoadCycles points = cycles_of(with_pressure(blocks, "0.1", {"time.breakpoints=[55]"}));
  EXPECT_EQ(points.difference(4), "");
  EXPECT_EQ(points.difference(5), "time.breakpoints");
  EXPECT_EQ(points.difference(6), "time.breakpoints");
  EXPECT_EQ(points.difference(7), "");
  const LoadCycles support = cycles_of(with_pressure(blocks, "0.1", {"supports.3.until=40"}));
  EXPECT_EQ(support.difference(3), "");
  EXPECT_NE(support.difference(4), "");
  EXPECT_EQ(support.difference(5), "");
  EXPECT_TRUE(support.jumps_at(40));
}

/// A pulse in one cycle of a thousand, in a pressure and in a creep rate.
TEST(LoadCycles, OneCycleThatDiffers) {
  const Case blocks;
  const std::string factor = "(t > 2013 && t < 2013.5 ? 1.5 : 1)";
  const std::vector<std::string> rate{"materials.soft.creep.0={ law = 'expression', rate = '1e-3*q^4*" + factor +
                                      "' }"};
  for (const Model& model : {build_model(with_pressure(blocks, "'0.1*" + factor + "'", {}, "10000")),
                             build_model(with_pressure(blocks, "0.1", rate, "10000"))}) {
    EXPECT_EQ(model.breakpoints.size(), 999U + 2);
    for (std::int64_t cycle = 1; cycle < 1000; ++cycle)
      EXPECT_EQ(model.cycles->repeats(cycle), cycle != 201 && cycle != 202) << cycle;
    EXPECT_TRUE(model.cycles->jumps_at(2013) && model.cycles->jumps_at(2013.5));
  }
}

TEST(LoadCycles, JumpsAreSeen) {
  const Case blocks;
  const LoadCycles cycles =
      cycles_of(with_pressure(blocks, "{ t = [0, 2, 2, 8, 8], values = [0, 0, 0.1, 0.1, 0], period = 10 }"));
  for (const double t : {2.0, 8.0, 42.0, 98.0}) EXPECT_TRUE(cycles.jumps_at(t)) << t;
  for (const double t : {10.0, 50.0}) EXPECT_FALSE(cycles.jumps_at(t)) << t;
}

void expect_refused(const config::Config& config, std::initializer_list<std::string_view> facts) {
  EXPECT_TRUE(says(message_of<ConfigError>([&] { build_model(config); }), facts));
}

TEST(LoadCycles, WhatCannotHaveThemIsRefused) {
  const Case blocks;
  expect_refused(blocks.config("", {"time.cycle=1", "materials.soft.creep=[]", "materials.hard.creep=[]"}),
                 {"'cycle'", "creeps"});
  expect_refused(blocks.config("", {"time.cycle=1", "time.jump_cycles=true", "contacts.0.friction=0.1"}),
                 {"'jump_cycles'", "'lower_top-upper_bottom'", "friction"});
  expect_refused(with_pressure(blocks, "'0.001*t'", {"time.jump_cycles=true"}),
                 {"'jump_cycles'", "loads[0].pressure", "time.cycle"});
  expect_refused(blocks.config("", {"time.cycle=4", "time.jump_cycles=true"}),
                 {"'jump_cycles'", "one cycle", "time.end"});
  const std::vector<std::string> ageing{"materials.soft.creep.0.law=ageing", "materials.soft.creep.0.m=1",
                                        "materials.hard.creep.0.law=ageing", "materials.hard.creep.0.m=1",
                                        "time.integrator=isochronous",       "time.cycle=1"};
  EXPECT_NO_THROW(build_model(blocks.config("", ageing)));
  std::vector<std::string> jumping = ageing;
  jumping.emplace_back("time.jump_cycles=true");
  expect_refused(blocks.config("", jumping), {"'jump_cycles'", "material '", "ageing"});
}

}  // namespace
}  // namespace creepcontact::run::test
