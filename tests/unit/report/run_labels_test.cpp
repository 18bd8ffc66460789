/// Runs are called by what differs between them.

#include "../../../src/report/run_labels.hpp"

#include <gtest/gtest.h>

namespace creepcontact::report {
namespace {

using Labels = std::vector<std::string>;

io::ModelRecord record(const std::string& gap, const std::string& order = "1") {
  io::ModelRecord made;
  made.inputs = {{"title", "\"run " + gap + "\""}, {"mesh.order", order}, {"contacts[0].gap", gap}};
  return made;
}

Labels labels(const std::vector<io::ModelRecord>& runs) {
  std::vector<const io::ModelRecord*> all;
  Labels directories;
  for (const io::ModelRecord& run : runs) {
    all.push_back(&run);
    directories.push_back("run_" + std::to_string(all.size()));
  }
  return labels_by_inputs(input_differences(all), directories);
}

TEST(RunLabels, ByTheKeysThatDiffer) {
  EXPECT_EQ(labels({record("-0.1"), record("-0.2")}), (Labels{"gap = -0.1", "gap = -0.2"}));
  EXPECT_EQ(labels({record("-0.1"), record("-0.1", "2")}), (Labels{"order = 1", "order = 2"}));
  EXPECT_EQ(labels({record("-0.1"), record("-0.2", "2")}), (Labels{"order = 1, gap = -0.1", "order = 2, gap = -0.2"}));
}

TEST(RunLabels, AValueBelongsToItsTable) {
  io::ModelRecord cold, hot;
  cold.inputs = {{"temperature.value", "480"}};
  hot.inputs = {{"temperature.value", "500"}};
  EXPECT_EQ(labels({cold, hot}), (Labels{"temperature.value = 480", "temperature.value = 500"}));
}

TEST(RunLabels, ElseByTheDirectories) {
  EXPECT_EQ(labels({record("1"), record("1")}), (Labels{"run_1", "run_2"}));
  EXPECT_EQ(labels({record("1"), {}}), (Labels{"run_1", "run_2"}));  // of an earlier version
  EXPECT_EQ(labels({record("1"), record("2"), record("1")}),
            (Labels{"run_1 (gap = 1)", "run_2 (gap = 2)", "run_3 (gap = 1)"}));
}

}  // namespace
}  // namespace creepcontact::report
