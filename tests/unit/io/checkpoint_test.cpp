#include "creepcontact/io/checkpoint.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "creepcontact/io/replace_file.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

using test::contains;
using test::message_of;

Checkpoint example() {
  Checkpoint checkpoint;
  checkpoint.fingerprint = "sha of the model";
  checkpoint.time = 1.0 / 3;
  checkpoint.next_step = 0.1;
  for (int i = 0; i < 1000; ++i) checkpoint.state.push_back(i / 7.0);
  checkpoint.counters = {{"steps", 12}, {"elastic solves", std::numeric_limits<std::int64_t>::max()}};
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
  EXPECT_EQ(found.time, expected.time);
  EXPECT_EQ(found.next_step, expected.next_step);
  EXPECT_EQ(found.state, expected.state);
  EXPECT_EQ(found.counters, expected.counters);
  EXPECT_EQ(found.arrays, expected.arrays);
  EXPECT_FALSE(std::filesystem::exists(aside(path_)));
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
  test::write_text(aside(path_), "half");
  EXPECT_EQ(read_checkpoint(path_).counters.at("steps"), 12);
  write_checkpoint(path_, example());
  EXPECT_EQ(read_checkpoint(path_).counters.at("steps"), 12);
}

TEST_F(CheckpointFile, AnyChangedByteIsFound) {
  write_checkpoint(path_, example());
  const std::string good = test::read_text(path_);
  for (std::size_t i = 0; i < good.size(); i += i < 600 ? 1 : 97) {
    const std::string message =
        reading([&](std::string& bytes) { bytes[i] = static_cast<char>(bytes[i] ^ 0x10); }, good);
    EXPECT_TRUE(contains(message, "damaged") || contains(message, "is no checkpoint"))
        << "byte " << i << ": " << message;
  }
}

TEST_F(CheckpointFile, CutShortOrExtendedIsFound) {
  write_checkpoint(path_, example());
  const std::string good = test::read_text(path_);
  for (std::size_t length : {std::size_t{40}, std::size_t{511}, std::size_t{512}, good.size() / 2, good.size() - 1}) {
    const std::string message = reading([&](std::string& bytes) { bytes.resize(length); }, good);
    EXPECT_TRUE(contains(message, "cut short or damaged")) << length;
  }
  EXPECT_TRUE(contains(reading([](std::string& bytes) { bytes += '\0'; }, good), "cut short or damaged"));
}

TEST_F(CheckpointFile, ForeignMissingAndUnwritableFilesAreNamed) {
  test::write_text(path_, "time,a\n");
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { read_checkpoint(path_); }), "is no checkpoint"));
  test::write_text(path_, "");
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { read_checkpoint(path_); }), "is no checkpoint"));
  EXPECT_TRUE(
      contains(message_of<ConfigError>([&] { read_checkpoint(directory_ / "none.h5"); }), "No such file or directory"));
  EXPECT_TRUE(contains(message_of<Error>([&] { write_checkpoint(directory_ / "none/checkpoint.h5", example()); }),
                       "cannot write the checkpoint"));
}

}  // namespace
}  // namespace creepcontact::io
