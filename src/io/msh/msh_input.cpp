#include "msh_input.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "creepcontact/base/error.hpp"

namespace creepcontact::io {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

bool is_blank(char c) {
  return blanks.find(c) != std::string_view::npos;
}

/// A word of the file as a message can show it.
std::string printable(std::string_view word) {
  constexpr std::size_t shown = 20;
  std::string text(word.substr(0, shown));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return word.size() > shown ? text + "..." : text;
}

}  // namespace

void MshInput::skip_blanks() {
  while (!at_end() && is_blank(bytes_[position_])) ++position_;
}

std::string_view MshInput::line() {
  const std::size_t end = std::min(bytes_.find('\n', position_), bytes_.size());
  std::string_view text = bytes_.substr(position_, end - position_);
  position_ = std::min(end + 1, bytes_.size());
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

bool MshInput::take(std::string_view text) {
  if (!bytes_.substr(position_).starts_with(text)) return false;
  position_ += text.size();
  return true;
}

bool MshInput::skip_behind(std::string_view text) {
  const std::size_t found = bytes_.find(text, position_);
  if (found == std::string_view::npos) return false;
  position_ = found + text.size();
  return true;
}

void MshInput::begin_binary() {
  file_is_binary_ = binary_ = true;
  constexpr std::int32_t one = 1, swapped_one = 1 << 24;
  const std::int32_t mark = raw<std::int32_t>("the number 1 that gives the byte order");
  if (mark != one && mark != swapped_one)
    fail("the number that gives the byte order is {}, not 1: the file is damaged; write it again", mark);
  swapped_ = mark == swapped_one;
}

template <typename T>
T MshInput::raw(const char* what) {
  if (bytes_.size() - position_ < sizeof(T))
    fail("the file ends before {}; it is incomplete: write or copy it again", what);
  std::array<char, sizeof(T)> value;
  std::copy_n(bytes_.begin() + position_, sizeof(T), value.begin());
  if (swapped_) std::reverse(value.begin(), value.end());
  position_ += sizeof(T);
  T result;
  std::memcpy(&result, value.data(), sizeof(T));
  return result;
}

template <typename T>
T MshInput::parsed(const char* what) {
  skip_blanks();
  if (at_end()) fail("the file ends before {}; it is incomplete: write or copy it again", what);
  const char* begin = bytes_.data() + position_;
  const char* end = bytes_.data() + bytes_.size();
  T value{};
  const auto [after, failure] = std::from_chars(begin + (*begin == '+' && begin + 1 < end ? 1 : 0), end, value);
  if (failure != std::errc() || (after < end && !is_blank(*after))) fail_at_value(what);
  position_ += after - begin;
  return value;
}

int MshInput::integer(const char* what) {
  return binary_ ? raw<std::int32_t>(what) : parsed<int>(what);
}

int MshInput::non_negative(const char* what) {
  const int value = integer(what);
  if (value < 0) fail("{} is {}; it cannot be negative: the file is damaged, write it again", what, value);
  return value;
}

std::uint64_t MshInput::size(const char* what) {
  return binary_ ? raw<std::uint64_t>(what) : parsed<std::uint64_t>(what);
}

double MshInput::real(const char* what) {
  const double value = binary_ ? raw<double>(what) : parsed<double>(what);
  if (!std::isfinite(value)) fail("{} is {}, not a finite number; write the mesh again", what, value);
  return value;
}

void MshInput::skip_reals(std::uint64_t n, const char* what) {
  for (std::uint64_t i = 0; i < n; ++i) binary_ ? raw<double>(what) : parsed<double>(what);
}

void MshInput::expect_room(std::uint64_t n, const MshRecord& record, const char* what) const {
  // a number and a blank: at least two characters; the file may end behind the last number
  const std::uint64_t least = binary_ ? 4 * record.ints + 8 * record.wides : 2 * (record.ints + record.wides);
  const std::uint64_t left = bytes_.size() - position_ + 1;
  if (least > 0 && n > left / least) {
    fail("{} {} are announced, but only {} bytes follow: the file is incomplete or damaged; write or copy it again", n,
         what, left - 1);
  }
}

void MshInput::fail_with(const std::string& text) const {
  std::string position;
  if (file_is_binary_) {
    position = fmt::format("byte {}", position_);
  } else {
    const auto until = bytes_.begin() + static_cast<std::ptrdiff_t>(std::min(position_, bytes_.size()));
    position = fmt::format("line {}", 1 + std::count(bytes_.begin(), until, '\n'));
  }
  throw ModelError(fmt::format("{}, {}{}: {}", name_, position, section_.empty() ? "" : ", in $" + section_, text));
}

void MshInput::fail_at_value(const char* what) const {
  const std::string_view rest = bytes_.substr(position_);
  const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
  fail("expected {}, a number, but found '{}'; the file is damaged: write it again", what, printable(word));
}

}  // namespace creepcontact::io
