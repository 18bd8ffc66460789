#include "creepcontact/io/temperatures/kept_arrays.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "creepcontact/base/checksum.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "support/says.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

using creepcontact::test::message_of;
using creepcontact::test::says;

void write(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

TEST(KeptArrays, AreReadAsTheyWereWritten) {
  const test::TemporaryDirectory directory;
  const std::filesystem::path path = directory.path() / "kept";
  const KeptArrays kept{"item\tvalue\n", {{1, 0.1, -1e300}, {}, {5}}};
  write_kept_arrays(path, {"older", {}});
  write_kept_arrays(path, kept);
  const KeptArrays read = read_kept_arrays(path);
  EXPECT_EQ(read.fingerprint, kept.fingerprint);
  EXPECT_EQ(read.arrays, kept.arrays);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory.path()), {}), 1) << "nothing is left aside";
}

TEST(KeptArrays, RefusesFilesThatAreNotWhole) {
  const test::TemporaryDirectory directory;
  const std::filesystem::path path = directory.path() / "kept";
  write_kept_arrays(path, {"fingerprint", {{1, 2}, {3}}});
  const std::string whole = read_file(path).bytes;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write(path, whole.substr(0, length));
    EXPECT_THROW(read_kept_arrays(path), ConfigError) << length;
  }
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x40);
    write(path, damaged);
    EXPECT_THROW(read_kept_arrays(path), ConfigError) << i;
  }
  write(path, "notes of somebody");
  EXPECT_THROW(read_kept_arrays(path), OtherFile);
  write(path, whole + "more");
  EXPECT_THROW(read_kept_arrays(path), ConfigError);
  EXPECT_THROW(read_kept_arrays(directory.path() / "nowhere"), ConfigError);
  write_kept_arrays(path, {"fingerprint", {{std::numeric_limits<double>::quiet_NaN()}}});
  EXPECT_TRUE(says(message_of<ConfigError>([&] { read_kept_arrays(path); }), {"not finite"}));
}

/// With the right checksum, as a stranger may write it.
TEST(KeptArrays, TakesNoMemoryForSizesThatTheFileDoesNotHave) {
  const test::TemporaryDirectory directory;
  const std::filesystem::path path = directory.path() / "kept";
  const std::string kind = "creepcontact arrays 1\n";
  const auto file = [&](const std::vector<std::uint64_t>& numbers) {
    Checksum sum;
    sum.add(numbers.data(), numbers.size());
    const std::uint64_t checksum = sum.value();
    std::string bytes = kind + std::string(reinterpret_cast<const char*>(&checksum), sizeof(checksum));
    bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(std::uint64_t));
    return bytes;
  };
  constexpr std::uint64_t huge = std::uint64_t{1} << 61;
  for (const auto& numbers : std::vector<std::vector<std::uint64_t>>{{huge}, {0, huge}, {0, 1, huge}, {0, 1, 2, 0}}) {
    write(path, file(numbers));
    EXPECT_TRUE(says(message_of<ConfigError>([&] { read_kept_arrays(path); }), {"truncated"}));
  }
}

}  // namespace
}  // namespace creepcontact::io
