/// Checkpoints: any bytes, and HDF5 files of any content behind a checksum that is right.

#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "creepcontact/io/checkpoint/checkpoint.hpp"
#include "fuzz_target.hpp"
#include "io/checkpoint/checkpoint_seal.hpp"

namespace creepcontact {
namespace {

/// Hands out the bytes of an input one after the other, zeros after the last.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}
  bool empty() const { return next_ == end_; }
  std::uint8_t byte() { return empty() ? std::uint8_t{0} : *next_++; }
  std::uint8_t below(std::size_t n) { return static_cast<std::uint8_t>(byte() % n); }

 private:
  const std::uint8_t *next_, *end_;
};

/// An id that is closed at the end, whether or not the library has made it.
class Id {
 public:
  Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Id() {
    if (id_ >= 0) close_(id_);
  }
  Id(const Id&) = delete;
  Id& operator=(const Id&) = delete;
  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor): it is one

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

constexpr std::array names{"fingerprint", "integrator", "time",           "next_step",        "state",
                           "counters",    "arrays",     "counters/steps", "arrays/contact.a", "arrays/other",
                           "arrays/time"};

/// A dataset of any type and extents, written or not.
void add_dataset(hid_t file, Bytes& bytes) {
  const char* const name = names[bytes.below(names.size())];
  const std::array types{H5T_NATIVE_DOUBLE, H5T_NATIVE_INT64, H5T_NATIVE_CHAR, H5T_C_S1,
                         H5T_NATIVE_FLOAT,  H5T_NATIVE_UINT8, H5T_NATIVE_INT64};
  const hid_t type = types[bytes.below(types.size())];
  std::vector<hsize_t> sizes(bytes.below(4));
  double entries = 1;
  for (hsize_t& size : sizes) {
    const std::uint8_t exponent = bytes.below(62);
    size = exponent < 8 ? exponent : hsize_t{1} << exponent;
    entries *= static_cast<double>(size);
  }
  const Id space(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose);
  const Id set(H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  constexpr double max_entries = 512;
  if (set < 0 || entries > max_entries || bytes.below(4) == 0) return;
  std::vector<char> values(static_cast<std::size_t>(entries) * sizeof(double));
  for (char& value : values) value = static_cast<char>(bytes.byte());
  H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
}

/// @returns false if the library could not write the file
bool write_recipe(const std::filesystem::path& path, Bytes& bytes) {
  const Id properties(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_userblock(properties, io::seal_size);
  const Id file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, properties, H5P_DEFAULT), H5Fclose);
  if (file < 0) return false;
  for (int i = 0; i < 16 && !bytes.empty(); ++i) {
    const std::uint8_t action = bytes.below(8);
    if (action == 0)
      Id(H5Gcreate2(file, names[bytes.below(names.size())], H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    else if (action == 1)
      H5Lcreate_soft(names[bytes.below(names.size())], file, names[bytes.below(names.size())], H5P_DEFAULT,
                     H5P_DEFAULT);
    else
      add_dataset(file, bytes);
  }
  return true;
}

std::filesystem::path scratch_file() {
  return std::filesystem::temp_directory_path() / ("creepcontact_fuzz_" + std::to_string(::getpid()) + ".h5");
}

}  // namespace
}  // namespace creepcontact

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const std::filesystem::path path = scratch_file();
  constexpr std::string_view raw = "raw:";
  const std::string_view text = fuzz::text_of(data, size);
  Bytes bytes(data, size);
  if (text.starts_with(raw))
    std::ofstream(path, std::ios::binary) << text.substr(raw.size());
  else if (write_recipe(path, bytes))
    io::write_seal(path);
  fuzz::may_refuse([&] { io::read_checkpoint(path); });
  std::filesystem::remove(path);
  return 0;
}
