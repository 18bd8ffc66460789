#include "creepcontact/base/unit_system.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace creepcontact {
namespace {

TEST(UnitSystem, ReadsWhatUsersWrite) {
  for (const char* const text : {"mm, N, MPa, h", "mm-N-MPa-h", "N mm MPa h degC", "mm; t; MPa; h; °C", "mm, N, h"}) {
    const UnitSystem found = unit_system(text);
    EXPECT_DOUBLE_EQ(found.stress, 1e6) << text;
    EXPECT_EQ(found.time, 3600.0) << text;
    EXPECT_EQ(found.length, 1e-3) << text;
    EXPECT_EQ(found.temperature.offset, 273.15) << text;
  }
  const UnitSystem pascal = unit_system("m, Pa, s, K");
  EXPECT_EQ(pascal.stress, 1.0);
  EXPECT_EQ(pascal.time, 1.0);
  EXPECT_EQ(pascal.temperature.offset, 0.0);
  const UnitSystem inch = unit_system("inch, psi, min, degF");
  EXPECT_NEAR(inch.stress, 6894.757293168361, 1e-9);
  EXPECT_EQ(inch.time, 60.0);
  EXPECT_EQ(inch.length, 0.0254);
  EXPECT_DOUBLE_EQ(inch.temperature.factor, 1 / 1.8);
}

TEST(UnitSystem, RefusesWhatItDoesNotUnderstand) {
  const auto refusal = [](const char* text) -> std::string {
    try {
      unit_system(text);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal("mm, N, Mpa, h").find("'Mpa' is not a known unit; did you mean 'MPa'?"), std::string::npos);
  EXPECT_EQ(refusal("mm, MPa"), "no unit of time");
  EXPECT_EQ(refusal("mm, h"), "no unit of stress");
  EXPECT_EQ(refusal("mm, m, MPa, h"), "two units of length, mm and m");
  EXPECT_EQ(refusal("m, N, MPa, h"), "N per m^2 is not MPa: the units are not consistent");
  EXPECT_EQ(refusal(""), "no unit of time");
}

TEST(UnitSystem, ChangesAreExactWhereUnitsAreTheSame) {
  const UnitChange none = unit_change(unit_system("mm, MPa, h"), unit_system("mm, N, MPa, h, degC"));
  EXPECT_EQ(none.stress, 1.0);
  EXPECT_EQ(none.degree, 1.0);
  EXPECT_EQ(none.zero, 0.0);
  const UnitChange change = unit_change(unit_system("mm, MPa, h"), unit_system("inch, psi, min, degF"));
  EXPECT_EQ(change.time, 60.0);
  EXPECT_EQ(change.degree, 1.8);
  EXPECT_EQ(change.zero, 32.0);
}

}  // namespace
}  // namespace creepcontact
