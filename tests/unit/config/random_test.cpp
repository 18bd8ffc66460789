/// [random] of a study: what is read, which samples come of it, and every mistake at its place.
#include "creepcontact/config/random.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "complaints.hpp"
#include "config_fixture.hpp"
#include "creepcontact/config/study.hpp"
#include "support/says.hpp"

namespace creepcontact::config {
namespace {

using RandomLines = std::vector<std::string>;

const std::string beginning = "base = \"base.toml\"\n";  // line 1

std::string random_key(const std::string& key, const std::string& rest) {
  return fmt::format("[[random.keys]]\nkey = \"{}\"\n{}\n", key, rest);
}
std::string uniform_key(const std::string& key) {
  return random_key(key, "distribution = \"uniform\"\nmin = 1\nmax = 2");
}
std::string random_head(const std::string& rest = "") {
  return beginning + "[random]\nsamples = 8\n" + rest;
}

void expect_only(const RandomLines& lines, std::initializer_list<std::string_view> facts) {
  ASSERT_EQ(lines.size(), 1u) << (lines.empty() ? "no mistake" : lines[0] + "\n" + lines.back());
  EXPECT_TRUE(creepcontact::test::says(lines[0], facts)) << lines[0];
}

void expect_random_mistake(const std::string& text, std::initializer_list<std::string_view> facts) {
  expect_only(complaints([&] { parse_study(text, "s/study.toml"); }), facts);
}

TEST(RandomReading, EveryKey) {
  const Study study = parse_study(
      "keep = \"shard\"\n" + random_head("method = \"latin_hypercube\"\nseed = 5\nquantiles = [0.1, 0.9]\n") +
          random_key("a.A", "distribution = \"lognormal\"\nmedian = 2e-18\nfactor = 2") +
          random_key("a.n", "distribution = \"normal\"\nmean = 5\ndeviation = 0.1") +
          random_key("b", "distribution = \"triangular\"\nmin = 1\nmode = 2\nmax = 4") +
          random_key("c", "distribution = \"table\"\nvalues = [3, 1, 3]\nweights = [1, 2, 1]") +
          random_key("d", "distribution = \"table\"\nvalues = [1, 2]\ncumulative = [0, 1]") + uniform_key("e") +
          "[[random.correlations]]\nkeys = [\"a.A\", \"a.n\"]\nvalue = -0.5\n",
      "s/study.toml");
  ASSERT_TRUE(study.random);
  const Random& random = *study.random;
  EXPECT_EQ(random.samples, 8);
  EXPECT_EQ(random.method, statistics::SamplingMethod::latin_hypercube);
  EXPECT_EQ(random.seed, 5);
  EXPECT_EQ(random.quantiles, (std::vector<double>{0.1, 0.9}));
  ASSERT_EQ(random.keys.size(), 6u);
  EXPECT_EQ(random.keys[0].key.name, "a.A");
  EXPECT_EQ(std::get<statistics::Lognormal>(random.keys[0].distribution).factor, 2);
  EXPECT_EQ(std::get<statistics::Normal>(random.keys[1].distribution).mean, 5);
  EXPECT_EQ(std::get<statistics::Triangular>(random.keys[2].distribution).mode, 2);
  const auto& measured = std::get<statistics::Table>(random.keys[3].distribution);
  EXPECT_EQ(measured.values, (std::vector<double>{1, 3}));
  EXPECT_EQ(measured.cumulative, (std::vector<double>{0.5, 1}));
  EXPECT_TRUE(std::get<statistics::Table>(random.keys[4].distribution).is_continuous);
  EXPECT_EQ(random.factor.size(), 36u);
  EXPECT_EQ(study.keep, Keep::shard);
}

TEST(RandomPlan, EveryCombinationHasTheSameSamples) {
  const std::string keys = uniform_key("p") + random_key("q.r", "distribution = \"normal\"\nmean = 5\ndeviation = 1");
  const Study alone = parse_study(random_head(keys), "study.toml");
  ASSERT_EQ(plan(alone).size(), 8u);
  const Study study = parse_study(random_head(keys) + "[[axes]]\nkey = \"x\"\nvalues = [1, 2]\n", "study.toml");
  const std::vector<PlannedRun> runs = plan(study);
  ASSERT_EQ(runs.size(), 16u);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(runs[i].sampled, runs[i + 8].sampled);
    EXPECT_EQ(runs[i].sampled, plan(alone)[i].sampled);
    EXPECT_EQ(runs[i].sample, i);
    EXPECT_EQ(runs[i].combination, 0u);
    EXPECT_EQ(runs[i + 8].combination, 1u);
  }
  const std::vector<std::string> all = overrides(study, runs[9]);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0], "x=2");
  EXPECT_EQ(all[1], fmt::format("p={}", runs[9].sampled[0]));
  EXPECT_TRUE(all[2].starts_with("q.r="));
}

