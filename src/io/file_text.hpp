#pragma once
/// Whole files as text: the readers parse text, files are read here.

#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "creepcontact/base/files.hpp"

namespace creepcontact::io {

/// @throws Failure  an Error, with the path and the system's reason
template <class Failure>
std::string file_text(const std::filesystem::path& path) {
  auto [text, failure] = read_file(path);
  if (!failure.empty()) throw Failure(fmt::format("{}: cannot be read: {}", path.string(), failure));
  return text;
}

}  // namespace creepcontact::io
