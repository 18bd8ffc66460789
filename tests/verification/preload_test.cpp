/// Preload by force: bars between two walls, tightened at a cut, under a head or at a curved seat.

#include <fmt/format.h>

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/interrupted.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace preload_cases {
namespace {

constexpr double modulus = 2e5, half = 5, force = 100;  // bars of section 1

std::string bar_geo() {
  return test::boxes_geo(
      {{"low", {0, 0, 0}, {1, 1, half}, {2, 2, 4}}, {"high", {0, 0, half}, {1, 1, half}, {2, 2, 4}}});
}

/// Two halves of a bar between walls.
std::string bar(const std::string& contact, double A = 0, double n = 1) {
  return "[mesh]\nfile = \"case.geo\"\norder = 2\n" + test::body("low", modulus, 0, A, n) +
         test::body("high", modulus, 0, A, n) + test::support("low_x0", "x") + test::support("low_y0", "y") +
         test::support("low_z0", "z") + test::support("high_x0", "x") + test::support("high_y0", "y") +
         test::support("high_z1", "z") + test::contact_table("low_z1", "high_z0", contact) +
         test::probe("wall", "reaction_z", "on = \"low_z0\"");
}

const std::string interference = "contacts/low_z1~1high_z0/interference";

TEST(Preload, TensionOfATiedCutRelaxesAsABarDoes) {
  constexpr double A = 1e-12, end = 1000;
  const test::Outcome outcome =
      test::run_case(bar(fmt::format("type = \"tied\"\npreload = {{ force = {} }}", force), A, 3) +
                         fmt::format("[time]\nend = {}\ntolerance = 1e-6\n", end),
                     bar_geo());
  EXPECT_RELATIVE(outcome.summary.number(interference), force * 2 * half / modulus, 1e-9);
  EXPECT_RELATIVE(outcome.summary.number("contacts/low_z1~1high_z0/initial_normal_force"), force, 1e-9);
  EXPECT_RELATIVE(outcome.history.at("wall", 0), -force, 1e-9);  // the wall pulls the bar down
  // d sigma/dt = -E A sigma^3
  EXPECT_RELATIVE(outcome.history.at("wall", end), -force / std::sqrt(1 + 2 * modulus * A * force * force * end), 1e-5);
}

TEST(Preload, PressesAUnilateralContactWithTheLoadsOfTheStart) {
  const std::string pressed =
      bar("preload = { force = 100 }") + "[[loads]]\nbody = \"high\"\nbody_force = [0, 0, -4]\n[time]\nend = 1\n";
  const test::Outcome outcome = test::run_case(pressed, bar_geo());
  EXPECT_RELATIVE(outcome.summary.number("contacts/low_z1~1high_z0/initial_normal_force"), force, 1e-9);
  EXPECT_RELATIVE(outcome.history.at("wall", 0), force, 1e-9);
  // Halves of the weight would press without interference: 4 x 5 over two equal springs, one quarter of it.
  const double of_weight = 4 * half * half / 2 / (2 * half);
  EXPECT_RELATIVE(outcome.summary.number(interference), (force - of_weight) * 2 * half / modulus, 1e-6);
}

/// The stress of the preload is beyond the yield stress of a viscoplastic law: the force falls at once, and is said.
TEST(Preload, WarnsIfTheMaterialYields) {
  const auto run = [](double yield) {
    std::string toml = bar("preload = { force = 100 }") + "[time]\nend = 1000\n";
    const std::string law = fmt::format("[{{law=\"chaboche\",K=20,n=5,yield={},Q=0,b=1,C=[1e3],gamma=[0]}}]", yield);
    testing::internal::CaptureStderr();
    const test::Outcome outcome =
        test::run_case(toml, bar_geo(), {"materials.low.creep=" + law, "materials.high.creep=" + law});
    return std::pair(testing::internal::GetCapturedStderr(), outcome.history.at("wall", 1000));
  };
  const auto [warnings, left] = run(80);
  EXPECT_LT(left, 95);
  EXPECT_TRUE(test::says(warnings, {"contact 'low_z1/high_z0'", "yields", "preload.force", "100"}));
  EXPECT_EQ(run(200).first.find("preload.force"), std::string::npos);
}

/// A plate on two bars, and a bar on top of it: the second tightening unloads the first.
TEST(Preload, SeveralAtOnceAndOneAfterTheOther) {
  const std::string geo = test::boxes_geo({{"a", {0, 0, 0}, {1, 1, 3}, {2, 2, 2}},
                                           {"b", {4, 0, 0}, {1, 1, 3}, {2, 2, 2}},
                                           {"plate", {0, 0, 3}, {5, 1, 1}, {10, 2, 2}},
                                           {"top", {0, 0, 4}, {5, 1, 3}, {10, 2, 2}}});
  const auto assembly = [](double later) {
    std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n";
    for (const char* name : {"a", "b", "plate", "top"}) toml += test::body(name, modulus, 0.3);
    for (const char* wall : {"a_z0", "b_z0", "top_z1"})
      for (const char* component : {"x", "y", "z"}) toml += test::support(wall, component);
    toml += test::support("plate_x0", "x") + test::support("plate_y0", "y");
    toml += test::contact_table("a_z1", "plate_z0", "preload = { force = 30 }") +
            test::contact_table("b_z1", "plate_z0", fmt::format("preload = {{ force = 20, at = {} }}", later)) +
            test::contact_table("top_z0", "plate_z1");
    return toml + "[time]\nend = 2\noutput = [0, 0.5, 1, 2]\n" + test::probe("left", "reaction_z", "on = \"a_z0\"") +
           test::probe("right", "reaction_z", "on = \"b_z0\"");
  };
  const test::Table together = test::run_case(assembly(0), geo).history;
  for (const double t : {0.0, 0.5, 2.0}) {
    EXPECT_RELATIVE(together.at("left", t), 30, 1e-8) << t;
    EXPECT_RELATIVE(together.at("right", t), 20, 1e-8) << t;
  }
  const test::Table later = test::run_case(assembly(1), geo).history;
  EXPECT_RELATIVE(later.at("left", 0.5), 30, 1e-8);
  EXPECT_GT(std::abs(later.at("right", 0.5) - 20), 1);
  EXPECT_RELATIVE(later.at("right", 1), 20, 1e-8);
  EXPECT_RELATIVE(later.at("right", 2), 20, 1e-8);
  EXPECT_GT(std::abs(later.at("left", 2) - 30), 0.5);
}

TEST(Preload, WithFrictionAndAGrowingContact) {
  const std::string geo =
      test::boxes_geo({{"low", {-1, -1, 0}, {2, 2, 1}, {6, 6, 2}}, {"high", {-1, -1, 1}, {2, 2, 1}, {4, 4, 2}}});
  const auto pressed = [](double friction) {
    std::string toml =
        "[mesh]\nfile = \"case.geo\"\norder = 2\n" + test::body("low", modulus, 0.3) + test::body("high", modulus, 0.3);
    for (const char* wall : {"low_z0", "high_z1"})
      for (const char* component : {"x", "y", "z"}) toml += test::support(wall, component);
    // Rounded: the contact grows with the force.
    return toml +
           test::contact_table("low_z1", "high_z0",
                               fmt::format("preload = {{ force = 500 }}\nfriction = {}", friction)) +
           "[time]\nend = 1\n" + test::probe("wall", "reaction_z", "on = \"low_z0\"");
  };
  for (const double friction : {0.0, 0.2}) {
    const test::Outcome outcome = test::run_case(pressed(friction), geo);
    EXPECT_RELATIVE(outcome.history.at("wall", 0), 500, 1e-8) << friction;
    EXPECT_RELATIVE(outcome.history.at("wall", 1), 500, 1e-8) << friction;
  }
}

/// A plate that a bar presses on a base near its end; the other end lifts.
std::string eccentric(const std::string& more) {
  std::string toml = test::section_of("plane_strain");
  for (const char* name : {"base", "plate", "bar"}) toml += test::body(name, modulus, 0.3, 1e-14, 4);
  for (const char* wall : {"base_y0", "bar_y1"}) toml += test::support(wall, "x") + test::support(wall, "y");
  return toml + test::contact_table("base_y1", "plate_y0", "friction = 0.1") + more +
         test::probe("bolt", "contact_force_y", "on = \"bar_y0\"") +
         test::probe("seat", "contact_area", "on = \"plate_y0\"");
}

std::string eccentric_geo(double from) {
  return test::regions_geo({{"base", {0, 10, 20}, {0, 2, 4}},
                            {"plate", {0, 10, 20}, {2, 3, 2}},
                            {"bar", {from, from + 1, 4}, {3, 6, 6}},
                            {"nut", {1, 2, 4}, {3, 6, 6}}});
}

TEST(Preload, OfAnEccentricBolt) {
  const std::string bolt = test::contact_table("plate_y1", "bar_y0", "friction = 0.1\npreload = { force = 100 }");
  for (const double from : {4.5, 7.5, 8.5, 9.0}) {
    const test::Outcome outcome = test::run_case(eccentric(bolt + "[time]\nend = 1\n"), eccentric_geo(from));
    EXPECT_RELATIVE(outcome.history.at("bolt", 0), 100, 1e-8) << from;
    if (from < 9) {
      EXPECT_LT(outcome.history.at("seat", 0), 7) << from;
    }
  }
}

TEST(Preload, OneAfterTheOtherIsResumed) {
  std::string toml =
      eccentric(test::contact_table("plate_y1", "bar_y0", "friction = 0.1\npreload = { force = 100 }") +
                test::contact_table("plate_y1", "nut_y0", "friction = 0.1\npreload = { force = 80, at = 10 }"));
  toml += test::body("nut", modulus, 0.3, 1e-14, 4) + test::support("nut_y1", "x") + test::support("nut_y1", "y") +
          "[time]\nend = 30\nintegrator = \"arkode_erk\"\noutput = [5, 10, 20]\n" +
          test::probe("nut", "contact_force_y", "on = \"nut_y0\"");
  const test::CaseDirectory directory(eccentric_geo(8));
  config::Config config = directory.config(toml, {});
  config.output.fields = false;
  test::expect_same_when_resumed(config, directory.path(), {3, 15});
  const test::Table history(directory.path() / "parts" / "history.csv");
  EXPECT_LT(history.at("nut", 5), 40);
  EXPECT_RELATIVE(history.at("nut", 10), 80, 1e-8);
}

std::string three_bars_geo() {
  return test::boxes_geo({{"low", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}},
                          {"middle", {0, 0, 1}, {1, 1, 1}, {2, 2, 2}},
                          {"high", {0, 0, 2}, {1, 1, 1}, {2, 2, 2}}});
}

/// A bar that rests on another one.
std::string resting() {
  std::string toml = bar("preload = { force = 100 }");
  const std::string held = test::support("high_z1", "z");
  return toml.erase(toml.find(held), held.size());
}

/// Without contacts; the ends are held.
std::string three_bars() {
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n";
  for (const char* name : {"low", "middle", "high"})
    toml += test::body(name, modulus, 0) + test::support(std::string(name) + "_x0", "x") +
            test::support(std::string(name) + "_y0", "y");
  return toml + test::support("low_z0", "z") + test::support("high_z1", "z");
}

void expect_unreachable(const std::string& toml, const std::string& geo,
                        std::initializer_list<std::string_view> facts) {
  EXPECT_TRUE(
      test::says(test::message_of<ModelError>([&] { test::run_case(toml + "[time]\nend = 1\n", geo); }), facts));
}

TEST(Preload, ThatCannotBeReachedIsAnErrorWithTheLargestForce) {
  // Held by supports on both sides of the cut.
  const std::string held = test::support("low_z1", "z") + test::support("high_z0", "z");
  expect_unreachable(bar("preload = { force = 100 }") + held, bar_geo(),
                     {"contact 'low_z1/high_z0'", "100", "t = 0", "largest", " 0"});
  // The upper half hangs on the cut and rests on the lower one: it lifts off at its weight.
  std::string toml = three_bars();
  toml += test::contact_table("middle_z1", "high_z0", "type = \"tied\"\npreload = { force = 100 }") +
          test::contact_table("low_z1", "middle_z0") + "[[loads]]\nbody = \"middle\"\nbody_force = [0, 0, -40]\n";
  expect_unreachable(toml, three_bars_geo(), {"contact 'middle_z1/high_z0'", "100", "t = 0", "largest", " 40"});
}

TEST(Preload, ThatLoadsAloneExceedIsAnErrorWithTheSmallestForce) {
  expect_unreachable(resting() + "[[loads]]\nbody = \"high\"\nbody_force = [0, 0, -300]\n", bar_geo(),
                     {"contact 'low_z1/high_z0'", "100", "t = 0", "largest", " 1500: ", "interference"});
  // A load of 300 lifts the middle part off the lower one and presses it on the upper one.
  std::string toml = three_bars() + test::contact_table("low_z1", "middle_z0") +
                     test::contact_table("middle_z1", "high_z0", "preload = { force = 100 }");
  expect_unreachable(toml + "[[loads]]\nbody = \"middle\"\nbody_force = [0, 0, 300]\n", three_bars_geo(),
                     {"contact 'middle_z1/high_z0'", "100", "t = 0", "smallest", " 300: ", "loads"});
}

TEST(Preload, OfContactsInSeriesNamesThem) {
  const std::string geo = three_bars_geo(), toml = three_bars();
  const auto preloads = [&](int second) {
    return test::contact_table("low_z1", "middle_z0", "preload = { force = 100 }") +
           test::contact_table("middle_z1", "high_z0", fmt::format("preload = {{ force = {} }}", second));
  };
  expect_unreachable(toml + preloads(90), geo, {"t = 0", "100 of 'low_z1/middle_z0'", "90 of 'middle_z1/high_z0'"});
  const test::Outcome same = test::run_case(
      toml + preloads(100) + "[time]\nend = 1\n" + test::probe("wall", "reaction_z", "on = \"low_z0\""), geo);
  EXPECT_RELATIVE(same.history.at("wall", 0), 100, 1e-8);
}

}  // namespace
}  // namespace preload_cases
}  // namespace creepcontact
