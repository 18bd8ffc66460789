#include "creepcontact/base/run_counters.hpp"

#include <gtest/gtest.h>

#include <set>

namespace creepcontact {
namespace {

RunCounters numbered(std::int64_t first) {
  RunCounters result;
  for (const RunCounters::Field& field : RunCounters::fields) result.*field.value = first++;
  return result;
}

TEST(RunCounters, EveryFieldHasANameAndAMemberOfItsOwn) {
  std::set<std::string_view> names;
  for (const RunCounters::Field& field : RunCounters::fields) names.insert(field.name);
  EXPECT_EQ(names.size(), RunCounters::fields.size());
  const RunCounters counters = numbered(1);
  for (std::size_t i = 0; i < RunCounters::fields.size(); ++i)
    EXPECT_EQ(counters.*RunCounters::fields[i].value, static_cast<std::int64_t>(i) + 1) << RunCounters::fields[i].name;
}

TEST(RunCounters, AreAddedAndSubtractedFieldByField) {
  const RunCounters sum = numbered(1) + numbered(10);
  for (std::size_t i = 0; i < RunCounters::fields.size(); ++i)
    EXPECT_EQ(sum.*RunCounters::fields[i].value, 11 + 2 * static_cast<std::int64_t>(i));
  EXPECT_EQ(sum - numbered(10), numbered(1));
}

TEST(RunCounters, AreSavedByName) {
  Memory memory;
  memory.save("earlier", RunCounters{.steps = 12, .factorizations = 2});
  EXPECT_EQ(memory.size(), RunCounters::fields.size());
  EXPECT_EQ(memory.at("earlier.steps"), std::vector<double>{12});
  RunCounters found;
  memory.restore("earlier", found);
  EXPECT_EQ(found, (RunCounters{.steps = 12, .factorizations = 2}));
}

}  // namespace
}  // namespace creepcontact
