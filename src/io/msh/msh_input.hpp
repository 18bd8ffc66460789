#pragma once
/// The values in the bytes of a .msh file, ASCII or binary, one after the other.

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace creepcontact::io {

/// How many values of each width make up a record, to bound counts by the bytes that are left.
struct MshRecord {
  std::uint64_t ints = 0;   ///< 4 bytes each in a binary file
  std::uint64_t wides = 0;  ///< 8 bytes each: sizes and reals
};

class MshInput {
 public:
  MshInput(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  bool at_end() const { return position_ >= bytes_.size(); }
  void skip_blanks();
  /// The rest of the current line, without its end; the next value is behind it.
  std::string_view line();
  /// Steps over `text` if it comes next.
  bool take(std::string_view text);
  /// Steps behind the next `text`; false (and stays) if there is none.
  bool skip_behind(std::string_view text);

  /// Named in messages from here on.
  void enter(std::string section) { section_ = std::move(section); }
  /// Starts binary numbers; they begin with the number 1, which tells the order of their bytes.
  void begin_binary();
  /// false: numbers are ASCII wherever the file is binary too (names, counts of format 2.2).
  void use_binary(bool wanted) { binary_ = wanted && file_is_binary_; }
  bool file_is_binary() const { return file_is_binary_; }

  // Values. `what` is told where they are none. @throws ModelError
  int integer(const char* what);
  int non_negative(const char* what);
  std::uint64_t size(const char* what);
  double real(const char* what);  ///< finite
  void skip_reals(std::uint64_t n, const char* what);

  /// @throws ModelError unless n such records may follow in the bytes that are left
  void expect_room(std::uint64_t n, const MshRecord& record, const char* what) const;

  /// "model.msh, line 12, in $Nodes: ..."
  template <typename... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) const {
    fail_with(fmt::format(format, std::forward<Args>(args)...));
  }

 private:
  [[noreturn]] void fail_with(const std::string& text) const;
  [[noreturn]] void fail_at_value(const char* what) const;
  template <typename T>
  T raw(const char* what);
  template <typename T>
  T parsed(const char* what);

  std::string_view bytes_;
  std::string name_, section_;
  std::size_t position_ = 0;
  bool binary_ = false, file_is_binary_ = false, swapped_ = false;
};

}  // namespace creepcontact::io
