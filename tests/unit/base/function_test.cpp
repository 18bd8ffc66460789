#include "creepcontact/base/function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace creepcontact {
namespace {

const std::vector<std::string> position_and_time{"x", "y", "z", "t"};

std::string message_of(const std::string& text, const std::vector<std::string>& allowed = position_and_time) {
  try {
    Function::expression(text, allowed);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Function, DefaultIsTheConstantZero) {
  const Function f;
  EXPECT_EQ(f({.x = 3}), 0.0);
  EXPECT_TRUE(f.is_constant());
  EXPECT_TRUE(f.is_zero());
  EXPECT_TRUE(f.breakpoints().empty());
}

TEST(Function, NumberIsAConstant) {
  const Function f = 2.5;
  EXPECT_EQ(f({}), 2.5);
  EXPECT_TRUE(f.is_constant());
  EXPECT_FALSE(f.is_zero());
  EXPECT_EQ(f.text(), "2.5");
}

TEST(Function, EvaluatesEveryVariable) {
  const auto f =
      Function::expression("x + 10*y + 100*z + 1e3*t + 1e4*T + 1e5*q + 1e6*eps", {"x", "y", "z", "t", "T", "q", "eps"});
  EXPECT_DOUBLE_EQ(f({.x = 1, .y = 2, .z = 3, .t = 4, .T = 5, .q = 6, .eps = 7}), 7654321.0);
  EXPECT_DOUBLE_EQ(f({.x = 1}), 1.0) << "values of the call before must not stay";
}

TEST(Function, KnowsTheParsersFunctions) {
  const auto ramp = Function::expression("100*min(t/10, 1)", {"t"});
  EXPECT_DOUBLE_EQ(ramp({.t = 5}), 50);
  EXPECT_DOUBLE_EQ(ramp({.t = 50}), 100);
  const auto ternary = Function::expression("t <= 2 ? -1 : max(x, 2)^3", position_and_time);
  EXPECT_DOUBLE_EQ(ternary({.x = 5, .t = 2}), -1);
  EXPECT_DOUBLE_EQ(ternary({.x = 5, .t = 3}), 125);
  EXPECT_DOUBLE_EQ(Function::expression("exp(x)*sinh(y)", position_and_time)({.x = 1, .y = 2}),
                   std::exp(1) * std::sinh(2));
  EXPECT_DOUBLE_EQ(Function::expression("2*pi*x + _pi", {"x"})({.x = 1}), 3 * std::numbers::pi);
}

TEST(Function, DependenciesAreThoseThatOccur) {
  const auto position = Function::expression("sin(y)", position_and_time);
  EXPECT_TRUE(position.depends_on_position());
  EXPECT_FALSE(position.depends_on_time());
  EXPECT_FALSE(position.depends_on_temperature());
  EXPECT_FALSE(position.is_constant());
  const auto both = Function::expression("exp(T)*t", {"x", "t", "T"});
  EXPECT_FALSE(both.depends_on_position()) << "the x of exp is no variable";
  EXPECT_TRUE(both.depends_on_time());
  EXPECT_TRUE(both.depends_on_temperature());
}

TEST(Function, ConstantExpressionsAreFolded) {
  const auto f = Function::expression("2*(3 - 3)", position_and_time);
  EXPECT_TRUE(f.is_constant());
  EXPECT_TRUE(f.is_zero());
  EXPECT_EQ(f.text(), "2*(3 - 3)");
}

TEST(Function, ErrorsNameTheTokenThePositionAndWhatIsAllowed) {
  const std::string message = message_of("10 + w*t");
  EXPECT_NE(message.find("\"w\""), std::string::npos) << message;
  EXPECT_NE(message.find("position 5"), std::string::npos) << message;
  EXPECT_NE(message.find("x, y, z, t"), std::string::npos) << message;
  EXPECT_NE(message_of("2*T"), "") << "a variable that exists but is not allowed here";
  EXPECT_NE(message_of("2*x", {}).find("none"), std::string::npos);
}

TEST(Function, MalformedExpressionsAreRefused) {
  for (const char* text : {"", "2*(x", "x +", "sni(x)", "x y", "1, 2", "x = 3", "1/0", "min()"})
    EXPECT_NE(message_of(text), "") << text;
  EXPECT_THROW(Function::expression("1", {"banana"}), std::invalid_argument);
  for (const char* text : {"x == 3", "x <= 3", "x >= 3", "x != 3"}) EXPECT_EQ(message_of(text), "") << text;
}

TEST(Function, TableIsLinearInsideAndConstantOutside) {
  const auto f = Function::table("t", {0, 10, 30}, {1, 2, -2});
  EXPECT_DOUBLE_EQ(f({.t = -5}), 1);
  EXPECT_DOUBLE_EQ(f({.t = 0}), 1);
  EXPECT_DOUBLE_EQ(f({.t = 5}), 1.5);
  EXPECT_DOUBLE_EQ(f({.t = 10}), 2);
  EXPECT_DOUBLE_EQ(f({.t = 25}), -1);
  EXPECT_DOUBLE_EQ(f({.t = 30}), -2);
  EXPECT_DOUBLE_EQ(f({.t = 1e9}), -2);
  EXPECT_TRUE(std::isnan(f({.t = std::nan("")})));
  EXPECT_TRUE(f.depends_on_time());
  EXPECT_EQ(f.breakpoints(), (std::vector<double>{0, 10, 30}));
}

TEST(Function, TableInTimeMayJump) {
  const auto f = Function::table("t", {0, 0, 10, 10, 20, 20}, {5, 1, 2, 7, 3, 9});
  const double before = std::nextafter(10.0, 0.0), after = std::nextafter(10.0, 11.0);
  EXPECT_EQ(f({.t = -1}), 5);
  EXPECT_EQ(f({.t = 0}), 1);
  EXPECT_DOUBLE_EQ(f({.t = before}), 2);
  EXPECT_EQ(f({.t = 10}), 7);
  EXPECT_DOUBLE_EQ(f({.t = after}), 7);
  EXPECT_DOUBLE_EQ(f({.t = 15}), 5);
  EXPECT_DOUBLE_EQ(f({.t = std::nextafter(20.0, 0.0)}), 3);
  EXPECT_EQ(f({.t = 20}), 9);
  EXPECT_EQ(f.breakpoints(), (std::vector<double>{0, 10, 20}));
  EXPECT_EQ(f.text(), "{ t = [0, 0, 10, 10, 20, 20], values = [5, 1, 2, 7, 3, 9] }");
}

TEST(Function, KnowsRemaindersAndRoundingDown) {
  const auto f = Function::expression("mod(t, 50) + 1000*floor(t/50)", {"t"});
  EXPECT_DOUBLE_EQ(f({.t = 12.5}), 12.5);
  EXPECT_DOUBLE_EQ(f({.t = 112.5}), 2012.5);
  EXPECT_DOUBLE_EQ(f({.t = -12.5}), 37.5 - 1000) << "a remainder has the sign of the divisor";
}

/// The value and the breakpoints agree to the last bit, also where multiples of the period are no doubles.
TEST(Function, PeriodicTableRepeatsWithItsBreakpoints) {
  const auto f = Function::table("t", {0, 1, 24, 25}, {0, 1, 1, 0}, 50);
  for (const double cycle : {0.0, 50.0, 5000.0}) {
    EXPECT_DOUBLE_EQ(f({.t = cycle + 0.5}), 0.5);
    EXPECT_DOUBLE_EQ(f({.t = cycle + 20}), 1);
    EXPECT_DOUBLE_EQ(f({.t = cycle + 30}), 0);
  }
  EXPECT_EQ(f.breakpoints(), (std::vector<double>{0, 1, 24, 25, 50}));
  EXPECT_EQ(f.breakpoints(124), (std::vector<double>{0, 1, 24, 25, 50, 51, 74, 75, 100, 101, 124}));
  EXPECT_EQ(f.text(), "{ t = [0, 1, 24, 25], values = [0, 1, 1, 0], period = 50 }");

  const auto saw = Function::table("t", {0, 0.1}, {0, 1}, 0.1);  // jumps at the end of the period
  const std::vector<double> jumps = saw.breakpoints(1000);
  ASSERT_GE(jumps.size(), 9999u);
  for (std::size_t i = 1; i < jumps.size(); ++i) {
    EXPECT_NEAR(jumps[i], 0.1 * static_cast<double>(i), 1e-9);
    EXPECT_LT(saw({.t = jumps[i]}), 1e-9);
    EXPECT_GT(saw({.t = std::nextafter(jumps[i], 0.0)}), 1 - 1e-9) << i;
  }
}

TEST(Function, PeriodsThatDoNotFitTheTable) {
  EXPECT_THROW(Function::table("T", {0, 1}, {0, 1}, 2), std::invalid_argument);
  EXPECT_THROW(Function::table("t", {1, 2}, {0, 1}, 2), std::invalid_argument);
  EXPECT_THROW(Function::table("t", {0, 3}, {0, 1}, 2), std::invalid_argument);
  EXPECT_THROW(Function::table("t", {0, 3}, {0, 1}, -3), std::invalid_argument);
}

TEST(Function, RangeOfATable) {
  const auto f = Function::table("T", {20, 600}, {1, 2});
  ASSERT_TRUE(f.table_range("T"));
  EXPECT_EQ(f.table_range("T")->low, 20);
  EXPECT_EQ(f.table_range("T")->high, 600);
  EXPECT_FALSE(f.table_range("t"));
  EXPECT_FALSE(Function::expression("T", {"T"}).table_range("T"));
}

TEST(Function, TableInTemperatureHasNoBreakpoints) {
  const auto f = Function::table("T", {20, 500}, {2.1e5, 1.7e5});
  EXPECT_DOUBLE_EQ(f({.t = 500, .T = 260}), 1.9e5);
  EXPECT_TRUE(f.depends_on_temperature());
  EXPECT_FALSE(f.depends_on_time());
  EXPECT_TRUE(f.breakpoints().empty());
}

TEST(Function, TableOfOneValueIsAConstant) {
  EXPECT_TRUE(Function::table("t", {3}, {7}).is_constant());
  const auto level = Function::table("T", {0, 1}, {0, 0});
  EXPECT_TRUE(level.is_zero());
}

TEST(Function, TableMistakesAreRefused) {
  EXPECT_THROW(Function::table("x", {0, 1}, {0, 1}), std::invalid_argument);
  EXPECT_THROW(Function::table("t", {}, {}), std::invalid_argument);
  EXPECT_THROW(Function::table("t", {0, 1}, {0}), std::invalid_argument);
  EXPECT_THROW(Function::table("t", {0, 1, 1, 1}, {0, 1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(Function::table("T", {0, 1, 1}, {0, 1, 2}), std::invalid_argument);
  EXPECT_THROW(Function::table("t", {1, 0}, {0, 1}), std::invalid_argument);
  EXPECT_THROW(Function::table("t", {0, std::nan("")}, {0, 1}), std::invalid_argument);
}

TEST(Function, CopiesAreIndependentOfTheOriginalsLife) {
  Function copy;
  {
    const auto original = Function::expression("x^2", {"x"});
    copy = original;
  }
  EXPECT_DOUBLE_EQ(copy({.x = 3}), 9);
}

TEST(Function, ComposedOfOthers) {
  const Function slope = Function::expression("2*T", {"T"}), table = Function::table("t", {0, 3}, {1, 4});
  const Function sum = Function::composed("2*T + table", {slope, table},
                                          [](const std::vector<double>& values) { return values[0] + values[1]; });
  EXPECT_EQ(sum({.t = 1, .T = 10}), 22.0);
  EXPECT_TRUE(sum.depends_on_temperature() && sum.depends_on_time());
  EXPECT_FALSE(sum.depends_on_position() || sum.is_constant());
  EXPECT_EQ(sum.breakpoints(), (std::vector<double>{0, 3}));
  EXPECT_EQ(sum.text(), "2*T + table");
  const Function constant =
      Function::composed("3/(2)", {2.0}, [](const std::vector<double>& values) { return 3 / values[0]; });
  EXPECT_TRUE(constant.is_constant());
  EXPECT_EQ(constant({}), 1.5);
}

}  // namespace
}  // namespace creepcontact
