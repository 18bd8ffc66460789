/// Bodies whose meshes match at a tied contact: the results are those of one body.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace tied_bodies_cases {
namespace {

struct SplitCase {
  const char* name;
  int order;
  bool hexahedra;
  const char* more;  ///< of the configuration
  const char* modulus;
  double tolerance;
};

/// A column, clamped below, with a plane of symmetry at its side; loads bend and twist it.
class SplitColumn : public testing::TestWithParam<SplitCase> {
 protected:
  static std::string body(const std::string& name) {
    std::string toml = fmt::format(
        "[bodies.{0}]\nregion = \"{0}\"\nmaterial = \"m_{0}\"\n[materials.m_{0}]\nyoung_modulus = {1}\n"
        "poisson_ratio = 0.3\nthermal_expansion = 1e-6\nreference_temperature = 0\n[[materials.m_{0}.creep]]\nlaw = "
        "\"norton\"\nA = 1e-5\nn = 3\n",
        name, GetParam().modulus);
    return toml;
  }

  static std::string model(bool split) {
    const std::string low = split ? "low" : "all", up = split ? "up" : "all";
    std::string toml = fmt::format("[mesh]\nfile = \"case.geo\"\norder = {}\n", GetParam().order) + body(low);
    if (split) toml += body(up);
    toml += "[time]\nend = 1\noutput = [0, 1]\nintegrator = \"explicit_euler\"\nstep = 0.25\n";
    toml += "[contact_solver]\ntolerance = 1e-13\n";
    for (const char* component : {"x", "y", "z"}) toml += test::support(low + "_z0", component);
    toml += test::support(low + "_y0", "y") + (split ? test::support(up + "_y0", "y") : "");
    toml += fmt::format("[[loads]]\non = \"{}_z1\"\ntraction = [\"0.4*y\", 0.2, \"1 + x\"]\n", up);
    for (const std::string& name : split ? std::vector<std::string>{low, up} : std::vector<std::string>{low})
      toml += fmt::format("[[loads]]\non = \"{}_x1\"\npressure = \"0.5*(1 + y)\"\n", name);
    toml += GetParam().more;
    if (split) toml += test::contact_table("low_z1", "up_z0", "type = \"tied\"");
    int n = 0;
    // Stresses are smoothed over the elements of one body: compared away from the joint.
    const auto add = [&](const std::string& body, const std::string& at, bool is_far) {
      std::vector<std::string> quantities{"displacement_x", "displacement_y", "displacement_z"};
      if (is_far) quantities.insert(quantities.end(), {"stress_zz", "stress_zx", "von_mises"});
      for (const std::string& quantity : quantities)
        toml += test::probe(fmt::format("{}_{}", quantity, n++), quantity,
                            fmt::format("at = [{}]\nbody = \"{}\"", at, body));
    };
    for (const char* at : {"0.1, 0.9, 0.2", "1.1, 0.02, 0.9", "0.2, 0.25, 0.001", "0.6, 1, 0.125"}) add(up, at, false);
    for (const char* at : {"0.5, 0.5, 0", "0.2, 0, 0", "1.2, 1, -0.1", "0.7, 0.4, -0.6"}) add(low, at, false);
    add(up, "0.5, 0.5, 0.9", true);
    add(low, "0.4, 0.2, -0.9", true);
    return toml;
  }

