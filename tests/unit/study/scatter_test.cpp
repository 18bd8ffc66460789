/// What many runs tell together, of made-up runs; their files by shard, and gathering them.
#include "../../../src/study/scatter.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>

#include "../../../src/study/histories.hpp"
#include "../../../src/study/run_records.hpp"
#include "../../../src/study/scatter_tables.hpp"
#include "../../../src/study/shard_file.hpp"
#include "../../../src/study/shards.hpp"
#include "../../../src/study/study_directory.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/study/study.hpp"
#include "support/says.hpp"
#include "unit/config/config_fixture.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::study {
namespace {

const std::vector<std::size_t> three{0, 1, 2};

io::CsvTable table_of(const std::vector<double>& times, const std::vector<double>& values) {
  return {{"time", "q"}, {times, values}};
}

TEST(StudyHistories, TimesThatAllWholeRunsHave) {
  Histories histories({"q"}, 3);
  histories.take(0, table_of({0, 1, 2, 3}, {10, 11, 12, 13}), true);
  histories.take(1, table_of({0, 2, 3}, {20, 22, 23}), true);
  histories.take(2, table_of({0, 2, 2.5}, {30, 32, 99}), false);  // ruptures at 2.5
  EXPECT_EQ(histories.common_times(three), (std::vector<double>{0, 2, 3}));
  EXPECT_EQ(histories.at(three, 0, 2), (std::vector<double>{12, 22, 32}));
  EXPECT_EQ(sorted_known(histories.at(three, 0, 3)), (std::vector<double>{13, 23}));
  EXPECT_FALSE(histories.is_thinned());
}

TEST(StudyHistories, MemoryIsBounded) {
  Histories histories({"q"}, 3, 3 * 4);
  std::vector<double> times, values;
  for (int i = 0; i < 10; ++i) {
    times.push_back(i);
    values.push_back(2 * i);
  }
  for (const std::size_t run : three) histories.take(run, table_of(times, values), true);
  EXPECT_TRUE(histories.is_thinned());
  EXPECT_EQ(histories.common_times(three), (std::vector<double>{0, 3, 6, 9}));
  EXPECT_EQ(histories.at({1}, 0, 6), std::vector<double>{12});
}

TEST(StudyScatter, NamesOfColumns) {
  EXPECT_EQ(percent_name(0.05), "05");
  EXPECT_EQ(percent_name(0.5), "50");
  EXPECT_EQ(percent_name(0.975), "97_5");
  EXPECT_EQ(percent_name(0.025), "02_5");
  EXPECT_EQ(percent_name(0.001), "00_1");
}

TEST(StudyShards, EveryRunIsInOneShard) {
  std::vector<int> seen(10, 0);
  for (int i = 1; i <= 3; ++i)
    for (const std::size_t run : runs_of_shard(10, {i, 3})) {
      ++seen[run];
      EXPECT_EQ(shard_of_run(run, 3), i);
    }
  EXPECT_EQ(seen, std::vector<int>(10, 1));
  EXPECT_TRUE(runs_of_shard(2, {3, 3}).empty());
}

KeptRun made_up(double value, const std::vector<double>& times) {
  KeptRun run;
  run.outcome.row.status = "completed";
  run.outcome.row.counted = true;
  run.outcome.row.steps = 17;
  run.outcome.row.wall_seconds = 0.25;
  run.outcome.row.end_time = times.back();
  std::vector<double> values;
  for (const double time : times) values.push_back(value / (1 + time));
  run.outcome.history = table_of(times, values);
  run.outcome.extremes["q"] = {ProbeCourse::unknown, ProbeCourse::unknown, values.back(), value};
  run.outcome.row.events["low"] = value < 5 ? 1.5 : ProbeCourse::unknown;
  return run;
}

TEST(StudyShards, FileGivesBackWhatWasKept) {
  const io::test::TemporaryDirectory directory;
  ShardRuns runs;
  runs[3] = made_up(4, {0, 1, 2});
  runs[3].record = 0xfedcba9876543210U;
  runs[5] = made_up(8, {0, 2});
  runs[5].outcome.row.criteria["tight"] = 0.5;
  runs[7].outcome.row.status = "failed";
  runs[7].outcome.row.message = "no step\nis small enough";
  write_shard_file(directory.path() / "runs.h5", runs);
  const ShardRuns read = read_shard_file(directory.path() / "runs.h5");
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read.at(3).record, 0xfedcba9876543210U);
  EXPECT_EQ(*read.at(3).outcome.history.column("q"), *runs[3].outcome.history.column("q"));
  EXPECT_EQ(*read.at(5).outcome.history.column("time"), (std::vector<double>{0, 2}));
  EXPECT_EQ(read.at(3).outcome.row.steps, 17);
  EXPECT_EQ(read.at(3).outcome.row.events.at("low"), 1.5);
  EXPECT_TRUE(std::isnan(read.at(5).outcome.row.events.at("low")));
  EXPECT_FALSE(read.at(3).outcome.row.criteria.contains("tight"));
  EXPECT_EQ(read.at(5).outcome.row.criteria.at("tight"), 0.5);
  EXPECT_EQ(read.at(5).outcome.extremes.at("q").max, 8);
  EXPECT_EQ(read.at(7).outcome.row.status, "failed");
  EXPECT_EQ(read.at(7).outcome.row.message, "no step is small enough");
  EXPECT_FALSE(read.at(7).outcome.row.counted);