TEST(RandomPlan, MoreSamplesAreTheSameStudyUnlessOthersAreDrawn) {
  const auto study = [](const std::string& method, int samples) {
    return parse_study(
        fmt::format("base = \"b\"\n[random]\nsamples = {}\nmethod = \"{}\"\n", samples, method) + uniform_key("p"),
        "study.toml");
  };
  EXPECT_EQ(study("sobol", 8).without_size, study("sobol", 9).without_size);
  EXPECT_NE(study("sobol", 8).normalized, study("sobol", 9).normalized);
  EXPECT_NE(study("latin_hypercube", 8).without_size, study("latin_hypercube", 9).without_size);
  const auto quantiles = [](const char* list) {
    return parse_study(random_head(fmt::format("quantiles = {}\n", list)) + uniform_key("p"), "study.toml").normalized;
  };
  EXPECT_EQ(quantiles("[0.5]"), quantiles("[0.1]"));
}

TEST(RandomPlan, AHundredThousandRuns) {
  const std::string text = "base = \"b\"\n[random]\nsamples = 50000\n" + uniform_key("p");
  const std::string axis = "[[axes]]\nkey = \"x\"\nvalues = [1, 2]\n";
  EXPECT_EQ(plan(parse_study(text + axis, "study.toml")).back().name, "run_100000");
  expect_random_mistake(text + axis + "[[axes]]\nkey = \"y\"\nvalues = [1, 2]\n",
                        {"s/study.toml:9:1: ", "4 ", "50000", "200000", "100000"});
}

TEST(RandomPlan, MemoryIsBounded) {
  std::string text = "base = \"b\"\n[random]\nsamples = 100000\n";
  for (int i = 0; i < 101; ++i) text += uniform_key("p" + std::to_string(i));
  expect_random_mistake(text, {"s/study.toml:2:1: random: ", "100000 runs", "101 random keys", "10000000"});
}

