#include "creepcontact/base/files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"

namespace creepcontact {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  Files() : directory_(fs::path(testing::TempDir()) / fmt::format("creepcontact_files_test_{}", ::getpid())) {
    fs::remove_all(directory_);
    fs::create_directory(directory_);
    std::ofstream(directory_ / "file") << "text";
    fs::create_symlink("circle", directory_ / "circle");
  }
  ~Files() override { fs::remove_all(directory_); }
  fs::path directory_;
};

TEST_F(Files, AreThereOrNot) {
  EXPECT_TRUE(path_exists(directory_ / "file"));
  EXPECT_FALSE(path_exists(directory_ / "none"));
  EXPECT_FALSE(path_exists(directory_ / "file" / "below"));
  EXPECT_TRUE(path_is_directory(directory_));
  EXPECT_FALSE(path_is_directory(directory_ / "file"));
  EXPECT_FALSE(path_is_directory(directory_ / "none"));
}

TEST_F(Files, PathsThatLeadNowhereAreNamedWithTheReason) {
  for (const fs::path& path : {directory_ / "circle", directory_ / std::string(300, 'n')})
    for (const auto& question : {path_exists, path_is_directory}) try {
        question(path);
        ADD_FAILURE() << path;
      } catch (const ConfigError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with("'" + path.string() + "': ")) << message;
        EXPECT_TRUE(message.ends_with("Too many levels of symbolic links") || message.ends_with("File name too long"))
            << message;
      }
}

TEST_F(Files, WhyOneCannotBeRead) {
  EXPECT_EQ(why_unreadable(directory_ / "file"), "");
  EXPECT_EQ(why_unreadable(directory_ / "none"), "No such file or directory");
  EXPECT_EQ(why_unreadable(directory_ / "file" / "below"), "Not a directory");
  EXPECT_EQ(why_unreadable(directory_ / "circle"), "Too many levels of symbolic links");
  EXPECT_EQ(why_unreadable(directory_ / std::string(300, 'n')), "File name too long");
  EXPECT_TRUE(test::says(why_unreadable(directory_), {"directory", "file"}));
  EXPECT_TRUE(test::says(why_unreadable("/dev/zero"), {"device", "file"}));
}

TEST_F(Files, WhyNothingCanBeWritten) {
  EXPECT_EQ(why_unwritable(directory_), "");
  EXPECT_EQ(why_unwritable(directory_ / "none" / "below"), "") << "can be made";
  const std::string file = (directory_ / "file").string();
  EXPECT_TRUE(test::says(why_unwritable(file), {"'" + file + "'", "directory"}));
  EXPECT_TRUE(test::says(why_unwritable(directory_ / "file" / "below" / "it"), {"'" + file + "'", "directory"}));
}

TEST_F(Files, AreReadWholeUpToTheirBound) {
  std::ofstream(directory_ / "long") << std::string(200'000, 'x');
  EXPECT_EQ(read_file(directory_ / "long").bytes, std::string(200'000, 'x'));
  const FileBytes refused = read_file(directory_ / "long", 1 << 17);
  EXPECT_EQ(refused.bytes, "");
  EXPECT_TRUE(test::says(refused.failure, {"0.125 MB"}));
  EXPECT_EQ(read_file(directory_ / "none").failure, "No such file or directory");
}

TEST_F(Files, PipesAreReadToTheirEnd) {
  ASSERT_EQ(mkfifo((directory_ / "pipe").c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(directory_ / "pipe") << std::string(300'000, 'y'); });
  EXPECT_EQ(read_file(directory_ / "pipe").bytes, std::string(300'000, 'y'));
  writer.join();
}

}  // namespace
}  // namespace creepcontact
