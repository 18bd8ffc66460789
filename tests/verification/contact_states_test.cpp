/// States of contact over time: separation, closure, first contact from an open gap; blocks in series with two joints;
/// ties against unilateral contact.

#include <fmt/format.h>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/contact_state.hpp"
#include "verification/reference/stack.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace contact_states_tests {
namespace {

using reference::Bar;
using test::Box;
using test::Outcome;

constexpr double n = 4;

/// Boxes on top of each other, free sides, symmetry planes at x = 0 and y = 0: uniaxial stress. Probes: pressure, least
/// and largest pressure of every joint, force on the body above it.
std::string stack_toml(const std::vector<Box>& boxes, const std::vector<Bar>& bars, const std::string& top,
                       const std::string& bottom = "0") {
  std::string toml = "[mesh]\nfile = \"case.geo\"\n";
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    toml += test::body(boxes[i].name, bars[i].young_modulus, 0.3, bars[i].A, n);
    toml += test::support(boxes[i].name + "_x0", "x") + test::support(boxes[i].name + "_y0", "y");
  }
  toml += test::support(boxes.front().name + "_z0", "z", bottom) + test::support(boxes.back().name + "_z1", "z", top);
  for (std::size_t i = 1; i < boxes.size(); ++i) {
    const std::string on = "on = \"" + boxes[i].name + "_z0\"", k = std::to_string(i);
    toml += test::probe("mean" + k, "contact_pressure", on);
    toml += test::probe("min" + k, "contact_pressure", on + "\nreduce = \"min\"");
    toml += test::probe("max" + k, "contact_pressure", on + "\nreduce = \"max\"");
    toml += test::probe("force" + k, "contact_force_z", on);
    toml += test::probe("gap" + k, "gap", on + "\nreduce = \"min\"");
  }
  return toml;
}

const std::vector<Box> two{{"lower", {0, 0, 0}, {10, 10, 10}, {3, 2, 2}},
                           {"upper", {0, 0, 10}, {10, 10, 20}, {2, 3, 2}}};
const std::vector<Bar> creeping{{10, 2e5, 1e-14}, {20, 1e5, 3e-14}}, elastic{{10, 2e5, 0}, {20, 1e5, 0}};

class Separation : public testing::TestWithParam<int> {};

// Pressed, pulled off, pressed back: no force in between, and the old one after it.
TEST_P(Separation, OpensWithoutAdhesionAndClosesAsBefore) {
  const Outcome outcome =
      test::run_case(stack_toml(two, elastic, "{ t = [0, 10, 20], values = [-0.03, 0.03, -0.03] }") +
                         test::contact_table("lower_z1", "upper_z0") + "[time]\nend = 20\noutput = [4, 10, 16, 20]\n",
                     test::boxes_geo(two), {"mesh.order=" + std::to_string(GetParam())});
  const double full = 100 * 0.03 / (10 / 2e5 + 20 / 1e5);
  EXPECT_RELATIVE(outcome.history.at("force1", 0), full, 1e-9);
  EXPECT_RELATIVE(outcome.history.at("force1", 4), 0.2 * full, 1e-9);
  EXPECT_NEAR(outcome.history.at("force1", 10), 0, 1e-12 * full);
  EXPECT_NEAR(outcome.history.at("max1", 10), 0, 1e-12 * full);
  EXPECT_RELATIVE(outcome.history.at("gap1", 10), 0.03, 1e-9);
  EXPECT_RELATIVE(outcome.history.at("force1", 16), 0.2 * full, 1e-9);
  EXPECT_RELATIVE(outcome.history.at("force1", 20), outcome.history.at("force1", 0), 1e-12);
}

// Creep while pressed shortens the blocks for good: they part sooner and carry less when pressed back.
TEST_P(Separation, LeavesTheCreepStrainOfBefore) {
  const std::vector<double> t{0, 100, 120, 200, 220, 300}, top{-0.03, -0.03, 0.03, 0.03, -0.03, -0.03};
  const auto displacement = [&](double time) {
    std::size_t i = 1;
    while (i + 1 < t.size() && time > t[i]) ++i;
    return top[i - 1] + (top[i] - top[i - 1]) * (time - t[i - 1]) / (t[i] - t[i - 1]);
  };
  const Outcome outcome = test::run_case(
      stack_toml(two, creeping,
                 "{ t = [0, 100, 120, 200, 220, 300], values = [-0.03, -0.03, 0.03, 0.03, -0.03, -0.03] }") +
          test::contact_table("lower_z1", "upper_z0") +
          "[time]\nend = 300\ntolerance = 1e-6\noutput = [100, 105, 120, 200, 215, 220, 300]\n",
      test::boxes_geo(two), {"mesh.order=" + std::to_string(GetParam())});
  const reference::Stack exact(creeping, n, [&](double time) { return -displacement(time); });
  for (const double time : {0.0, 100.0, 105.0, 215.0, 220.0, 300.0})
    EXPECT_NEAR(outcome.history.at("mean1", time), exact.stress(time), 1e-4 * exact.stress(0)) << "t = " << time;
  for (const double time : {120.0, 200.0}) {
    EXPECT_EQ(exact.stress(time), 0);
    EXPECT_NEAR(outcome.history.at("force1", time), 0, 1e-12 * 100 * exact.stress(0));
    EXPECT_NEAR(outcome.history.at("max1", time), 0, 1e-12 * exact.stress(0));
  }
  EXPECT_LT(exact.stress(220), 0.9 * exact.stress(0)) << "the case must creep to show anything";
}

