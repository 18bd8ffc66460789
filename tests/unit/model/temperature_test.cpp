/// Temperatures from files and of places on the model; tables in T that end.
#include "creepcontact/model/temperature.hpp"

#include <fmt/format.h>

#include "creepcontact/model/range_monitor.hpp"
#include "creepcontact/run/check.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

/// Hot at the top, from t = 1 on twice as much: T = 100 (z + 2), z from -2 to 1.
const std::string csv = "x,y,z,t,T\n0,0,-2,1,0\n0,0,1,1,300\n0,0,-2,3,0\n0,0,1,3,600\n";

class Temperatures : public testing::Test {
 protected:
  config::Config config(const std::string& text, const std::vector<std::string>& overrides = {},
                        const std::string& more = "[temperature]\nfile = \"T.csv\"\n") {
    io::test::write_text(blocks_ / "T.csv", text);
    return blocks_.config(more, overrides);
  }
  /// What a run of the rate up to these times writes to standard error.
  std::string warnings(const config::Config& of, const std::vector<double>& times) {
    testing::internal::CaptureStderr();
    System system(of);
    std::vector<double> state(system.rate.size()), rate(system.rate.size());
    RangeMonitor monitor(of);
    for (const double t : times) {
      system.rate.rate(t, state, rate);
      monitor.observe(t, system.model.bodies(), system.equilibrium(), serial_team());
    }
    monitor.finish();
    return testing::internal::GetCapturedStderr();
  }

  Case blocks_;
};

TEST_F(Temperatures, ComeFromAFile) {
  const config::Config given = config(csv);
  const Model model = build_model(given);
  EXPECT_EQ(model.breakpoints, (std::vector<double>{1, 3}));
  for (const mechanics::Body& body : model.bodies())
    for (const auto& [t, factor] : std::vector<std::pair<double, double>>{{0, 100}, {2, 150}, {4, 200}}) {
      const std::vector<double> values = body.at(t).temperature;
      for (std::size_t p = 0; p < values.size(); ++p)
        EXPECT_NEAR(values[p], factor * (body.discretization().point_coordinates()[p][2] + 2), 1e-9);
    }
  std::ostringstream report;
  check(given, report);
  const auto range = temperature_range(given, model);
  ASSERT_TRUE(range);
  EXPECT_GT(range->high, 500);
  EXPECT_LT(range->low, 60);
  EXPECT_TRUE(contains(report.str(), fmt::format("temperature: {:.6g} to {:.6g}\n", range->low, range->high)));
}

TEST_F(Temperatures, MistakesInTheFileAreNamedWithTheConfiguration) {
  const auto message = message_of<ModelError>([&] { build_model(config("x,y,z,T\n1,2,3,a\n")); });
  EXPECT_TRUE(says(message, {"case.toml:", "T.csv', line 2: ", "'T'", "'a'"}));
  EXPECT_TRUE(says(message_of<ConfigError>([&] { config(csv, {}, "[temperature]\nvalue = 1\nfile = \"T.csv\"\n"); }),
                   {"temperature: ", "both", "'value'", "'file'"}));
  EXPECT_TRUE(says(message_of<ConfigError>([&] { config(csv, {}, "[temperature]\n"); }),
                   {"temperature: ", "one of value, file"}));
}

