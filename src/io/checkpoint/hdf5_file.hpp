#pragma once
/// The few HDF5 operations that checkpoints and temperatures need, with handles that close themselves and failures as
/// exceptions.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hdf5_library.hpp"

namespace creepcontact::io {

class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  /// @throws Hdf5Error naming `action` if id is the library's sign of failure
  Hdf5Handle(hid_t id, Close close, const std::string& action) : id_(id), close_(close) {
    if (id < 0) throw Hdf5Error("cannot " + action);
  }
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor): it is one
  /// Closes now. @throws Hdf5Error if buffered data could not be written
  void finish(const std::string& action) {
    if (close_(std::exchange(id_, -1)) < 0) throw Hdf5Error("cannot " + action);
  }

 private:
  hid_t id_;
  Close close_;
};

/// Keeps the library from printing its error stack in this thread, from here on.
class Hdf5Silence {
 public:
  Hdf5Silence() { hdf5().H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }
};

/// A new file with `user_block` bytes in front that HDF5 leaves alone (a power of two from 512).
Hdf5Handle create_hdf5(const std::filesystem::path& path, hsize_t user_block);
Hdf5Handle open_hdf5(const std::filesystem::path& path);
Hdf5Handle create_group(hid_t parent, const std::string& name);
Hdf5Handle open_group(hid_t parent, const std::string& name);
/// Names of the members of a group, by name.
std::vector<std::string> member_names(hid_t group);

/// Sizes of a dataset, one a dimension.
std::vector<std::size_t> extents(hid_t parent, const std::string& name);

// One-dimensional arrays of double, 64-bit integer or character.
void write_array(hid_t parent, const std::string& name, std::span<const double> values);
void write_array(hid_t parent, const std::string& name, std::span<const std::int64_t> values);
void write_array(hid_t parent, const std::string& name, std::span<const char> values);
/// Reads an array of any rank, its entries row by row. @throws Hdf5Error also for more entries than a file of this size
/// can hold
template <typename T>
std::vector<T> read_array(hid_t parent, const std::string& name);
/// The first entry. @throws Hdf5Error also if there is none
template <typename T>
T read_number(hid_t parent, const std::string& name);

}  // namespace creepcontact::io
