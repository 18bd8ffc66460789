// What laws tell about the state of the material, in probes and field files.
#include <gtest/gtest.h>

#include <cmath>

#include "support/run/probing.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace state_variables_tests {
namespace {

const std::vector<ProbeTable> probes{{"hardening", "hardening_strain", "body = 'lower'"},
                                     {"equivalent", "creep_strain_equivalent", "body = 'lower'"},
                                     {"kelvin", "kelvin_strain_zz", "body = 'upper'"},
                                     {"creep", "creep_strain_zz", "body = 'upper'"},
                                     {"kelvin_there", "kelvin_strain_zz", "at = [1, 0.5, 0.5]"},
                                     {"kelvin_of_norton", "kelvin_strain_zz", "body = 'lower'"}};

const std::vector<std::string> laws{"materials.soft.creep=[{law='strain_hardening', A=1e-4, n=2, m=0.5}]",
                                    "materials.hard.creep=[{law='kelvin_voigt', compliance=1e-3, time=1}, "
                                    "{law='kelvin_voigt', compliance=2e-3, time=3}]",
                                    "time.output=[1]"};

TEST(StateVariables, AreQuantitiesOfProbes) {
  const Case blocks;
  ASSERT_EQ(
      run(blocks.parse(probe_tables(probes) + case_text, laws), {.output = (blocks / "out").string()}).exit_status, 0);
  const Table history(blocks / "out/history.csv");
  EXPECT_EQ(history.at("kelvin", 0), 0);
  for (const double t : {1.0, 4.0}) {
    // Each law is the only one of its material, and the uniaxial stress keeps its direction.
    EXPECT_GT(history.at("hardening", t), 1e-5);
    EXPECT_NEAR(history.at("hardening", t), history.at("equivalent", t), 1e-6 * history.at("equivalent", t));
    EXPECT_LT(history.at("kelvin", t), -1e-4);
    EXPECT_NEAR(history.at("kelvin", t), history.at("creep", t), 1e-12);
    EXPECT_NEAR(history.at("kelvin_there", t), history.at("creep", t), 1e-8);
    EXPECT_EQ(history.at("kelvin_of_norton", t), 0);
  }
}

TEST(StateVariables, AreInTheFieldFilesIfALawHasThem) {
  const Case blocks;
  ASSERT_EQ(run(blocks.config("", laws), {.output = (blocks / "own").string()}).exit_status, 0);
  ASSERT_EQ(run(blocks.config(), {.output = (blocks / "norton").string()}).exit_status, 0);
  const std::string own = read_text(blocks / "own/fields/fields_0001.vtu");
  const std::string norton = read_text(blocks / "norton/fields/fields_0001.vtu");
  for (const char* array : {"Name=\"hardening_strain\"", "Name=\"kelvin_strain\" NumberOfComponents=\"6\""}) {
    EXPECT_TRUE(contains(own, array)) << array;
    EXPECT_FALSE(contains(norton, array)) << array;
  }
  for (const char* array : {"Name=\"damage\"", "Name=\"life_fraction\""}) EXPECT_FALSE(contains(own, array)) << array;
}

TEST(UnitNames, OfTheArraysThatHaveAUnit) {
  const Case blocks;
  const auto fields = [&](const std::string& switch_text) {
    const config::Config config =
        blocks.config("", {"units='mm, MPa, h'", "output.unit_names=" + switch_text, "time.end=0.1"});
    EXPECT_EQ(run(config, {.output = (blocks / "out").string()}).exit_status, 0);
    return read_text(blocks / "out/fields/fields_0000.vtu") + read_text(blocks / "out/contact/contact_0000.vtu");
  };
  const std::string with = fields("true"), without = fields("false");
  for (const char* array : {"displacement [mm]", "stress [MPa]", "principal_stress [MPa]", "creep_strain",
                            "temperature", "contact_pressure [MPa]", "gap [mm]"})
    EXPECT_TRUE(contains(with, std::string("Name=\"") + array + '"')) << array;
  EXPECT_TRUE(contains(without, "Name=\"stress\""));
  EXPECT_FALSE(contains(without, "[MPa]"));
}

}  // namespace
}  // namespace state_variables_tests
}  // namespace creepcontact::run::test
