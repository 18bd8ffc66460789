#pragma once
/// The user block of a checkpoint: length and checksum of the HDF5 part behind it.

#include <cstddef>
#include <filesystem>

#include "creepcontact/base/error.hpp"

namespace creepcontact::io {

/// A checkpoint that another version of the program has written.
class OtherFormat : public ConfigError {
 public:
  using ConfigError::ConfigError;
};

constexpr std::size_t seal_size = 512;  // the smallest user block of HDF5

/// Writes the seal of a file whose first seal_size bytes are free for it. @throws Error if the disk does not take it
void write_seal(const std::filesystem::path& path);

/// Compares the whole file with its seal, before HDF5 sees it: the library may crash on damaged structures.
/// @throws OtherFormat for a checkpoint of another format; ConfigError if the file cannot be read, is not a checkpoint,
/// or differs from its seal
void check_seal(const std::filesystem::path& path);

}  // namespace creepcontact::io
