#include "creepcontact/base/checksum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string_view>
#include <vector>

namespace creepcontact {
namespace {

std::uint64_t checksum(std::string_view text) {
  Checksum sum;
  sum.add(text.data(), text.size());
  return sum.value();
}

// The values are kept in files.
TEST(Checksum, IsThatOfXxHash) {
  EXPECT_EQ(checksum(""), 0x2d06800538d394c2u);
  EXPECT_EQ(checksum("abc"), 0x78af5f94892f3950u);
}

TEST(Checksum, DoesNotDependOnHowDataAreCut) {
  std::mt19937 generator(3);
  std::vector<double> data(5000);
  for (double& value : data) value = static_cast<double>(generator());
  Checksum whole, parts;
  whole.add(data.data(), data.size());
  for (std::size_t begin = 0, n = 0; begin < data.size(); begin += n) {
    n = std::min<std::size_t>(1 + generator() % 90, data.size() - begin);
    parts.add(data.data() + begin, n);
  }
  EXPECT_EQ(parts.value(), whole.value());
}

TEST(Checksum, SeesEveryBitAndTheLength) {
  std::array<unsigned char, 300> data{};
  const auto sum_of = [&](std::size_t n) {
    Checksum sum;
    sum.add(data.data(), n);
    return sum.value();
  };
  const std::uint64_t zeros = sum_of(data.size());
  EXPECT_NE(sum_of(data.size() - 1), zeros);
  for (std::size_t bit = 0; bit < 8 * data.size(); ++bit) {
    data[bit / 8] ^= 1U << bit % 8;
    EXPECT_NE(sum_of(data.size()), zeros) << bit;
    data[bit / 8] = 0;
  }
}

}  // namespace
}  // namespace creepcontact
