#include "support/run/result_files.hpp"

#include <gtest/gtest.h>

#include <exception>
#include <stdexcept>

#include "unit/io/temporary_directory.hpp"

namespace creepcontact::test {
namespace {

using io::test::write_text;

TEST(ResultFiles, TablesByNameAndTime) {
  const io::test::TemporaryDirectory directory;
  const Table table(write_text(directory / "history.csv", "time,\"a,b\",c\n0,1,2\n1e6,3,5\n"));
  EXPECT_EQ(table.names(), (std::vector<std::string>{"time", "a,b", "c"}));
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.times(), (std::vector<double>{0, 1e6}));
  EXPECT_EQ(table.sum("c"), 7);
  EXPECT_EQ(table.at("a,b", 1e6 + 1e-4), 3);
  EXPECT_THROW(table.at("c", 1e6 + 1), std::out_of_range);
  EXPECT_THROW(table.at("d", 0), std::out_of_range);
  EXPECT_THROW(Table(directory / "steps.csv"), Error);
}

TEST(ResultFiles, SummariesByKey) {
  const io::test::TemporaryDirectory directory;
  const SummaryFile summary(write_text(directory / "summary.json",
                                       R"({"status": "completed", "steps": 7, "contacts": {"a-b": {"force": 2.5}}})"));
  EXPECT_EQ(summary.text("status"), "completed");
  EXPECT_EQ(summary.number("steps"), 7);
  EXPECT_EQ(summary.number("contacts/a-b/force"), 2.5);
  EXPECT_TRUE(summary.has("contacts/a-b"));
  EXPECT_FALSE(summary.has("contacts/force"));
  EXPECT_THROW(summary.number("status"), std::exception);
  EXPECT_THROW(summary.text("message"), std::exception);
  EXPECT_THROW(SummaryFile(directory / "none.json"), std::exception);
}

}  // namespace
}  // namespace creepcontact::test
