#pragma once
/// Binary arrays of VTK's XML files, as text or as bytes, compressed or not: what vtk_encoding.hpp writes, and more.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace creepcontact::io {

/// How a file holds its arrays.
struct VtkFormat {
  bool is_base64 = false;         ///< else raw bytes
  bool is_compressed = false;     ///< by zlib
  bool has_long_headers = false;  ///< UInt64 instead of UInt32
  bool is_big_endian = false;
};

/// The bytes of one array at the beginning of `source`.
/// @param n_bytes  that it must have @throws std::runtime_error if it has another number, is cut short or damaged.
/// Memory: proportional to `source`, whatever it claims.
/// Source: "VTK File Formats", Kitware, section on XML formats.
std::vector<std::byte> vtk_decode(std::string_view source, std::size_t n_bytes, const VtkFormat& format);

/// Size of a number of the type "Float64", "Int32", ...; nullopt: unknown
std::optional<std::size_t> vtk_type_size(std::string_view type);

/// The numbers of an array. @param bytes  a multiple of the size of `type`, which is known
std::vector<double> vtk_numbers(std::vector<std::byte> bytes, std::string_view type, bool is_big_endian);

}  // namespace creepcontact::io
