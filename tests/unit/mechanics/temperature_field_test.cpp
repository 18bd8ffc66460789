/// Temperatures of functions and of points.
#include "creepcontact/mechanics/temperature_field.hpp"

#include <gtest/gtest.h>

namespace creepcontact::mechanics {
namespace {

const std::vector<Vector3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};

TemperatureField heated() {
  return TemperatureField(ScatteredTemperatures{line, {10, 20, 40}, {{20, 20, 20}, {120, 220, 320}, {120, 220, 320}}});
}

double at(const TemperatureField& field, double x, double t) {
  const std::vector<Vector3> position{{x, 3, 4}};
  std::vector<double> value(1);
  mechanics::TemperatureMemo memo;
  field.at(position)->evaluate(t, value, memo);
  EXPECT_DOUBLE_EQ(value[0], field({.x = x, .y = 3, .z = 4, .t = t}));
  return value[0];
}

TEST(TemperatureField, OfPointsIsLinearInTimeBetweenItsTimes) {
  const TemperatureField field = heated();
  EXPECT_TRUE(field.depends_on_time());
  EXPECT_EQ(field.breakpoints(30), (std::vector<double>{10, 20}));
  EXPECT_DOUBLE_EQ(at(field, 0.5, 0), 20);
  EXPECT_DOUBLE_EQ(at(field, 0.5, 15), 95);
  EXPECT_DOUBLE_EQ(at(field, 1.5, 20), 270);
  EXPECT_DOUBLE_EQ(at(field, 1.5, 30), 270);
  EXPECT_DOUBLE_EQ(at(field, 1.5, 99), 270);
}

/// Evaluated to and fro in time, the values that are kept stay right.
TEST(TemperatureField, KeepsTheRightTimes) {
  const TemperatureField field = heated();
  const auto positions = field.at(line);
  std::vector<double> values(3);
  mechanics::TemperatureMemo memo;
  for (const double t : {15.0, 45.0, 12.0, 25.0, 5.0, 19.0}) {
    positions->evaluate(t, values, memo);
    for (std::size_t p = 0; p < 3; ++p) EXPECT_DOUBLE_EQ(values[p], field({.x = line[p][0], .t = t})) << t;
  }
}

TEST(TemperatureField, OfAFunction) {
  const TemperatureField field = Function::expression("500 + 20*x + t", {"x", "y", "z", "t"});
  EXPECT_DOUBLE_EQ(at(field, 2, 3), 543);
  EXPECT_EQ(field.text(), "500 + 20*x + t");
  EXPECT_TRUE(field.depends_on_position() && field.depends_on_time());
  EXPECT_EQ(field.outside({99, 0, 0}).distance, 0);
  const TemperatureField uniform = Function(20.0);
  EXPECT_FALSE(uniform.depends_on_position() || uniform.depends_on_time());
}

TEST(TemperatureField, TextTellsContentsApart) {
  const TemperatureField a(ScatteredTemperatures{line, {0}, {{1, 2, 3}}}),
      b(ScatteredTemperatures{line, {0}, {{1, 2, 4}}});
  EXPECT_EQ(a.text(), TemperatureField(ScatteredTemperatures{line, {0}, {{1, 2, 3}}}).text());
  EXPECT_NE(a.text(), b.text());
  EXPECT_FALSE(a.depends_on_time());
  EXPECT_TRUE(a.breakpoints(1).empty());
}

}  // namespace
}  // namespace creepcontact::mechanics