  static std::string geo(bool split) {
    const bool hex = GetParam().hexahedra;
    if (!split) return test::boxes_geo({{"all", {0, 0, -1}, {1.2, 1, 2}, {3, 2, 8}, hex}});
    return test::boxes_geo(
        {{"low", {0, 0, -1}, {1.2, 1, 1}, {3, 2, 4}, hex}, {"up", {0, 0, 0}, {1.2, 1, 1}, {3, 2, 4}, hex}});
  }
};

TEST_P(SplitColumn, MovesAsOneBody) {
  const test::Table one = test::run_case(model(false), geo(false)).history;
  for (const char* method : {"schwarz", "active_set"}) {
    const test::Table split =
        test::run_case(model(true), geo(true), {std::string("contact_solver.method=") + method}).history;
    ASSERT_EQ(split.rows(), one.rows());
    for (const std::string quantity : {"displacement", "stress", "von_mises"}) {
      std::vector<std::string> names = one.names();
      std::erase_if(names, [&](const std::string& name) { return name.find(quantity) == std::string::npos; });
      double largest = 0;
      for (const std::string& name : names)
        for (const double value : one.column(name)) largest = std::max(largest, std::abs(value));
      for (const std::string& name : names)
        for (std::size_t row = 0; row < one.rows(); ++row)
          EXPECT_NEAR(split.column(name)[row], one.column(name)[row], GetParam().tolerance * largest) << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, SplitColumn,
    testing::Values(SplitCase{"hex8", 1, true, "", "200", 1e-10}, SplitCase{"hex20", 2, true, "", "200", 1e-10},
                    SplitCase{"heated", 2, true, "[temperature]\nvalue = \"100*t\"\n", "\"200 - 0.3*T\"", 1e-8}),
    [](const auto& of) { return of.param.name; });

/// Two blocks across a third one: at the edge where all meet, one of three ties follows from the others.
TEST(TiedBodies, ThreeAtAnEdge) {
  const auto model = [](bool split) {
    std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n";
    const std::vector<std::string> names =
        split ? std::vector<std::string>{"base", "left", "right"} : std::vector<std::string>{"base", "both"};
    for (const std::string& name : names) toml += test::body(name, 200, 0.3);
    toml += "[time]\nend = 1\n[contact_solver]\ntolerance = 1e-13\n";
    for (const char* component : {"x", "y", "z"}) toml += test::support("base_z0", component);
    const std::string last = split ? "right" : "both";
    toml += fmt::format("[[loads]]\non = \"{0}_x1\"\ntraction = [1, 0.3, 0.2]\n", last);
    for (const std::string& name : names)
      if (name != "base") toml += test::contact_table(name + "_z0", "base_z1", "type = \"tied\"");
    if (split) toml += test::contact_table("left_x1", "right_x0", "type = \"tied\"");
    int n = 0;
    for (const char* component : {"x", "y", "z"})
      for (const std::string at : {"1, 1, 0.5", "2, 0, 0.5", "1, 0, 0.01", "1, 0.5, 0.25"})
        toml += test::probe(fmt::format("u{}_{}", component, n++), fmt::format("displacement_{}", component),
                            fmt::format("at = [{}]\nbody = \"{}\"", at, last));
    return toml;
  };
  const auto geo = [](bool split) {
    std::vector<test::Box> boxes{{"base", {0, 0, -1}, {2, 1, 1}, {4, 2, 2}}};
    if (split) {
      boxes.push_back({"left", {0, 0, 0}, {1, 1, 0.5}, {2, 2, 2}});
      boxes.push_back({"right", {1, 0, 0}, {1, 1, 0.5}, {2, 2, 2}});
    } else {
      boxes.push_back({"both", {0, 0, 0}, {2, 1, 0.5}, {4, 2, 2}});
    }
    return test::boxes_geo(boxes);
  };
  const test::Table one = test::run_case(model(false), geo(false)).history,
                    split = test::run_case(model(true), geo(true)).history;
  for (const std::string& name : one.names())
    if (name != "time") {
      EXPECT_RELATIVE(split.at(name, 1), one.at(name, 1), 1e-9) << name;
    }
}

/// A preloaded cut through a bar of quadratic elements: the tension is that of the preload everywhere.
TEST(TiedBodies, PreloadedCutIsUniform) {
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n" + test::body("low", 200, 0) + test::body("up", 200, 0);
  toml += "[time]\nend = 1\n";
  toml += test::support("low_z0", "z") + test::support("up_z1", "z");
  for (const char* body : {"low", "up"})
    toml += test::support(body + std::string("_x0"), "x") + test::support(body + std::string("_y0"), "y");
  toml += test::contact_table("low_z1", "up_z0", "type = \"tied\"\npreload = { force = 6 }");
  for (const char* reduce : {"min", "max"})
    for (const char* body : {"low", "up"})
      toml += test::probe(fmt::format("{}_{}", body, reduce), "stress_zz",
                          fmt::format("body = \"{}\"\nreduce = \"{}\"", body, reduce));
  for (const char* reduce : {"min", "mean", "max"})
    toml += test::probe(fmt::format("pressure_{}", reduce), "contact_pressure",
                        fmt::format("on = \"up_z0\"\nreduce = \"{}\"", reduce));
  toml +=
      test::probe("force", "contact_force_z", "on = \"up_z0\"") + test::probe("area", "contact_area", "on = \"up_z0\"");
  const auto outcome = test::run_case(
      toml, test::boxes_geo({{"low", {0, 0, -1}, {1.5, 2, 1}, {3, 2, 2}}, {"up", {0, 0, 0}, {1.5, 2, 1}, {3, 2, 2}}}));
  for (const char* name : {"low_min", "low_max", "up_min", "up_max"})
    EXPECT_RELATIVE(outcome.history.at(name, 1), 2, 1e-9) << name;
  for (const char* name : {"pressure_min", "pressure_mean", "pressure_max"})
    EXPECT_RELATIVE(outcome.history.at(name, 1), -2, 1e-9) << name;
  EXPECT_RELATIVE(outcome.history.at("force", 1), -6, 1e-9);
  EXPECT_RELATIVE(outcome.history.at("area", 1), 3, 1e-12);
  EXPECT_RELATIVE(outcome.summary.number("contacts/low_z1~1up_z0/interference"), 6 / 3.0 * 2 / 200, 1e-8);
}

}  // namespace
}  // namespace tied_bodies_cases
}  // namespace creepcontact
