/// Histories and summaries are read back as they were written.
#include "creepcontact/io/tables/csv_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "creepcontact/base/error.hpp"
#include "creepcontact/io/tables/history_writer.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

class ReadBack : public testing::Test {
 protected:
  void write(const std::string& text) { std::ofstream(file_) << text; }
  std::string mistake() {
    try {
      read_csv_table(file_);
      return "";
    } catch (const ConfigError& error) {
      return error.what();
    }
  }
  test::TemporaryDirectory directory_;
  std::filesystem::path file_ = directory_ / "history.csv";
};

TEST_F(ReadBack, HistoryToTheLastBit) {
  const std::vector<double> values{1.0 / 3, -2e-300};
  HistoryWriter(file_, {"a", "b c"}).write(0.1, values);
  const CsvTable table = read_csv_table(file_);
  EXPECT_EQ(table.names, (std::vector<std::string>{"time", "a", "b c"}));
  EXPECT_EQ(*table.column("time"), std::vector<double>{0.1});
  EXPECT_EQ(*table.column("a"), std::vector<double>{1.0 / 3});
  EXPECT_EQ(*table.column("b c"), std::vector<double>{-2e-300});
  EXPECT_EQ(table.column("c"), nullptr);
}

TEST_F(ReadBack, TablesOfOtherPrograms) {
  write("\xEF\xBB\xBFtime, \"p, \"\"mean\"\"\"\r\n1, 2\r\n\r\n3,4e2\n");
  const CsvTable table = read_csv_table(file_);
  EXPECT_EQ(table.names[1], "p, \"mean\"");
  EXPECT_EQ(table.columns[1], (std::vector<double>{2, 400}));
}

TEST_F(ReadBack, TwoDecimalSignsAreRefused) {
  write("time;p\n1;0,5\n1.000;0,6\n");
  EXPECT_TRUE(test::says(mistake(), {file_.string() + ":3: ", "'1.000'", "'0,5'", "line 2"}));
}

TEST_F(ReadBack, ARowWithoutItsEndMayBeTorn) {
  write("time,a\n0,1\n1e3,-nan\n2,3.25");
  EXPECT_EQ(read_csv_table(file_).columns[1].back(), 3.25);
  const CsvTable whole_rows = read_csv_table(file_, UnendedRow::is_left_out);
  EXPECT_EQ(whole_rows.columns[0], (std::vector<double>{0, 1e3}));
  EXPECT_TRUE(std::isnan(whole_rows.columns[1].back()));
}

TEST_F(ReadBack, MistakesNameTheLine) {
  EXPECT_TRUE(test::says(mistake(), {file_.string() + ": ", "No such file or directory"}));
  write("time,a\n1,2\n3,x\n");
  EXPECT_TRUE(test::says(mistake(), {file_.string() + ":3: ", "'x'"}));
  write("time,a\n1\n");
  EXPECT_TRUE(test::says(mistake(), {file_.string() + ":2: ", "1", "2 columns"}));
}

TEST_F(ReadBack, Summary) {
  Summary written;
  written.status = Summary::Status::ruptured;
  written.message = "said";
  written.steps = 7;
  written.elastic_solves = 21;
  written.schwarz_iterations = 5;
  written.time_reached = 0.3;
  written.wall_seconds.total = 1.5;
  write_summary(directory_ / "summary.json", written);
  const auto read = read_summary(directory_ / "summary.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->status, Summary::Status::ruptured);
  EXPECT_EQ(read->message, "said");
  EXPECT_EQ(read->steps, 7);
  EXPECT_EQ(read->elastic_solves, 21);
  EXPECT_EQ(read->schwarz_iterations, 5);
  EXPECT_EQ(read->time_reached, 0.3);
  EXPECT_EQ(read->wall_seconds.total, 1.5);
}

TEST_F(ReadBack, CountsOfASummaryAreWholeNumbers) {
  const std::string rest = R"(, "status": "completed", "version": "0.1.0", "time_reached": 1, "elastic_solves": 1,
    "schwarz_iterations": 1, "rejected_steps": 0, "convergence_failures": 0, "rhs_evaluations": 1,
    "jacobian_products": 0, "contact_solves": 1, "factorizations": 1, "wall_seconds": {"total": 1}})";
  EXPECT_TRUE(parse_summary(R"({"steps": 3)" + rest));
  EXPECT_TRUE(parse_summary(R"({"steps": -3)" + rest));
  EXPECT_FALSE(parse_summary(R"({"steps": 1e300)" + rest));
}

TEST_F(ReadBack, NoSummary) {
  EXPECT_FALSE(read_summary(file_));
  write("{\"status\": \"completed\"}");
  EXPECT_FALSE(read_summary(file_));
}

TEST(CsvTableFormats, AreFoundInTheHeader) {
  using Columns = std::vector<std::vector<double>>;
  const Columns expected{{0.5, 1}, {-2, 3e-7}};
  EXPECT_EQ(parse_csv_table("time,a\n0.5,-2\n1,3e-7\n", "t.csv").columns, expected);
  EXPECT_EQ(parse_csv_table("time;a\n0,5;-2\n1;3e-7\n", "t.csv").columns, expected);
  EXPECT_EQ(parse_csv_table("time;a\n0.5;-2.0\n1;3e-7\n", "t.csv").columns, expected);
  EXPECT_EQ(parse_csv_table("time\ta\r\n0,5\t-2\r\n1\t3e-7\r\n", "t.csv").columns, expected);
  EXPECT_EQ(parse_csv_table("\"x;y\",b;c\n1,2\n", "t.csv").names, (std::vector<std::string>{"x;y", "b;c"}));
  EXPECT_THROW(parse_csv_table("time;a\n1,2,3;4\n", "t.csv"), ConfigError);
}

}  // namespace
}  // namespace creepcontact::io
