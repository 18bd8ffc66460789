#pragma once
/// What every fuzz target is made of. A target hands any bytes to a reader, which must take them or refuse them with an
/// error of the program: every other exception, crash, hang or waste of memory is a finding.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "creepcontact/base/error.hpp"

/// Called by libFuzzer, and by replay.cpp with the files of the corpus.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace creepcontact::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the process, so that the input is kept, unless `holds`.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

/// @param action  may end with an error of the program that says something
template <class Action>
void may_refuse(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    require(error.what()[0] != '\0', "an error says what is wrong");
  }
}

/// The parts of a text between separators; always `n` of them, the last ones may be empty.
inline std::vector<std::string_view> parts_of(std::string_view text, std::string_view separator, std::size_t n) {
  std::vector<std::string_view> parts;
  while (parts.size() + 1 < n) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + separator.size());
  }
  parts.push_back(text);
  return parts;
}

}  // namespace creepcontact::fuzz
