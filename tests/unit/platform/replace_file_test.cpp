/// Files of results replace what had their names, and are not written through links.
#include "creepcontact/platform/replace_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/private_directory.hpp"

namespace creepcontact::platform {
namespace {

namespace fs = std::filesystem;

class ReplaceFile : public testing::Test {
 protected:
  static std::string text_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void SetUp() override { std::ofstream(victim_) << "precious"; }

  PrivateDirectory place_;
  fs::path file_ = place_.path() / "a.csv", victim_ = place_.path() / "victim";
};

TEST_F(ReplaceFile, FollowsNoLink) {
  fs::create_symlink(victim_, aside(file_));
  replace_file(file_, "new");
  EXPECT_EQ(text_of(file_), "new");
  EXPECT_FALSE(fs::is_symlink(file_));
  fs::remove(file_);
  fs::create_symlink(victim_, file_);
  replace_file(file_, "newer", Durable::when_synced);
  EXPECT_EQ(text_of(file_), "newer");
  EXPECT_FALSE(fs::is_symlink(file_));
  EXPECT_EQ(text_of(victim_), "precious");
}

TEST_F(ReplaceFile, WhatIsLeftAsideDoesNotHinder) {
  std::ofstream(aside(file_)) << "left of a full disk";
  replace_file(file_, "new");
  EXPECT_EQ(text_of(file_), "new");
  EXPECT_FALSE(fs::exists(aside(file_)));
}

TEST_F(ReplaceFile, ADeviceStaysOne) {
  if (!fs::is_character_file("/dev/null")) GTEST_SKIP() << "needs /dev/null";
  std::FILE* stream = create_stream("/dev/null");
  ASSERT_NE(stream, nullptr);
  std::fclose(stream);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(ReplaceFile, NothingIsLeftAsideOfWhatCannotBeWritten) {
  fs::create_directories(file_ / "inner");  // a directory that cannot be replaced
  EXPECT_THROW(replace_file(file_, "new"), Error);
  fs::create_directory(place_.path() / "b.csv.part");  // nor what is aside
  EXPECT_THROW(replace_file(place_.path() / "b.csv", "new"), Error);
  EXPECT_EQ(create_stream(place_.path() / "none/a"), nullptr);
}

TEST_F(ReplaceFile, StreamsAndEndsFollowNoLink) {
  fs::create_symlink(victim_, file_);
  EXPECT_EQ(reopen_stream(file_, true), nullptr);
  EXPECT_EQ(reopen_stream(file_, false), nullptr);
  EXPECT_FALSE(rewrite_end(file_, 0, "x"));
  std::FILE* stream = create_stream(file_);
  std::fputs("rows", stream);
  std::fclose(stream);
  EXPECT_EQ(text_of(file_), "rows");
  EXPECT_TRUE(rewrite_end(file_, 2, "am"));
  EXPECT_EQ(text_of(file_), "roam");
  EXPECT_EQ(text_of(victim_), "precious");
}

TEST_F(ReplaceFile, InnerDirectoriesAreNoLinks) {
  const fs::path inner = place_.path() / "fields";
  make_inner_directory(inner);
  make_inner_directory(inner);
  EXPECT_TRUE(fs::is_directory(inner));
  fs::create_directory_symlink(inner, place_.path() / "linked");
  EXPECT_THROW(make_inner_directory(place_.path() / "linked"), ConfigError);
  EXPECT_THROW(make_inner_directory(victim_), ConfigError);
}

TEST(PrivateDirectories, AreNewAndEndWithTheirContent) {
  fs::path path;
  {
    const PrivateDirectory one, other;
    EXPECT_NE(one.path(), other.path());
    EXPECT_TRUE(one.path().is_absolute());
    EXPECT_EQ(fs::status(one.path()).permissions(), fs::perms::owner_all);
    path = one.path();
    std::ofstream(path / "a") << "b";
  }
  EXPECT_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace creepcontact::platform
