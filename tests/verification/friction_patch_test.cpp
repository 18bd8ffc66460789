/// Uniform pressure and shear across non-matching meshes with friction: sticking, and slipping at the limit.

#include <fmt/format.h>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace friction_patch_cases {
namespace {

struct PatchCase {
  std::string analysis;
  int order;
  std::string contact;  ///< keys
};

/// Two unit blocks one on the other, without lateral contraction. Shear tractions on the sides keep the stress uniform.
class FrictionPatch : public testing::TestWithParam<PatchCase> {
 protected:
  static constexpr double modulus = 1000;
  static bool is_solid() { return GetParam().analysis == "solid"; }

  static std::string traction(const std::string& on, const std::array<double, 3>& value) {
    return fmt::format("[[loads]]\non = \"{}\"\ntraction = [{}, {}, {}]\n", on, value[0], value[1], value[2]);
  }

  /// @param shear  traction on the upper body's contact, along x and in solids along y
  static std::string model(const std::string& contact, double pressure, const std::array<double, 2>& shear) {
    const auto& [sx, sy] = shear;
    std::string toml = is_solid() ? fmt::format("[mesh]\nfile = \"case.geo\"\norder = {}\n", GetParam().order)
                                  : test::section_of(GetParam().analysis, GetParam().order);
    toml += test::body("low", modulus, 0) + test::body("up", modulus, 0) + "[time]\nend = 1\n";
    const std::string bottom = is_solid() ? "low_z0" : "low_y0", top = is_solid() ? "up_z1" : "up_y1";
    toml += test::support(bottom, "x") + test::support(bottom, "y");
    if (is_solid()) toml += test::support(bottom, "z");
    toml += fmt::format("[[loads]]\non = \"{}\"\npressure = {}\n", top, pressure);
    for (const std::string body : {"low", "up"}) {
      toml += traction(body + "_x1", is_solid() ? std::array{0.0, 0.0, sx} : std::array{0.0, sx, 0.0});
      toml += traction(body + "_x0", is_solid() ? std::array{0.0, 0.0, -sx} : std::array{0.0, -sx, 0.0});
      if (!is_solid()) continue;
      toml += traction(body + "_y1", {0, 0, sy}) + traction(body + "_y0", {0, 0, -sy});
    }
    toml += test::contact_table(is_solid() ? "up_z0" : "up_y0", is_solid() ? "low_z1" : "low_y1", contact);
    for (const std::string body : {"low", "up"})
      for (const char* component : is_solid() ? std::array{"xx", "zz", "yz", "zx"} : std::array{"xx", "yy", "xy", "xy"})
        for (const char* reduce : {"min", "max"}) {
          const std::string name = body + "_" + component + "_" + reduce;
          if (toml.find("\"" + name + "\"") == std::string::npos)
            toml += test::probe(name, std::string("stress_") + component,
                                "body = \"" + body + "\"\nreduce = \"" + reduce + "\"");
        }
    toml += test::probe("moved", "displacement_x", "on = \"" + top + "\"");
    if (contact.find("tied") == std::string::npos)
      toml += test::probe("slip_min", "slip",
                          "on = \"" + std::string(is_solid() ? "up_z0" : "up_y0") + "\"\nreduce = \"min\"") +
              test::probe("slip_max", "slip",
                          "on = \"" + std::string(is_solid() ? "up_z0" : "up_y0") + "\"\nreduce = \"max\"");
    return toml;
  }

  static std::string geo() {
    return is_solid()
               ? test::boxes_geo({{"low", {0, 0, -1}, {1, 1, 1}, {3, 3, 2}}, {"up", {0, 0, 0}, {1, 1, 1}, {4, 5, 2}}})
               : test::regions_geo({{"low", {0, 1, 4}, {-1, 0, 3}}, {"up", {0, 1, 7}, {0, 1, 5}}});
  }

  static void expect_uniform(const test::Table& history, double pressure, const std::array<double, 2>& shear) {
    for (const std::string body : {"low", "up"})
      for (const char* reduce : {"min", "max"}) {
        const auto value = [&](const char* component) { return history.at(body + "_" + component + "_" + reduce, 1); };
        EXPECT_NEAR(value("xx"), 0, 1e-9) << body;
        EXPECT_NEAR(value(is_solid() ? "zz" : "yy"), -pressure, 1e-9) << body;
        EXPECT_NEAR(value(is_solid() ? "zx" : "xy"), shear[0], 1e-9) << body;
        EXPECT_NEAR(is_solid() ? value("yz") : shear[1], shear[1], 1e-9) << body;
      }
  }
};

TEST_P(FrictionPatch, SticksLikeATie) {
  const std::array<double, 2> shear{0.15, is_solid() ? 0.2 : 0.0};  // below 0.3
  std::string load = traction(is_solid() ? "up_z1" : "up_y1", {shear[0], shear[1], 0});
  const test::Table stuck =
      test::run_case(model("friction = 0.3\n" + GetParam().contact, 1, shear) + load, geo()).history;
  expect_uniform(stuck, 1, shear);
  EXPECT_NEAR(stuck.at("slip_max", 1), 0, 1e-12);
  const test::Table tied =
      test::run_case(model("type = \"tied\"\n" + GetParam().contact, 1, shear) + load, geo()).history;
  EXPECT_NEAR(stuck.at("moved", 1), tied.at("moved", 1), 1e-12);
  EXPECT_RELATIVE(stuck.at("moved", 1), 4 * shear[0] / modulus, 1e-9);  // heights of 1 + 1, shear modulus E/2
}

/// The upper end is moved so far that every node slips, by the same.
TEST_P(FrictionPatch, SlipsUniformly) {
  const double friction = 0.25, moved = 0.003;
  const std::array<double, 2> shear = is_solid() ? std::array{0.15, 0.2} : std::array{0.25, 0.0};
  const std::string top = is_solid() ? "up_z1" : "up_y1";
  const std::string toml = model(fmt::format("friction = {}\n{}", friction, GetParam().contact), 1, shear) +
                           test::support(top, "x", fmt::format("{}", moved * shear[0] / friction)) +
                           (is_solid() ? test::support(top, "y", fmt::format("{}", moved * shear[1] / friction)) : "");
  const test::Table history = test::run_case(toml, geo()).history;
  expect_uniform(history, 1, shear);
  for (const char* slip : {"slip_min", "slip_max"})
    EXPECT_RELATIVE(history.at(slip, 1), moved - 4 * friction / modulus, 1e-8) << slip;
}

INSTANTIATE_TEST_SUITE_P(Cases, FrictionPatch,
                         testing::Values(PatchCase{"plane_strain", 2, ""}, PatchCase{"plane_stress", 1, ""},
                                         PatchCase{"plane_strain", 1, "slave = \"low_y1\""}, PatchCase{"solid", 1, ""},
                                         PatchCase{"solid", 2, ""}),
                         [](const auto& of) {
                           return fmt::format("{}_order{}{}", of.param.analysis, of.param.order,
                                              of.param.contact.empty() ? "" : "_lower_slave");
                         });

}  // namespace
}  // namespace friction_patch_cases
}  // namespace creepcontact
