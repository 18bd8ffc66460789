#include "creepcontact/io/checkpoint/checkpoint.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "creepcontact/platform/replace_file.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

using test::message_of;
using test::says;

Checkpoint example() {
  Checkpoint checkpoint;
  checkpoint.fingerprint = "sha of the model";
  checkpoint.integrator = "beta_euler";
  checkpoint.time = 1.0 / 3;
  checkpoint.next_step = 0.1;
  for (int i = 0; i < 1000; ++i) checkpoint.state.push_back(i / 7.0);
  checkpoint.counters = {.steps = 12, .elastic_solves = std::numeric_limits<std::int64_t>::max()};
  checkpoint.arrays = {{"multipliers", {1.5, -2.5}}, {"empty", {}}};
  return checkpoint;
}

class CheckpointFile : public testing::Test {
 protected:
  // What reading says once the bytes of a good file went through `damage`.
  std::string reading(const std::function<void(std::string&)>& damage, std::string bytes) {
    damage(bytes);
    test::write_text(path_, bytes);
    return message_of<ConfigError>([&] { read_checkpoint(path_); });
  }
  test::TemporaryDirectory directory_;
  std::filesystem::path path_ = directory_ / "checkpoint.h5";
};

TEST_F(CheckpointFile, ReadsBackExactly) {
  const Checkpoint expected = example();
  write_checkpoint(path_, expected);
  const Checkpoint found = read_checkpoint(path_);
  EXPECT_EQ(found.fingerprint, expected.fingerprint);
  EXPECT_EQ(found.integrator, expected.integrator);
  EXPECT_EQ(found.time, expected.time);
  EXPECT_EQ(found.next_step, expected.next_step);
  EXPECT_EQ(found.state, expected.state);
  EXPECT_EQ(found.counters, expected.counters);
  EXPECT_EQ(found.arrays, expected.arrays);
  EXPECT_FALSE(std::filesystem::exists(platform::aside(path_)));
}

TEST_F(CheckpointFile, EmptyOneReadsBack) {
  write_checkpoint(path_, {});
  EXPECT_TRUE(read_checkpoint(path_).state.empty());
  EXPECT_TRUE(read_checkpoint(path_).fingerprint.empty());
}

TEST_F(CheckpointFile, ReplacesTheOldOne) {
  write_checkpoint(path_, example());
  Checkpoint later = example();
  later.time = 2;
  write_checkpoint(path_, later);
  EXPECT_EQ(read_checkpoint(path_).time, 2);
}

// What an interruption while writing leaves: the old file, and something aside.
TEST_F(CheckpointFile, AHalfWrittenSuccessorDoesNoHarm) {
  write_checkpoint(path_, example());
  test::write_text(platform::aside(path_), "half");
  EXPECT_EQ(read_checkpoint(path_).counters.steps, 12);
  write_checkpoint(path_, example());
  EXPECT_EQ(read_checkpoint(path_).counters.steps, 12);
}

TEST_F(CheckpointFile, AnyChangedByteIsFound) {
  write_checkpoint(path_, example());
  const std::string good = test::read_text(path_);
  for (std::size_t i = 0; i < good.size(); i += i < 600 ? 1 : 97) {
    const std::string message =
        reading([&](std::string& bytes) { bytes[i] = static_cast<char>(bytes[i] ^ 0x10); }, good);
    EXPECT_TRUE(says(message, {path_.string(), "damaged"}) || says(message, {path_.string(), "not a checkpoint"}))
        << "byte " << i << ": " << message;
  }
}

TEST_F(CheckpointFile, CutShortOrExtendedIsFound) {
  write_checkpoint(path_, example());
  const std::string good = test::read_text(path_);
  for (std::size_t length : {std::size_t{40}, std::size_t{511}, std::size_t{512}, good.size() / 2, good.size() - 1}) {
    const std::string message = reading([&](std::string& bytes) { bytes.resize(length); }, good);
    EXPECT_TRUE(says(message, {path_.string(), "damaged"})) << length;
  }
  EXPECT_TRUE(says(reading([](std::string& bytes) { bytes += '\0'; }, good), {path_.string(), "damaged"}));
}

