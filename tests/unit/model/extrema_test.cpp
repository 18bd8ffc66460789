/// Times at which expressions turn back.
#include "../../../src/model/extrema.hpp"

#include <gtest/gtest.h>

namespace creepcontact::model {
namespace {

std::vector<double> turns(const char* expression, double end) {
  return extrema(Function::expression(expression, {"x", "y", "z", "t"}), end);
}

void expect_times(const std::vector<double>& times, const std::vector<double>& expected, double error) {
  ASSERT_EQ(times.size(), expected.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], expected[i], error);
}

TEST(Extrema, OfAnOscillation) {
  expect_times(turns("-0.02*cos(3.14159265358979*t/250)", 1000), {250, 500, 750}, 0.51);
  expect_times(turns("x*sin(t)", 9.0), {1.5708, 4.7124, 7.854}, 0.005);
}

TEST(Extrema, OfAPulse) {
  expect_times(turns("100*max(0, 1 - abs(t - 700)/10)", 1000), {700}, 0.51);
}

TEST(Extrema, MonotonousFunctionsHaveNone) {
  expect_times(turns("min(t/10, 1)", 1000), {}, 0);
  expect_times(turns("exp(-t)", 1000), {}, 0);
  expect_times(extrema(3.0, 1000), {}, 0);
}

TEST(Extrema, VibrationsAndWhatIsNoNumberHaveNone) {
  expect_times(turns("sin(1000*t)", 1.0), {}, 0);
  expect_times(turns("sqrt(t - 1)*cos(t)", 10.0), {}, 0);
}

}  // namespace
}  // namespace creepcontact::model