INSTANTIATE_TEST_SUITE_P(Order, Separation, testing::Values(1, 2),
                         [](const auto& parameter) { return "order_" + std::to_string(parameter.param); });

// The motion of the top closes a gap of 0.01, given or in the mesh, before anything is pressed.
TEST(FirstContact, FollowsTheClosureOfAGivenOrMeasuredGap) {
  for (const bool measured : {false, true}) {
    std::vector<Box> boxes = two;
    if (measured) boxes[1].origin[2] += 0.01;
    const Outcome outcome = test::run_case(
        stack_toml(boxes, elastic, "\"-0.03*t\"") +
            test::contact_table("lower_z1", "upper_z0", measured ? "gap = \"geometric\"" : "gap = 0.01") +
            "[time]\nend = 1\noutput = [0.2, 0.3, 0.4, 0.8]\n",
        test::boxes_geo(boxes));
    const double flexibility = 10 / 2e5 + 20 / 1e5, full = 0.02 / flexibility;
    for (const double t : {0.0, 0.2, 0.3}) {
      EXPECT_NEAR(outcome.history.at("force1", t), 0, 1e-12 * 100 * full);
      EXPECT_NEAR(outcome.history.at("gap1", t), 0.01 - 0.03 * t, 1e-10);
    }
    for (const double t : {0.4, 0.8, 1.0}) {
      const double exact = (0.03 * t - 0.01) / flexibility;
      EXPECT_RELATIVE(outcome.history.at("min1", t), exact, 1e-8);
      EXPECT_RELATIVE(outcome.history.at("max1", t), exact, 1e-8);
      EXPECT_RELATIVE(outcome.history.at("force1", t), 100 * exact, 1e-9);
    }
  }
}

TEST(FirstContact, BeginsToCreepWhenItTouches) {
  const Outcome outcome = test::run_case(
      stack_toml(two, creeping, "{ t = [0, 60], values = [0, -0.06] }") +
          test::contact_table("lower_z1", "upper_z0", "gap = 0.03") +
          "[time]\nend = 100\ntolerance = 1e-6\nbreakpoints = [30]\noutput = [20, 30, 40, 60, 80, 100]\n",
      test::boxes_geo(two), {"mesh.order=1"});
  const reference::Stack exact(creeping, n, [](double t) { return 1e-3 * std::min(t, 60.0) - 0.03; });
  const double largest = exact.stress(60);
  for (const double t : {20.0, 30.0, 40.0, 60.0, 80.0, 100.0})
    EXPECT_NEAR(outcome.history.at("mean1", t), exact.stress(t), 1e-4 * largest) << "t = " << t;
}

struct Blocks {
  std::string name;
  int order;
  bool hexahedra, middle_is_held;
};

class ThreeBlocks : public testing::TestWithParam<Blocks> {};

