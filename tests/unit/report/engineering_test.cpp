/// Numbers as engineers write them, the same in every table of a report.

#include "../../../src/report/engineering.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace creepcontact::report {
namespace {

/// Spaces that do not break become plain ones.
std::string plain(std::string text) {
  for (const std::string_view space : {"\u202F", "\u00A0"})
    for (std::size_t at = 0; (at = text.find(space, at)) != std::string::npos;) text.replace(at, space.size(), " ");
  return text;
}

TEST(Engineering, ThreeFiguresInGroups) {
  for (const auto& [value, text] : std::initializer_list<std::pair<double, const char*>>{{0, "0"},
                                                                                         {1, "1"},
                                                                                         {-1.2345, "-1.23"},
                                                                                         {999.6, "1 000"},
                                                                                         {1234567, "1 230 000"},
                                                                                         {100000, "100 000"},
                                                                                         {0.05, "0.05"},
                                                                                         {0.00012345, "0.000123"},
                                                                                         {1.6e-7, "1.6·10⁻⁷"},
                                                                                         {-2e-20, "-2·10⁻²⁰"},
                                                                                         {1.5e12, "1.5·10¹²"}})
    EXPECT_EQ(plain(engineering(value)), text) << value;
  EXPECT_EQ(engineering(std::numeric_limits<double>::quiet_NaN()), "-");
  EXPECT_EQ(engineering(std::numeric_limits<double>::infinity()), "∞");
  EXPECT_EQ(plain(time_text(87660, "h")), "87 660 h");
}

TEST(Engineering, OneScaleForAColumn) {
  const Scale forces("N", std::array{160000.0, 1.5, 2e-7, -3e-12});
  EXPECT_EQ(forces.unit(), "kN");
  EXPECT_EQ(forces.text(160000), "160");
  EXPECT_EQ(forces.text(1.5), "0.0015");
  EXPECT_EQ(forces.text(-3e-12), "0");  // round-off
  EXPECT_EQ(plain(quantity(2.5e7, "N")), "25 MN");
  EXPECT_EQ(plain(quantity(6091, "N")), "6 090 N");
  EXPECT_EQ(plain(quantity(350, "MPa")), "350 MPa");
  EXPECT_EQ(plain(quantity(1240, "MPa")), "1 240 MPa");
  EXPECT_EQ(plain(quantity(210000, "MPa")), "210 GPa");
  EXPECT_EQ(plain(quantity(3e8, "Pa")), "300 MPa");
  EXPECT_EQ(plain(quantity(2e-4, "mm")), "0.2 µm");
  EXPECT_EQ(plain(quantity(5e6, "N·mm")), "5 000 kN·mm");
  EXPECT_EQ(plain(quantity(5e6, "psi")), "5 000 000 psi");
  EXPECT_EQ(quantity(0, "N"), "0\u00A0N");
}

TEST(Engineering, PerCent) {
  EXPECT_EQ(plain(percent(0.983)), "98 %");
  EXPECT_EQ(plain(percent(-1e-12)), "0 %");  // not -0
  EXPECT_EQ(plain(percent(0.0042)), "0.42 %");
  EXPECT_EQ(plain(percent(12.5)), "1 250 %");
}

TEST(Engineering, Places) {
  EXPECT_EQ(plain(place_text(std::array{12.5, 1e-15, -100.0}, "mm")), "(12.5, 0, -100) mm");
}

TEST(Engineering, CellsOfInputsKeepTheirFigures) {
  EXPECT_EQ(plain(readable("1.6e+05 N")), "160 000 N");
  EXPECT_EQ(plain(readable("1.23457e+06")), "1 234 570");
  EXPECT_EQ(readable("1e-20"), "1·10⁻²⁰");
  EXPECT_EQ(plain(readable("231725.25 mm")), "231 725.25 mm");
  EXPECT_EQ(plain(readable("-100000")), "-100 000");
  for (const char* same : {"1.2345", "2e5*t", "disc", "", "0.1 mm", "tri6", "12345a", "inf", "nan", "-", "1/773.15"})
    EXPECT_EQ(readable(same), same);
}

TEST(Engineering, NumbersWithinATextAreReadable) {
  EXPECT_EQ(plain(readable("1e5 at 0, 2e5 at 1")), "100 000 at 0, 200 000 at 1");
  EXPECT_EQ(plain(readable("preload 35000 from t = 1000 on")), "preload 35 000 from t = 1000 on");
  EXPECT_EQ(plain(readable("force per area [MPa] = (0, 0, 15.723270440251572)")),
            "force per area [MPa] = (0, 0, 15.7233)");
  EXPECT_EQ(readable("20 + 43000*min(1, t/8)"), "20 + 43000*min(1, t/8)");
}

TEST(Engineering, TablesAreSentences) {
  EXPECT_EQ(plain(readable("{ T = [20, 500], values = [211000, 175000] }")), "211 000 at T = 20, 175 000 at 500");
  EXPECT_EQ(plain(readable("{ t = [0, 6], values = [20, 600], period = 168 }")),
            "20 at t = 0, 600 at 6; again every 168");
  for (const char* same : {"{ T = [20, 500], values = [1] }", "{ T = 5 }", "{ a", "{ T = [20], values = [1], x = 2 }"})
    EXPECT_EQ(readable(same), same);
}

TEST(Engineering, NumbersAreKnown) {
  for (const std::string& number :
       {engineering(1.6e-7), engineering(123456), quantity(5, "N"), percent(0.5), std::string("1.5e3"), std::string()})
    EXPECT_TRUE(is_number_text(number)) << number;
  for (const char* other : {"disc", "3 of 4 are open", "-x", "2 bodies in contact", "tri6"})
    EXPECT_FALSE(is_number_text(other)) << other;
}

}  // namespace
}  // namespace creepcontact::report