  std::ofstream(directory.path() / "runs.h5", std::ios::app) << "x";
  EXPECT_THROW(read_shard_file(directory.path() / "runs.h5"), ConfigError);
}

TEST(StudyShards, CountIsSaidOnce) {
  const io::test::TemporaryDirectory directory;
  EXPECT_FALSE(shard_count(directory.path()));
  claim_shard_count(directory.path(), 16);
  claim_shard_count(directory.path(), 16);
  EXPECT_EQ(shard_count(directory.path()), 16);
  try {
    claim_shard_count(directory.path(), 8);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_TRUE(creepcontact::test::says(error.what(), {"16 shards", "--shard i/16", "/8", "--output"}));
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory.path() / "shards"), {}), 1);
}

/// Shards full of made-up runs: the value of a run is what its random key says.
class Gathering : public testing::Test {
 protected:
  void gather(int samples, int shards, std::size_t n_times) const {
    const auto path = directory_.path();
    std::ofstream(path / "base.toml") << config::minimal
                                      << "[[probes]]\nname = \"q\"\nquantity = \"von_mises\"\nbody = \"block\"\n";
    const config::Study study =
        config::parse_study("base = \"base.toml\"\n[random]\nsamples = " + std::to_string(samples) +
                                "\n[[random.keys]]\nkey = \"materials.steel.young_modulus\"\ndistribution = "
                                "\"uniform\"\nmin = 4\nmax = 8\n",
                            path / "study.toml");
    const StudyOptions options{.program = "creepcontact", .output = path / "out"};
    config::Vocabulary vocabulary;
    vocabulary.integrators = {"cvode_bdf"};
    vocabulary.quantities = {{.name = "von_mises"}};
    const auto runs = config::plan(study);
    claim_directory(path / "out", study);
    claim_shard_count(path / "out", shards);
    std::vector<double> times;
    for (std::size_t t = 0; t < n_times; ++t) times.push_back(static_cast<double>(t));
    RunRecords records(study, vocabulary);
    for (int i = 1; i <= shards; ++i) {
      ShardRuns kept;
      for (const std::size_t run : runs_of_shard(runs.size(), {i, shards})) {
        kept[run] = made_up(runs[run].sampled.front(), times);
        kept[run].record = record_checksum(records.of(runs[run]));
      }
      std::filesystem::create_directories(shard_directory(path / "out", i));
      write_shard_file(shard_file(path / "out", i), kept);
    }
    const auto begin = std::chrono::steady_clock::now();
    const StudyResult result = gather_study(study, vocabulary, options);
    RecordProperty("seconds",
                   std::to_string(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()));
    EXPECT_EQ(result.exit_status, 0) << result.message;
    const io::CsvTable quantiles = io::read_csv_table(path / "out" / "quantiles.csv");
    ASSERT_EQ(quantiles.rows(), n_times);
    EXPECT_EQ(quantiles.column("samples")->back(), samples);
    const double end = static_cast<double>(n_times);  // 1 + the last time
    EXPECT_NEAR(quantiles.column("q_q05")->back(), 4.2 / end, 2e-3 / end);
    EXPECT_NEAR(quantiles.column("q_q95")->back(), 7.8 / end, 2e-3 / end);
    EXPECT_NEAR(io::read_csv_table(path / "out" / "probabilities.csv").column("low")->back(), 0.25, 1e-3);
  }

  const io::test::TemporaryDirectory directory_;
};

TEST_F(Gathering, TwoThousandRunsOfSixteenShards) {
  gather(2048, 16, 5);
}

TEST_F(Gathering, DISABLED_AHundredThousandRuns) {  // to be measured: --gtest_also_run_disabled_tests
  gather(100'000, 100, 50);
}

}  // namespace
}  // namespace creepcontact::study