// Two joints in series, no mesh like another. The middle block is held by contact alone, or, in a symmetric stack, in
// its plane of symmetry.
TEST_P(ThreeBlocks, RelaxByTheClosedForm) {
  const auto& [name, order, hexahedra, middle_is_held] = GetParam();
  const double height = middle_is_held ? 10 : 20;
  const std::vector<Box> boxes{{"low", {0, 0, 0}, {10, 10, 10}, {2, 3, 2}, hexahedra},
                               {"mid", {0, 0, 10}, {10, 10, 5}, {3, 2, 2}, true},
                               {"top", {0, 0, 15}, {10, 10, height}, {3, 3, 2}, hexahedra}};
  const std::vector<Bar> bars{
      {10, 2e5, 1e-14}, {5, 3e4, 1e-13}, middle_is_held ? Bar{10, 2e5, 1e-14} : Bar{20, 1e5, 3e-14}};
  double flexibility = 0, creep = 0;
  for (const Bar& bar : bars) flexibility += bar.length / bar.young_modulus, creep += bar.length * bar.A;
  const Outcome outcome = test::run_case(
      stack_toml(boxes, bars, "-0.02", "0.02") + (middle_is_held ? test::support("mid_middle", "z") : "") +
          test::contact_table("low_z1", "mid_z0") + test::contact_table("mid_z1", "top_z0") +
          "[time]\nend = 1e3\ntolerance = 1e-6\noutput = [1, 10, 100, 1e3]\n",
      test::boxes_geo(boxes), {"mesh.order=" + std::to_string(order)});
  for (const double t : {0.0, 1.0, 10.0, 100.0, 1e3}) {
    const double exact = reference::power_relaxation(0.04 / flexibility, creep / flexibility, n, t);
    for (const std::string joint : {"1", "2"}) {
      EXPECT_RELATIVE(outcome.history.at("mean" + joint, t), exact, 1e-4);
      EXPECT_RELATIVE(outcome.history.at("min" + joint, t), exact, 1e-3);
      EXPECT_RELATIVE(outcome.history.at("max" + joint, t), exact, 1e-3);
    }
    EXPECT_RELATIVE(outcome.history.at("force1", t), outcome.history.at("force2", t), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Blocks, ThreeBlocks,
                         testing::Values(Blocks{"hex8", 1, true, false}, Blocks{"hex20", 2, true, false},
                                         Blocks{"tet10", 2, false, false}, Blocks{"hex8_held", 1, true, true},
                                         Blocks{"tet10_held", 2, false, true}),
                         [](const auto& parameter) { return parameter.param.name; });

// Where the joint neither opens nor slides, a tie and unilateral contact are one and the same.
struct Agreement {
  std::string name;
  std::vector<Box> boxes;
  std::string bottom, top;
  int order = 2;
};

class TiedAndUnilateral : public testing::TestWithParam<Agreement> {};

TEST_P(TiedAndUnilateral, AgreeInCompressionWithoutShear) {
  const Agreement& tested = GetParam();
  const auto run = [&](const std::string& type) {
    std::string toml = fmt::format("[mesh]\nfile = \"case.geo\"\norder = {}\n", tested.order) +
                       test::support("lower_z0", "z", tested.bottom) + test::support("upper_z1", "z", tested.top) +
                       test::contact_table("lower_z1", "upper_z0", "type = \"" + type + "\"") + "[time]\nend = 1\n";
    for (const Box& box : tested.boxes)
      toml += test::body(box.name, 1e5, 0.3) + test::support(box.name + "_x0", "x") +
              test::support(box.name + "_y0", "y") +
              test::probe(box.name + "_x", "displacement_x", "on = \"" + box.name + "_x1\"\nreduce = \"max\"") +
              test::probe(box.name + "_zz", "stress_zz", "body = \"" + box.name + "\"\nreduce = \"min\"") +
              test::probe(box.name + "_q", "von_mises", "body = \"" + box.name + "\"\nreduce = \"max\"");
    toml += test::probe("force", "contact_force_z", "on = \"upper_z0\"") +
            test::probe("max", "contact_pressure", "on = \"upper_z0\"\nreduce = \"max\"") +
            test::probe("min", "contact_pressure", "on = \"upper_z0\"\nreduce = \"min\"");
    return test::contact_state(toml, test::boxes_geo(tested.boxes)).probes;
  };
  const auto tied = run("tied"), unilateral = run("unilateral");
  EXPECT_GT(unilateral.at("min"), 0) << "the joint must be closed everywhere";
  for (const auto& [name, value] : unilateral) EXPECT_RELATIVE(tied.at(name), value, 1e-8) << name;
}

INSTANTIATE_TEST_SUITE_P(Cases, TiedAndUnilateral,
                         testing::Values(Agreement{"uniform_on_other_meshes", two, "0", "-0.03"},
                                         // The mirror image of one another, so that nothing slides. Matching faces are
                                         // tied at all nodes; of linear elements these are the multipliers' nodes.
                                         Agreement{"mirror_images",
                                                   {{"lower", {0, 0, 0}, {10, 10, 10}, {3, 2, 2}},
                                                    {"upper", {0, 0, 10}, {10, 10, 10}, {3, 2, 2}}},
                                                   "\"0.01*(1 + 0.03*x - 0.02*y)\"",
                                                   "\"-0.01*(1 + 0.03*x - 0.02*y)\"",
                                                   1}),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace contact_states_tests
}  // namespace creepcontact
