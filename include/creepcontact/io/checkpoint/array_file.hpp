#pragma once
/// HDF5 files of named arrays, sealed with a checksum as checkpoints are.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace creepcontact::io {

struct NamedArrays {
  std::map<std::string, std::vector<double>> numbers;
  std::map<std::string, std::vector<std::int64_t>> integers;
  std::map<std::string, std::string> texts;
};

/// Replaces the file at once. @throws Error if the disk cannot take it; an old file is then still there
void write_array_file(const std::filesystem::path& path, const NamedArrays& arrays);

/// @throws ConfigError saying why, if the file cannot be read, is damaged, or is not such a file
NamedArrays read_array_file(const std::filesystem::path& path);

}  // namespace creepcontact::io