TEST_F(Temperatures, PlacesFarOutsideTheFileAreWarnedOfOnce) {
  testing::internal::CaptureStderr();
  build_model(config("x,y,z,T\n0,0,-2,1\n0,0,-1.9,2\n0,0,-1.8,3\n"));
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(says(said, {"temperature: ", "T.csv'", "69 of 81 nodes", "24 of 36"}));
  EXPECT_EQ(said.find("69 of 81"), said.rfind("69 of 81"));
  testing::internal::CaptureStderr();
  build_model(config(csv));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(Temperatures, OutsideATableAreWarnedOfOnceATable) {
  const std::vector<std::string> tables{"materials.soft.creep[0].A={ T = [0, 190], values = [1e-3, 2e-3] }",
                                        "materials.hard.creep[0].A={ T = [0, 1000], values = [1e-3, 2e-3] }"};
  std::vector<std::string> short_run = tables;
  short_run.emplace_back("time.end=0.9");  // before it gets hot
  EXPECT_FALSE(contains(warnings(config(csv, short_run), {0.5, 0.9}), "material '"));
  const std::string said = warnings(config(csv, tables), {0.5, 3.5, 3.8, 0.5, 4});
  EXPECT_TRUE(says(said, {"material 'soft': creep[0].A: ", "temperature at (", "table (0 .. 190)"}));
  EXPECT_EQ(said.find("material '"), said.rfind("material '")) << said;
}

TEST_F(Temperatures, OutsideATableOfRuptureDataAreWarnedOf) {
  const std::string rupture = "materials.soft.rupture={ rupture_time = { T = [0, 190], values = [1e5, 1e3] } }";
  const std::string said = warnings(config(csv, {rupture}), {4});
  EXPECT_TRUE(says(said, {"material 'soft': rupture.rupture_time: ", "temperature at (", "table (0 .. 190)"}));
}

TEST_F(Temperatures, OutsideTheRangesOfALawAreWarnedOfOnce) {
  const std::vector<std::string> ranges{
      "materials.soft.creep[0].temperature_range=[0, 190]", "materials.hard.creep[0].temperature_range=[0, 1000]",
      "materials.soft.creep[0].stress_range=[1e-30, 1e-20]", "materials.hard.creep[0].stress_range=[0, 1e20]"};
  const std::string said = warnings(config(csv, ranges), {0.5, 3.5, 3.8});
  const std::string law = "material 'soft': creep[0] (norton): ";
  EXPECT_TRUE(says(said, {law, "temperature at (", "temperature_range", "(0 .. 190)"}));
  EXPECT_TRUE(says(said, {law, "stress at (", "stress_range", "(1e-30 .. 1e-20)"}));
  EXPECT_EQ(said.find("stress_range"), said.rfind("stress_range")) << said;
  EXPECT_FALSE(contains(said, "material 'hard'")) << said;
}

TEST_F(Temperatures, TheRangesOfAMaterialAreThoseOfItsLaws) {
  const config::Config found =
      config(csv, {"materials.soft.data_range={ stress = [1e-30, 1e-20], temperature = [190, 190], time = [0, 0.5] }",
                   "materials.soft.creep[0].temperature_range=[0, 180]"});
  const config::CreepMechanism& law =
      found.materials[0].name == "soft" ? found.materials[0].creep[0] : found.materials[1].creep[0];
  EXPECT_EQ(law.stress_range->high, 1e-20);
  EXPECT_EQ(law.temperature_range->high, 180) << "a range of its own";
  EXPECT_EQ(law.time_range->high, 0.5);
  ASSERT_EQ(found.remarks.size(), 1U);
  EXPECT_TRUE(contains(found.remarks[0], "materials.soft.data_range")) << found.remarks[0];
  EXPECT_TRUE(says(warnings(found, {0.5, 3.5}), {"stress_range", "(1e-30 .. 1e-20)"}));
  ASSERT_EQ(RangeMonitor::time_warnings(found).size(), 1U);
  EXPECT_TRUE(says(RangeMonitor::time_warnings(found)[0], {"time_range", "(0 .. 0.5)"}));
}

TEST_F(Temperatures, AStressThatNeverReachesTheRangeOfALawIsWarnedOfAtTheEnd) {
  const std::string said = warnings(config(csv, {"materials.soft.creep[0].stress_range=[1e20, 1e21]"}), {0.5, 3.5});
  EXPECT_TRUE(says(said, {"material 'soft': creep[0] (norton): ", "largest", "stress_range", "(1e+20 .. 1e+21)"}));
}

/// Interpolation leaves 20 - 4e-15 of a field that is 20.
TEST_F(Temperatures, RoundingIsNotOutsideATable) {
  const std::string table = "materials.soft.creep[0].A={ T = [20, 540], values = [1e-3, 2e-3] }";
  const auto said = [&](const std::string& temperature) {
    return warnings(blocks_.config("[temperature]\nvalue = \"" + temperature + "\"\n", {table}), {0, 4});
  };
  EXPECT_FALSE(contains(said("20*(1 - 2e-16)"), "material '"));
  EXPECT_FALSE(contains(said("t > 1 ? 540*(1 + 2e-16) : 20"), "material '"));
  EXPECT_TRUE(says(said("19.999"), {"creep[0].A: ", "19.999", "(20 .. 540)"}));
  EXPECT_TRUE(says(said("540.001"), {"creep[0].A: ", "540.001", "(20 .. 540)"}));
}

}  // namespace
}  // namespace creepcontact::run::test
