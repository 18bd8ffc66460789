/// Files of tests: what becomes of rows, and what is said of bad ones.

#include "creepcontact/fit/test_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"

namespace creepcontact::fit {
namespace {

using test::message_of;
using test::says;

TestData parsed(const std::string& text, const ReadOptions& options = {}) {
  return parse_test_data(text, "data.csv", options);
}

std::string refusal(const std::string& text, const ReadOptions& options = {}) {
  return message_of<ConfigError>([&] { parsed(text, options); });
}
bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(TestData, TestsAreToldApartByStressTemperatureAndStart) {
  const TestData data = parsed(
      "Time [h];Stress (MPa);strain_%;temperature / "
      "K\n0;100;0;800\n1,5;100;0,1;800\n2;100,4;0,2;800\n0;100;0;800\n1;100;0,1;800\n"
      "1;150;0,3;800\n1;150;0,3;850\n");
  ASSERT_EQ(data.tests.size(), 4U);
  EXPECT_EQ(data.tests[0].readings.size(), 2U);
  EXPECT_DOUBLE_EQ(data.tests[0].readings[0].time, 1.5);
  EXPECT_DOUBLE_EQ(data.tests[0].readings[0].value, 1e-3);
  EXPECT_EQ(data.tests[1].name, "100 MPa, 800 K (2)");
  EXPECT_EQ(data.units.temperature, "K");
  EXPECT_EQ(data.stresses().size(), 2U);
  EXPECT_EQ(data.range().time.high, 2);
}

TEST(TestData, BatchesAreToldApart) {
  const std::string head = "time [h],stress [MPa],creep_strain,melt\n";
  const TestData data = parsed(head + "1,100,0.001,a\n2,100,0.002,a\n1,100,0.003,b\n2,100,0.004,b\n3,100,0.005,a\n");
  EXPECT_EQ(data.batches, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(data.tests.size(), 2U);
  EXPECT_EQ(data.tests[0].readings.size(), 3U);
  EXPECT_EQ(data.tests[1].batch, 1U);
  EXPECT_EQ(data.tests[1].name, "100 MPa, b");
  EXPECT_TRUE(parsed(head + "1,100,0.001,a\n2,100,0.002,a\n").batches.empty()) << "one of them is none";
  EXPECT_TRUE(says(refusal(head + "1,100,0.001,a\n2,100,0.002,\n"), {"data.csv:3", "no batch"}));
}

TEST(TestData, ColumnsMayHaveGermanAndFrenchNames) {
  const TestData german = parsed(
      "Prüfling;Zeit in h;Spannung [N/mm²];Kriechdehnung [%];Temperatur [°C];Bruchzeit / h\n"
      "A;1,5;100;0,1;550;200\nA;10;100;0,2;550;200\n");
  ASSERT_EQ(german.tests.size(), 2U);
  EXPECT_EQ(german.tests[1].name, "A");
  EXPECT_DOUBLE_EQ(german.tests[1].readings.at(1).value, 2e-3);
  EXPECT_EQ(german.tests[0].kind, TestKind::rupture);
  EXPECT_DOUBLE_EQ(german.tests[0].readings.at(0).value, 200);
  EXPECT_EQ(german.units.temperature, "°C");

  const TestData french = parsed(
      "Éprouvette;temps (h);contrainte (MPa);déformation de fluage (%)\nB;2;80;0,3\n"
      "B;20;80;0,5\n");
  EXPECT_EQ(french.tests.at(0).name, "B");
  EXPECT_DOUBLE_EQ(french.tests[0].readings.at(0).value, 3e-3);
  EXPECT_DOUBLE_EQ(parsed("temps à rupture en h;contrainte en MPa\n300;80\n").tests.at(0).readings.at(0).value, 300);
  EXPECT_EQ(parsed("rupture time h,stress MPa\n300,80\n").units.time, "h");
}

TEST(TestData, AnotherEncodingIsNamed) {
  EXPECT_TRUE(says(refusal("time [h],stress [MPa],strain [%],temperature [\xB0"
                           "C]\n1,100,0.1,500\n"),
                   {"data.csv: ", "0xB0", "line 1", "'°'", "UTF-8"}));
  EXPECT_TRUE(says(refusal("time,stress,strain,test\n1,100,0.1,Pr\xFC"
                           "f\n"),
                   {"line 2", "'ü'", "UTF-8"}));
  EXPECT_TRUE(says(refusal("\xFF\xFEt\0i\0"), {"UTF-16", "UTF-8"}));
}

// 1.000 in a file with 0,010 is a thousand, or the file has two decimal signs: which, only its author knows.
TEST(TestData, PointsInAFileWithDecimalCommasAreRefused) {
  const std::string office = "time [h];stress [MPa];strain [-]\n100;100;0,001\n1.000;100;0,010\n10.000;100;0,1\n";
  const std::string message = refusal(office);
  EXPECT_TRUE(says(message, {"data.csv:3: ", "'time [h]'", "'1.000'", "'0,001'", "line 2", "--thousands \".\"",
                             "--thousands \",\""}));
  ReadOptions options;
  options.thousands = io::Thousands::point;
  const TestData data = parsed(office, options);
  EXPECT_DOUBLE_EQ(data.tests.at(0).readings.at(1).time, 1000);
  EXPECT_DOUBLE_EQ(data.tests.at(0).readings.at(2).time, 10000);
  EXPECT_DOUBLE_EQ(data.tests.at(0).readings.at(1).value, 0.01);
  EXPECT_NE(refusal("time;stress;strain\n1.5;100;0,001\n", options), "");  // no groups of three digits

  for (const char* text :
       {"time;stress;strain\n1.000;100;0,010\n", "time;stress;strain\n100;100;0.010\n1,000;100;0.02\n",
        "time\tstress\tstrain\n100\t100\t0.010\n1,000.5\t100\t0.02\n",
        "time,stress,strain\n100,100,0.010\n\"1,000.5\",100,0.02\n", "time;stress;strain\n1.000.000;100;0,1\n",
        "time;stress;strain\n1 000;100;0,1\n"})
    EXPECT_TRUE(says(refusal(text), {"--thousands"})) << text;
  options.thousands = io::Thousands::comma;
  const TestData points = parsed("time,stress,strain\n100,100,0.010\n\"1,000.5\",100,0.02\n", options);
  EXPECT_DOUBLE_EQ(points.tests.at(0).readings.at(1).time, 1000.5);
  options.thousands = io::Thousands::blank;
  EXPECT_DOUBLE_EQ(parsed("time;stress;strain\n1\u00A0000;100;0,1\n", options).tests.at(0).readings.at(0).time, 1000);
  options.thousands = io::Thousands::apostrophe;
  EXPECT_DOUBLE_EQ(parsed("time;stress;strain\n1'234'567.5;100;0.1\n", options).tests.at(0).readings.at(0).time,
                   1234567.5);
  // One sign alone is decimal.
  EXPECT_DOUBLE_EQ(parsed("time;stress;strain\n1.5;100;0.1\n").tests.at(0).readings.at(0).time, 1.5);
}

TEST(TestData, ManyTestsTakeLittleTime) {
  std::string named = "test,stress,rupture_time\n", rates = "stress,rate\n";
  constexpr int n = 200000;  // with a search among all for each, many minutes
  for (int i = 0; i < n; ++i) {
    named += "t" + std::to_string(i) + ",100," + std::to_string(1000 + i) + "\n";
    rates += std::to_string(50 + i % 97) + ",1e-6\n";
  }
  EXPECT_EQ(parsed(named).n_specimens(), n);
  EXPECT_EQ(parsed(rates).n_specimens(), n);
}

TEST(TestData, TimesToRuptureAndRatesAreInTheUnitOfTheTime) {
  const TestData data = parsed("stress [MPa],rate [%/h],rupture_time [d]\n100,0.36,2\n");
  ASSERT_EQ(data.tests.size(), 2U);
  EXPECT_EQ(data.tests[0].kind, TestKind::rupture);
  EXPECT_DOUBLE_EQ(data.tests[0].readings[0].value, 2);
  EXPECT_EQ(data.units.time, "d");
  EXPECT_NEAR(data.tests[1].readings[0].value, 0.0036 * 24, 1e-12);
}

TEST(TestData, OneRuptureInTheRowsOfATest) {
  const TestData data = parsed("time,stress,strain,rupture_time\n1,100,0.001,9\n2,100,0.002,9\n1,120,0.002,5\n");
  EXPECT_EQ(std::ranges::count(data.tests, TestKind::rupture, &fit::Test::kind), 2);
}

TEST(TestData, ElasticStrainIsSubtractedFromTotalStrain) {
  const TestData data =
      parsed("time,stress,strain\n1,100,0.0015\n", {.young_modulus = Function(1e5), .temperature = {}});
  EXPECT_NEAR(data.tests.front().readings.front().value, 5e-4, 1e-15);
}

TEST(TestData, RelaxationBeginsAtItsStressOrItsStrain) {
  const ReadOptions options{.young_modulus = Function(1e5), .temperature = {}};
  const TestData data = parsed(
      "test,kind,time,stress,strain\na,relaxation,0,200,\na,relaxation,10,150,\nb,relaxation,5,180,0.0021\n", options);
  ASSERT_EQ(data.tests.size(), 2U);
  EXPECT_DOUBLE_EQ(data.tests[0].stress, 200);
  EXPECT_DOUBLE_EQ(data.tests[1].stress, 210);
  EXPECT_TRUE(says(refusal("kind,time,stress\nrelaxation,0,100\n"), {"data.csv:2: ", "--young-modulus"}));
}

TEST(TestData, BadRowsAreNamedAllTogether) {
  const std::string message =
      refusal("time [h],stress [MPa],strain [%]\n1,100,x\n-1,100,1\n3,,1\n4,100,1\n5,100,300\n,100,1\n");
  EXPECT_TRUE(says(message, {"data.csv:2: ", "'strain [%]'", "'x'", "data.csv:3: ", "'time [h]'", "-1", "data.csv:4: ",
                             "no stress", "data.csv:6: ", "strain 3", "100 %", "data.csv:7: ", "no time"}));
  EXPECT_FALSE(has(message, "data.csv:5"));
}

TEST(TestData, RowsWithOneMistakeAreNamedTogether) {
  const std::string message =
      refusal("kind,time,stress\nrelaxation,0,100\nrelaxation,1,90\nrelaxation,2,80\ncreep,1,-100\nrelaxation,0,90\n");
  EXPECT_TRUE(
      says(message, {"data.csv: ", "4 rows", "lines 2-4, 6", "--young-modulus", "data.csv:5: ", "stress -100"}));
  const std::string numbers = refusal("time,stress,strain\n1,-1,0.1\n2,-2,0.1\n3,-3,0.1\n4,4,0.1,7\n");
  EXPECT_TRUE(
      says(numbers, {"data.csv: ", "3 rows", "lines 2-4", "line 2: ", "stress -1", "> 0", "data.csv:5: ", "4", "3"}));
}

TEST(TestData, ARelaxationTestWithoutItsKindIsExplained) {
  EXPECT_TRUE(says(refusal("time,stress\n0,150\n1,140\n"), {"data.csv:2: ", "rupture 0", "'kind'"}));
  EXPECT_FALSE(has(refusal("time,stress,kind\n0,150,rupture\n1,140,rupture\n"), "'kind'"));
}

TEST(TestData, ASpecimenIsCountedOnce) {
  EXPECT_EQ(parsed("time,stress,strain,rupture_time\n1,100,0.001,9\n2,100,0.002,9\n1,120,0.002,\n").n_specimens(), 2);
  EXPECT_EQ(parsed("test,time,stress,strain\na,1,100,0.001\na,9,100,\nb,5,100,\n").n_specimens(), 2);
}

TEST(TestData, StressesThatAreHardlyInPascalsAreDoubted) {
  const TestData small = parsed("time [h],stress [Pa],strain\n1,100,0.001\n");
  ASSERT_EQ(small.notes.size(), 1U);
  EXPECT_TRUE(says(small.notes.front(), {"100 Pa", "MPa"}));
  EXPECT_TRUE(parsed("time [h],stress [Pa],strain\n1,1e8,0.001\n").notes.empty());
}

TEST(TestData, UnitsThatDoNotFitAreRefusedByName) {
  EXPECT_TRUE(
      says(refusal("time [MPa],stress [MPa],strain\n1,1,0.1\n"), {"data.csv: ", "'time [MPa]'", "'MPa'", "hours"}));
  EXPECT_TRUE(says(refusal("time,stress [h],strain\n1,1,0.1\n"), {"data.csv: ", "'stress [h]'", "'h'", "GPa"}));
  EXPECT_TRUE(says(refusal("time,stress,rate [1/h]\n1,1,0.1\n"), {"data.csv: ", "'time'", "'h'", "'time [h]'"}));
  EXPECT_TRUE(says(refusal("time,strain\n1,0.1\n"), {"data.csv: ", "'stress'", "time, stress"}));
}

}  // namespace
}  // namespace creepcontact::fit