TEST(RandomMistakes, AtTheirPlaces) {
  expect_random_mistake(random_head(), {"s/study.toml:2:1: random: ", "[[random.keys]]"});
  expect_random_mistake(random_head() + random_key("a", "distribution = \"normal\"\nmean = 5"),
                        {"s/study.toml:6:16: random.keys[0].distribution: ", "\"normal\"", "'deviation'"});
  expect_random_mistake(
      random_head() + random_key("a", "distribution = \"lognormal\"\nmean = 5\nmedian = 5\nfactor = 2"),
      {"s/study.toml:7:8: random.keys[0].mean: ", "\"lognormal\"", "'median', 'factor'"});
  expect_random_mistake(random_head() + random_key("a", "distribution = \"lognormal\"\nmedian = -5\nfactor = 2"),
                        {"s/study.toml:7:10: random.keys[0].median: ", "-5", "> 0"});
  expect_random_mistake(random_head() + random_key("a", "distribution = \"uniform\"\nmin = 5\nmax = 2"),
                        {"s/study.toml:8:7: random.keys[0].max: ", "2", "min = 5"});
  expect_random_mistake(random_head() + random_key("a", "distribution = \"triangular\"\nmin = 1\nmode = 7\nmax = 2"),
                        {"s/study.toml:8:8: random.keys[0].mode: ", "7", "from 1 to 2"});
  expect_random_mistake(random_head() + random_key("a", "distribution = \"gauss\"\nmean = 1"),
                        {"s/study.toml:6:16: random.keys[0].distribution: ", "'gauss'", "normal"});
  expect_random_mistake(random_head() + random_key("a", ""),
                        {"s/study.toml:4:1: random.keys[0]: ", "'distribution'", "'fit'"});
  expect_random_mistake(
      random_head() + random_key("a", "distribution = \"table\"\nvalues = [1, 2]\ncumulative = [0.1, 1]"),
      {"s/study.toml:8:14: random.keys[0].cumulative: ", "0.1", "from 0 to 1"});
  expect_random_mistake(random_head("quantiles = [0.9, 0.1]\n") + uniform_key("a"),
                        {"s/study.toml:4:13: random.quantiles: ", "0.9, 0.1", "ascending"});
  expect_random_mistake(random_head() + uniform_key("mesh.size"),
                        {"s/study.toml:5:7: random.keys[0].key: ", "'mesh.size'", "mesh of its own", "[[axes]]"});
  expect_random_mistake(random_head() + uniform_key("a[0].b") + uniform_key("a.0.b"),
                        {"s/study.toml:10:7: random.keys[1].key: ", "'a.0.b'", "line 5"});
  // However it is spelt, and where one lies in the other.
  for (const char* other : {"a[00].b", "a . 0.b", "\\\"a\\\"[0].b", "a", "a[0]", "a[0].b.c"})
    expect_random_mistake(random_head() + uniform_key("a[0].b") + uniform_key(other),
                          {"s/study.toml:10:7: random.keys[1].key: ", "already distributed", "line 5"});
  expect_random_mistake(random_head() + uniform_key("a[0].b") + "[[axes]]\nkey = \"a\"\nvalues = [1]\n",
                        {"s/study.toml:5:7: random.keys[0].key: ", "'a[0].b'", "axis", "line 10"});
  expect_random_mistake("base = \"base.toml\"\n[random]\nsamples = 8\nseed = 9223372036854775807\n" + uniform_key("a"),
                        {"s/study.toml:4:8: random.seed: ", "at most 2147483647"});
  expect_random_mistake(random_head() + uniform_key("a") + "[[axes]]\nkey = \"a\"\nvalues = [1]\n",
                        {"s/study.toml:5:7: random.keys[0].key: ", "'a'", "axis", "line 10"});
  expect_random_mistake(random_head() + uniform_key("a") + "[[runs]]\nset = { a = 1 }\n",
                        {"s/study.toml:5:7: random.keys[0].key: ", "'a'", "[[runs]]", "line 10"});
}

TEST(RandomMistakes, OfCorrelations) {
  const std::string keys = uniform_key("a") + uniform_key("b") + uniform_key("c");  // up to line 18
  const auto pair = [](const char* a, const char* b, double value) {
    return fmt::format("[[random.correlations]]\nkeys = [\"{}\", \"{}\"]\nvalue = {}\n", a, b, value);
  };
  expect_random_mistake(random_head() + keys + pair("a", "bb", 0.5), {"s/study.toml:20:14: ", "'bb'", "a, b, c"});
  expect_random_mistake(random_head() + keys + pair("a", "a", 0.5), {"s/study.toml:19:1: ", "'a' twice"});
  expect_random_mistake(random_head() + keys + pair("a", "b", 0.5) + pair("b", "a", 0.1),
                        {"s/study.toml:22:1: ", "'b' and 'a'"});
  expect_random_mistake(random_head() + keys + pair("a", "b", 1.0), {"s/study.toml:21:9: ", "1", "(-1, 1)"});
  expect_random_mistake(random_head() + keys + pair("a", "b", 0.9) + pair("b", "c", 0.9) + pair("a", "c", -0.9),
                        {"s/study.toml:25:1: ", "positive definite"});
}

