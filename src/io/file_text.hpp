#pragma once
/// Whole files as text: the readers parse text, files are read here.

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include "creepcontact/base/files.hpp"

namespace creepcontact::io {

/// @throws Failure  an Error, with the path and the system's reason
template <class Failure>
std::string file_text(const std::filesystem::path& path) {
  if (const std::string reason = why_unreadable(path); !reason.empty())
    throw Failure(fmt::format("{}: cannot be read: {}", path.string(), reason));
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw Failure(fmt::format("{}: cannot be read: {}", path.string(), std::generic_category().message(errno)));
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace creepcontact::io
