#include "../../../src/deck/linear_equations.hpp"

#include <gtest/gtest.h>

namespace creepcontact::deck {
namespace {

Course constant(double value) {
  Course course;
  course.add(0, value);
  return course;
}

TEST(Courses, SumsKeepJumpsAndCorners) {
  Course ramp, step;
  ramp.add(0, 0);
  ramp.add(2, 4);
  step.add(0, 1);
  step.add(1, 1);
  step.add(1, 10);
  step.add(2, 10);
  const Course sum = ramp.plus(step);
  EXPECT_EQ(sum.function().text(), "{ t = [0, 1, 1, 2], values = [1, 3, 12, 14] }");
  EXPECT_EQ(sum.before(1), 3);
  EXPECT_EQ(sum.at(1), 12);
  EXPECT_EQ(Course().plus(step).function().text(), step.function().text());
}

/// u1 of 1 and 2 are those of the reference node 9; 2 u1 of 3 follows.
std::vector<DeckEquation> three() {
  return {{{{{1, 0}, 1}, {{9, 0}, -1}}, {}, {}, "EQUATION"},
          {{{{2, 0}, 1}, {{9, 0}, -1}}, {}, {}, "EQUATION"},
          {{{{3, 0}, 2}, {{9, 0}, -1}}, {}, {}, "EQUATION"}};
}

TEST(ReferenceNodes, PrescribedOnesBecomeValues) {
  std::vector<DeckEquation> equations = three();
  Loading loading;
  loading.supports[9][1] = constant(0.5);
  eliminate_reference_nodes(equations, {1, 2, 3}, loading);
  ASSERT_EQ(equations.size(), 3U);
  for (const DeckEquation& equation : equations) {
    EXPECT_EQ(equation.terms.size(), 1U);
    EXPECT_EQ(equation.value.last(), 0.5);
  }
  EXPECT_TRUE(loading.supports.empty());
}

TEST(ReferenceNodes, FreeOnesAreEliminatedWithTheirForce) {
  std::vector<DeckEquation> equations = three();
  Loading loading;
  loading.forces[9][1] = constant(7);
  eliminate_reference_nodes(equations, {1, 2, 3}, loading);
  ASSERT_EQ(equations.size(), 2U);
  for (const DeckEquation& equation : equations) {
    EXPECT_EQ(equation.terms.size(), 2U);
    EXPECT_FALSE(equation.terms.contains({9, 0}));
  }
  // One node stands for the reference node: the equations hand the force on to the others.
  ASSERT_EQ(loading.forces.size(), 1U);
  EXPECT_EQ(loading.forces.begin()->second.at(1).last(), 7);
}

}  // namespace
}  // namespace creepcontact::deck
