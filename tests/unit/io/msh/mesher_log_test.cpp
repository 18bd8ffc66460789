#include "../../../../src/io/msh/mesher_log.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace creepcontact::io {
namespace {

TEST(MesherLog, TellsRepeatedWarningsOnceWithTheirNumber) {
  MesherLog log;
  for (int i = 0; i < 30; ++i) log.add(fmt::format("Warning : element {} has volume {}\n", 100 + i, -1.5 * (i + 1)));
  log.add("Info    : 3 nodes\nWarning : no elements");
  log.add(" in volume 7\n");
  log.add("Warning : element 7 has volume 0\n");
  log.end();
  EXPECT_EQ(log.warnings(), (std::vector<std::string>{"element 100 has volume -1.5 (30 times)",
                                                      "no elements in volume 7", "element 7 has volume 0"}));
  EXPECT_EQ(log.errors(), "");
}

TEST(MesherLog, TellsTheFirstOfManyWarnings) {
  MesherLog log;
  for (char kind = 'a'; kind <= 'z'; ++kind) log.add(fmt::format("Warning : {}\n", kind));
  const std::vector<std::string> warnings = log.warnings();
  ASSERT_EQ(warnings.size(), 21U);
  EXPECT_EQ(warnings.front(), "a");
  EXPECT_EQ(warnings.back(), "6 others");
}

}  // namespace
}  // namespace creepcontact::io
