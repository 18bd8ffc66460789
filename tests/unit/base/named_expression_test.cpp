#include "creepcontact/base/named_expression.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace creepcontact {
namespace {

const std::vector<std::string> probe_names{"fit", "seal_2", "fit-force", "max", "t"};

double named_value(const std::string& text) {
  return NamedExpression(text, probe_names)(std::array{2.0, 3.0, 5.0, 7.0, 11.0});
}

TEST(NamedExpression, ValuesOfNames) {
  EXPECT_DOUBLE_EQ(named_value("0.12*fit*0.06 + seal_2^2 - t"), 0.12 * 2 * 0.06 + 9 - 11);
  EXPECT_DOUBLE_EQ(named_value("max(fit, seal_2) + pi"), 3 + M_PI);
  EXPECT_EQ(NamedExpression("seal_2 + fit*t", probe_names).used(), (std::vector<std::size_t>{0, 1, 4}));
  EXPECT_EQ(NamedExpression("3", probe_names).used(), std::vector<std::size_t>());
}

TEST(NamedExpression, Conditions) {
  for (const char* text : {"fit < 3", "fit <= 2 && t > 10", "fit > 3 || seal_2 == 3", "fit != 3", "(fit < 1) == 0"})
    EXPECT_EQ(named_value(text), 1) << text;
  for (const char* text : {"fit > 3", "fit < 3 && t < 10", "fit > 3 || seal_2 < 3"})
    EXPECT_EQ(named_value(text), 0) << text;
}

TEST(NamedExpression, TwoKeepTheirValuesApart) {
  const NamedExpression a("2*fit", probe_names), b("3*fit", probe_names);
  EXPECT_EQ(a(std::array{1.0, 0.0, 0.0, 0.0, 0.0}), 2);
  EXPECT_EQ(b(std::array{10.0, 0.0, 0.0, 0.0, 0.0}), 30);
  EXPECT_EQ(a(std::array{1.0, 0.0, 0.0, 0.0, 0.0}), 2);
}

TEST(NamedExpression, UnknownNamesAreNamed) {
  try {
    named_value("2*(fitt + 1)");
    FAIL();
  } catch (const UnknownName& error) {
    EXPECT_EQ(error.name.substr(0, 4), "fitt");
  }
  for (const char* text : {"fit = 3", "fit <", "fit, 3", "", "(fit"})
    EXPECT_THROW(named_value(text), std::invalid_argument) << text;
}

TEST(NamedExpression, NamesThatCannotBeVariables) {
  for (const char* name : {"fit", "seal_2", "_a", "t"}) EXPECT_TRUE(NamedExpression::can_be_variable(name)) << name;
  for (const char* name : {"", "fit-force", "2nd", "mean stress", "max", "mod", "pi", "_e"})
    EXPECT_FALSE(NamedExpression::can_be_variable(name)) << name;
}

}  // namespace
}  // namespace creepcontact
