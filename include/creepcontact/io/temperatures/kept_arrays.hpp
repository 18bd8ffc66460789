#pragma once
/// Arrays of numbers that a run keeps for others, with a text that tells for which they are good.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/base/error.hpp"

namespace creepcontact::io {

/// A file that this program has not written: it is not to be replaced.
class OtherFile : public ConfigError {
 public:
  using ConfigError::ConfigError;
};

struct KeptArrays {
  std::string fingerprint;
  std::vector<std::vector<double>> arrays;
};

/// Replaces the file at once; several processes may do so at the same time. With a checksum (XXH3).
/// @throws Error if the disk cannot take it; an old file is then still there
void write_kept_arrays(const std::filesystem::path& path, const KeptArrays& kept);

/// @throws OtherFile; ConfigError saying why, if the file cannot be read, is of another version, truncated or damaged,
/// or has numbers that are not finite. Sizes are compared with that of the file before memory is taken.
KeptArrays read_kept_arrays(const std::filesystem::path& path);

}  // namespace creepcontact::io
