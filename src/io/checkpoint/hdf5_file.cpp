#include "hdf5_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace creepcontact::io {
namespace {

hid_t native(double) {
  return hdf5().native_double;
}
hid_t native(std::int64_t) {
  return hdf5().native_int64;
}
hid_t native(char) {
  return hdf5().native_char;
}

/// A damaged file may claim any number of entries; they must not be asked of the memory.
bool can_hold(hid_t file, hssize_t entries, std::size_t entry_size) {
  constexpr double max_compression = 1032;  // of deflate, the best of the usual filters
  hsize_t size = 0;
  return hdf5().H5Fget_filesize(file, &size) >= 0 &&
         static_cast<double>(entries) * static_cast<double>(entry_size) <= max_compression * static_cast<double>(size);
}

template <typename T>
void write_values(hid_t parent, const std::string& name, std::span<const T> values) {
  const std::string action = "write '" + name + "'";
  const hsize_t size = values.size();
  const Hdf5Handle space(hdf5().H5Screate_simple(1, &size, nullptr), hdf5().H5Sclose, action);
  Hdf5Handle set(hdf5().H5Dcreate2(parent, name.c_str(), native(T{}), space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                 hdf5().H5Dclose, action);
  if (!values.empty() && hdf5().H5Dwrite(set, native(T{}), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    throw Hdf5Error("cannot " + action);
  set.finish(action);
}

}  // namespace

Hdf5Handle create_hdf5(const std::filesystem::path& path, hsize_t user_block) {
  const Hdf5Handle properties(hdf5().H5Pcreate(hdf5().file_create_class), hdf5().H5Pclose, "create the file");
  hdf5().H5Pset_userblock(properties, user_block);
  // A link is removed, not followed.
  if (::unlink(path.c_str()) != 0 && errno != ENOENT)
    throw Hdf5Error(fmt::format("cannot replace '{}': {}", path.string(), std::strerror(errno)));
  return {hdf5().H5Fcreate(path.c_str(), H5F_ACC_EXCL, properties, H5P_DEFAULT), hdf5().H5Fclose, "create the file"};
}

Hdf5Handle open_hdf5(const std::filesystem::path& path) {
  return {hdf5().H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), hdf5().H5Fclose, "open the file"};
}

Hdf5Handle create_group(hid_t parent, const std::string& name) {
  return {hdf5().H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), hdf5().H5Gclose,
          "write '" + name + "'"};
}

Hdf5Handle open_group(hid_t parent, const std::string& name) {
  return {hdf5().H5Gopen2(parent, name.c_str(), H5P_DEFAULT), hdf5().H5Gclose, "read '" + name + "'"};
}

std::vector<std::string> member_names(hid_t group) {
  H5G_info_t info{};
  if (hdf5().H5Gget_info(group, &info) < 0) throw Hdf5Error("cannot list a group");
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto get = [&](char* text, std::size_t size) {
      const ssize_t length =
          hdf5().H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, text, size, H5P_DEFAULT);
      if (length < 0) throw Hdf5Error("cannot list a group");
      return length;
    };
    std::string name(get(nullptr, 0), '\0');
    get(name.data(), name.size() + 1);
    names.push_back(std::move(name));
  }
  return names;
}

std::vector<std::size_t> extents(hid_t parent, const std::string& name) {
  const std::string action = "read '" + name + "'";
  const Hdf5Handle set(hdf5().H5Dopen2(parent, name.c_str(), H5P_DEFAULT), hdf5().H5Dclose, action);
  const Hdf5Handle space(hdf5().H5Dget_space(set), hdf5().H5Sclose, action);
  const int rank = hdf5().H5Sget_simple_extent_ndims(space);
  if (rank < 0) throw Hdf5Error("cannot " + action);
  std::vector<hsize_t> sizes(rank);
  hdf5().H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
  return {sizes.begin(), sizes.end()};
}

void write_array(hid_t parent, const std::string& name, std::span<const double> values) {
  write_values(parent, name, values);
}
void write_array(hid_t parent, const std::string& name, std::span<const std::int64_t> values) {
  write_values(parent, name, values);
}
void write_array(hid_t parent, const std::string& name, std::span<const char> values) {
  write_values(parent, name, values);
}

template <typename T>
std::vector<T> read_array(hid_t parent, const std::string& name) {
  const std::string action = "read '" + name + "'";
  const Hdf5Handle set(hdf5().H5Dopen2(parent, name.c_str(), H5P_DEFAULT), hdf5().H5Dclose, action);
  const Hdf5Handle space(hdf5().H5Dget_space(set), hdf5().H5Sclose, action);
  const hssize_t size = hdf5().H5Sget_simple_extent_npoints(space);
  if (size < 0) throw Hdf5Error("cannot " + action);
  const Hdf5Handle file(hdf5().H5Iget_file_id(set), hdf5().H5Fclose, action);
  if (!can_hold(file, size, sizeof(T)))
    throw Hdf5Error(fmt::format("'{}' claims {} entries, more than the file can hold", name, size));
  std::vector<T> values(size);
  if (!values.empty() && hdf5().H5Dread(set, native(T{}), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    throw Hdf5Error("cannot " + action);
  return values;
}
template std::vector<double> read_array(hid_t, const std::string&);
template std::vector<std::int64_t> read_array(hid_t, const std::string&);
template std::vector<char> read_array(hid_t, const std::string&);

template <typename T>
T read_number(hid_t parent, const std::string& name) {
  const std::vector<T> values = read_array<T>(parent, name);
  if (values.empty()) throw Hdf5Error("'" + name + "' is empty");
  return values.front();
}
template double read_number(hid_t, const std::string&);
template std::int64_t read_number(hid_t, const std::string&);

}  // namespace creepcontact::io
