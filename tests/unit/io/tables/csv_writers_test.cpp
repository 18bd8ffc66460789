#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "creepcontact/io/tables/csv_table.hpp"
#include "creepcontact/io/tables/history_writer.hpp"
#include "creepcontact/io/tables/step_writer.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

using test::message_of;
using test::read_text;
using test::says;

class CsvWriters : public testing::Test {
 protected:
  test::TemporaryDirectory directory_;
  std::filesystem::path path_ = directory_ / "results/history.csv";
};

TEST_F(CsvWriters, RowsAreOnDiskAtOnce) {
  HistoryWriter writer(path_, {"fit", "bore"});
  EXPECT_EQ(read_text(path_), "time,fit,bore\n");
  writer.write(0, std::array{1.5, -2.0});
  EXPECT_EQ(read_text(path_), "time,fit,bore\n0,1.5,-2\n");
}

TEST_F(CsvWriters, NumbersReadBackToTheSameDouble) {
  const double third = 1.0 / 3, tiny = 4.9406564584124654e-324, large = std::numeric_limits<double>::max();
  HistoryWriter(path_, {"a", "b"}).write(third, std::array{tiny, large});
  const CsvTable table = read_csv_table(path_);
  EXPECT_EQ(table.names, (std::vector<std::string>{"time", "a", "b"}));
  EXPECT_EQ(table.columns, (std::vector<std::vector<double>>{{third}, {tiny}, {large}}));
}

TEST_F(CsvWriters, StepsHaveTheColumnsOfTheContract) {
  RunCounters work;
  work.rhs_evaluations = 10;
  work.elastic_solves = 20;
  work.schwarz_iterations = 30;
  StepWriter(path_).write({2.5, 0.5, 3, work, 4, 0.25});
  EXPECT_EQ(read_text(path_),
            "time,step,order,rhs_evaluations,elastic_solves,schwarz_iterations,active_contacts,error_estimate\n"
            "2.5,0.5,3,10,20,30,4,0.25\n");
}

TEST_F(CsvWriters, ResumingCutsAfterTheCheckpointAndGoesOn) {
  {
    HistoryWriter writer(path_, {"a"});
    for (double t : {0.0, 0.1, 0.2, 0.30000000000000004, 0.4}) writer.write(t, std::array{t});
  }
  HistoryWriter(path_, {"a"}, {true, 0.30000000000000004}).write(7, std::array{8.0});
  EXPECT_EQ(read_text(path_), "time,a\n0,0\n0.1,0.1\n0.2,0.2\n0.30000000000000004,0.30000000000000004\n7,8\n");
}

TEST_F(CsvWriters, ResumingDropsATornRow) {
  std::filesystem::create_directories(path_.parent_path());
  test::write_text(path_, "time,a\n0,0\n1,1\n2");
  HistoryWriter(path_, {"a"}, {true, 10}).write(3, std::array{4.0});
  EXPECT_EQ(read_text(path_), "time,a\n0,0\n1,1\n3,4\n");
}

TEST_F(CsvWriters, ResumingWithoutAFileBeginsAnew) {
  HistoryWriter(path_, {"a"}, {true, 10}).write(11, std::array{1.0});
  EXPECT_EQ(read_text(path_), "time,a\n11,1\n");
}

TEST_F(CsvWriters, ResumingWithOtherProbesIsAnErrorAndKeepsTheFile) {
  HistoryWriter(path_, {"a"}).write(0, std::array{1.0});
  const std::string before = read_text(path_);
  const std::string message = message_of<ConfigError>([&] { HistoryWriter(path_, {"a", "b"}, {true, 1}); });
  EXPECT_TRUE(says(message, {"history.csv'", "'time,a'", "'time,a,b'"}));
  EXPECT_EQ(read_text(path_), before);
}

TEST_F(CsvWriters, NotResumingOverwrites) {
  HistoryWriter(path_, {"a"}).write(0, std::array{1.0});
  HistoryWriter(path_, {"b"});
  EXPECT_EQ(read_text(path_), "time,b\n");
}

TEST_F(CsvWriters, NamesWithCommasAndQuotesAreQuoted) {
  HistoryWriter(path_, {"a,b", "c\"d"});
  EXPECT_EQ(read_text(path_), "time,\"a,b\",\"c\"\"d\"\n");
}

constexpr CsvFormat german{.separator = ';', .decimal = ','};

TEST_F(CsvWriters, OtherSeparatorsAndADecimalComma) {
  HistoryWriter writer(path_, {"a;b", "c,d"}, {}, german);
  writer.write(0.5, std::array{-1e-7, 2.0});
  EXPECT_EQ(read_text(path_), "time;\"a;b\";\"c,d\"\n0,5;-1e-07;2\n");
  HistoryWriter(path_, {"a"}, {}, {.separator = '\t', .decimal = '.'}).write(0.5, std::array{1.5});
  EXPECT_EQ(read_text(path_), "time\ta\n0.5\t1.5\n");
}

TEST_F(CsvWriters, ResumingReadsADecimalComma) {
  {
    HistoryWriter writer(path_, {"a"}, {}, german);
    for (double t : {0.0, 0.25, 0.5}) writer.write(t, std::array{t});
  }
  HistoryWriter(path_, {"a"}, {true, 0.3}, german).write(7.5, std::array{8.0});
  EXPECT_EQ(read_text(path_), "time;a\n0;0\n0,25;0,25\n7,5;8\n");
  EXPECT_TRUE(says(message_of<ConfigError>([&] { HistoryWriter(path_, {"a"}, {true, 1}); }), {"output.separator"}));
}

TEST_F(CsvWriters, APlaceThatCannotBeWrittenIsAnError) {
  test::write_text(directory_ / "file", "");
  EXPECT_TRUE(says(message_of<ConfigError>([&] { StepWriter(directory_ / "file/steps.csv"); }), {"file/steps.csv'"}));
}

TEST_F(CsvWriters, AFullDiskIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  EXPECT_TRUE(says(message_of<Error>([] { StepWriter("/dev/full"); }), {"'/dev/full'"}));
}

}  // namespace
}  // namespace creepcontact::io