/// Random keys of a base configuration on disk.
class RandomRuns : public testing::Test {
 protected:
  void SetUp() override {
    directory_ /= std::string("creepcontact_random_") + testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(directory_);
    std::ofstream(directory_ / "base.toml") << minimal;
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  RandomLines mistakes_of(const std::string& keys) const {
    const Study study = parse_study(random_head(keys), directory_ / "study.toml");
    return complaints([&] { check_runs(study, plan(study), test_vocabulary()); });
  }

  std::filesystem::path directory_ = testing::TempDir();
};

TEST_F(RandomRuns, WhatDistributionsReachIsChecked) {
  const std::string modulus = "materials.steel.young_modulus";
  EXPECT_EQ(mistakes_of(random_key(modulus, "distribution = \"normal\"\nmean = 2e5\ndeviation = 1e4")), RandomLines{});
  expect_only(mistakes_of(random_key(modulus, "distribution = \"normal\"\nmean = 2e5\ndeviation = 1e5")),
              {"study.toml:5:7: random.keys[0].key: ", modulus, "normal, mean 200000", "2.3 %", "\"lognormal\"",
               "\"uniform\""});
  EXPECT_EQ(
      mistakes_of(random_key("materials.steel.poisson_ratio", "distribution = \"uniform\"\nmin = 0.2\nmax = 0.4")),
      RandomLines{});
  expect_only(
      mistakes_of(random_key("materials.steel.poisson_ratio", "distribution = \"uniform\"\nmin = 0.2\nmax = 0.6")),
      {"study.toml:5:7: random.keys[0].key: ", "poisson_ratio", "0.6", "uniform, 0.2 to 0.6"});
}

TEST_F(RandomRuns, AMisspeltKeyGetsNoAdviceOnTheDistribution) {
  const RandomLines lines =
      mistakes_of(uniform_key("materials.stell.young_modulus") + uniform_key("materials.steel.poisson_ratio"));
  ASSERT_FALSE(lines.empty());
  for (const std::string& line : lines) EXPECT_FALSE(creepcontact::test::says(line, {"reaches"})) << line;
}

TEST_F(RandomRuns, OnlyNumbersAreDistributed) {
  expect_only(mistakes_of(uniform_key("mesh_file") + uniform_key("bodies.block.material")),
              {"study.toml:10:7: random.keys[1].key: ", "'bodies.block.material'", "string", "number"});
}

TEST_F(RandomRuns, ConstantsOfAFitMustBeThoseOfTheBase) {
  std::ofstream(directory_ / "base.toml", std::ios::app)
      << "[[materials.steel.creep]]\nlaw = \"norton\"\nA = 2e-15\nn = 4\n";
  const auto write = [&](const std::string& a) {
    std::ofstream(directory_ / "scatter.toml")
        << "law = \"norton\"\nkeys = [\"A\", \"n\"]\nvalues = [" << a
        << ", 4.0]\nlogarithmic = [true, true]\ndeviations = [0.5, 0.1]\ncorrelation = [[1.0, -0.9], [-0.9, 1.0]]\n";
  };
  write("2e-15");
  const std::string key = random_key("materials.steel.creep[0]", "fit = \"scatter.toml\"");
  EXPECT_EQ(mistakes_of(key), RandomLines{});
  const Study study = parse_study(random_head(key), directory_ / "study.toml");
  ASSERT_EQ(study.random->keys.size(), 2u);
  EXPECT_EQ(study.random->keys[1].key.name, "materials.steel.creep[0].n");
  EXPECT_DOUBLE_EQ(std::get<statistics::Lognormal>(study.random->keys[0].distribution).factor, std::exp(0.5));
  EXPECT_EQ(study.random->correlations.front().value, -0.9);
  // The study in its output directory needs the file no more.
  const Study stored = parse_study(study.normalized, "elsewhere/study.toml");
  EXPECT_EQ(plan(stored).back().sampled, plan(study).back().sampled);
  write("3e-15");
  expect_only(mistakes_of(key), {"study.toml:4:1: random.keys[0]: ", "creep[0].A = 3e-15", "2e-15"});
  std::ofstream(directory_ / "scatter.toml") << "law = \"norton\"\n";
  expect_only(complaints([&] { parse_study(random_head(key), directory_ / "study.toml"); }),
              {"study.toml:6:7: random.keys[0].fit: ", "scatter.toml", "creepcontact fit"});
}

}  // namespace
}  // namespace creepcontact::config