TEST_F(CheckpointFile, ForeignMissingAndUnwritableFilesAreNamed) {
  test::write_text(path_, "time,a\n");
  EXPECT_TRUE(says(message_of<ConfigError>([&] { read_checkpoint(path_); }), {path_.string(), "not a checkpoint"}));
  test::write_text(path_, "");
  EXPECT_TRUE(says(message_of<ConfigError>([&] { read_checkpoint(path_); }), {path_.string(), "not a checkpoint"}));
  EXPECT_TRUE(says(message_of<ConfigError>([&] { read_checkpoint(directory_ / "none.h5"); }),
                   {"none.h5'", "No such file or directory"}));
  EXPECT_TRUE(says(message_of<Error>([&] { write_checkpoint(directory_ / "none/checkpoint.h5", example()); }),
                   {"none/checkpoint.h5'"}));
}

TEST_F(CheckpointFile, OfAnotherVersionIsRefused) {
  write_checkpoint(path_, example());
  const std::string version = "creepcontact checkpoint 5\n", good = test::read_text(path_);
  ASSERT_TRUE(good.starts_with(version));
  for (const char other : {'4', '6'}) {
    const std::string message = reading([&](std::string& bytes) { bytes[version.size() - 2] = other; }, good);
    EXPECT_TRUE(says(message, {"--resume", "'" + path_.string() + "'", std::string("version ") + other, "version 5"}));
    EXPECT_EQ(message_of<ConfigError>([&] { read_last_checkpoint(path_); }), message);  // there is no previous one
  }
}

class TwoCheckpoints : public CheckpointFile {
 protected:
  void write(double time) {
    Checkpoint checkpoint = example();
    checkpoint.time = time;
    write_checkpoint(path_, checkpoint);
  }
  std::filesystem::path previous_ = directory_ / "checkpoint.previous.h5";
};

TEST_F(TwoCheckpoints, TheOneBeforeIsKept) {
  EXPECT_EQ(previous_checkpoint(path_), previous_);
  write(1);
  EXPECT_FALSE(std::filesystem::exists(previous_));
  write(2);
  write(3);
  EXPECT_EQ(read_checkpoint(path_).time, 3);
  EXPECT_EQ(read_checkpoint(previous_).time, 2);
  EXPECT_EQ(read_last_checkpoint(path_).time, 3);
  EXPECT_FALSE(std::filesystem::exists(platform::aside(previous_)));
}

TEST_F(TwoCheckpoints, ThePreviousOneTakesThePlaceOfADamagedOne) {
  write(1);
  write(2);
  test::write_text(path_, test::read_text(path_).substr(0, 700));
  EXPECT_EQ(read_last_checkpoint(path_).time, 1);
  EXPECT_FALSE(std::filesystem::exists(previous_));
  write(3);  // the damaged one must not become the previous one
  EXPECT_EQ(read_checkpoint(previous_).time, 1);
}

TEST_F(TwoCheckpoints, WhatIsWrongWithBothIsSaid) {
  const std::string none = message_of<ConfigError>([&] { read_last_checkpoint(path_); });
  EXPECT_TRUE(says(none, {"'" + path_.string() + "'", "--resume"}));
  write(1);
  write(2);
  test::write_text(path_, "");
  test::write_text(previous_, test::read_text(previous_) + "x");
  const std::string message = message_of<ConfigError>([&] { read_last_checkpoint(path_); });
  EXPECT_TRUE(says(message, {path_.string(), "not a checkpoint", previous_.string(), "damaged", "--resume"}));
}

TEST_F(TwoCheckpoints, AreRemovedWithWhatWasBegunBesideThem) {
  write(1);
  write(2);
  for (const auto& path : {path_, previous_}) test::write_text(platform::aside(path), "half");
  remove_checkpoints(path_);
  for (const auto& path : {path_, previous_, platform::aside(path_), platform::aside(previous_)})
    EXPECT_FALSE(std::filesystem::exists(path)) << path;
  remove_checkpoints(path_);
}

}  // namespace
}  // namespace creepcontact::io
