#include "vtk_decoding.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <stdexcept>

namespace creepcontact::io {
namespace {

constexpr std::size_t largest_ratio = 1040;  // of zlib

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what);
}

/// Hands out the bytes in order.
class Bytes {
 public:
  Bytes(std::string_view source, bool is_base64) : rest_(source), is_base64_(is_base64) {}

  std::vector<std::byte> read(std::size_t n) {
    if (n > rest_.size() + pending_.size()) fail("the data are cut short");
    std::vector<std::byte> result;
    result.reserve(n);
    if (!is_base64_) {
      const auto bytes = std::as_bytes(std::span(rest_.data(), n));
      result.assign(bytes.begin(), bytes.end());
      rest_.remove_prefix(n);
      return result;
    }
    while (result.size() < n) {
      if (pending_.empty()) decode_group();
      result.push_back(pending_.front());
      pending_.erase(pending_.begin());
    }
    return result;
  }

 private:
  static unsigned digit(char c) {
    if (c >= 'A' && c <= 'Z') return static_cast<unsigned>(c - 'A');
    if (c >= 'a' && c <= 'z') return static_cast<unsigned>(c - 'a') + 26;
    if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0') + 52;
    if (c == '+') return 62;
    if (c == '/') return 63;
    fail(fmt::format("'{}' is not a character of base64", c));
  }

  /// Four characters; those with '=' end a part, after which another one may follow.
  void decode_group() {
    const std::size_t begin = rest_.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos || rest_.size() - begin < 4) fail("the data are cut short");
    const std::string_view group = rest_.substr(begin, 4);
    rest_.remove_prefix(begin + 4);
    const std::size_t n_digits = group.ends_with("==") ? 2 : group.ends_with('=') ? 3 : 4;
    unsigned bits = 0;
    for (std::size_t i = 0; i < 4; ++i) bits = bits << 6U | (i < n_digits ? digit(group[i]) : 0U);
    for (std::size_t i = 0; i + 1 < n_digits; ++i)
      pending_.push_back(static_cast<std::byte>(bits >> (16U - 8U * static_cast<unsigned>(i)) & 0xFFU));
  }

  std::string_view rest_;
  bool is_base64_;
  std::vector<std::byte> pending_;  // at most three
};

template <class Number>
Number number(const std::byte* bytes, bool is_big_endian) {
  std::array<std::byte, sizeof(Number)> copy{};
  std::memcpy(copy.data(), bytes, sizeof(Number));
  if (is_big_endian != (std::endian::native == std::endian::big)) std::ranges::reverse(copy);
  return std::bit_cast<Number>(copy);
}

std::vector<std::size_t> header(Bytes& source, std::size_t n, const VtkFormat& format) {
  const std::size_t size = format.has_long_headers ? 8 : 4;
  if (n > (std::size_t{1} << 40)) fail("the data are cut short");
  const std::vector<std::byte> bytes = source.read(n * size);
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < n; ++i)
    numbers.push_back(format.has_long_headers ? number<std::uint64_t>(&bytes[i * size], format.is_big_endian)
                                              : number<std::uint32_t>(&bytes[i * size], format.is_big_endian));
  return numbers;
}

void require_size(std::size_t found, std::size_t wanted) {
  if (found != wanted) fail(fmt::format("{} bytes instead of {}", found, wanted));
}

}  // namespace

std::vector<std::byte> vtk_decode(std::string_view source, std::size_t n_bytes, const VtkFormat& format) {
  Bytes bytes(source, format.is_base64);
  if (!format.is_compressed) {
    require_size(header(bytes, 1, format)[0], n_bytes);
    return bytes.read(n_bytes);
  }
  const std::vector<std::size_t> sizes = header(bytes, 3, format);
  const std::size_t n_blocks = sizes[0], block = sizes[1], last = sizes[2];
  if (n_bytes / largest_ratio > source.size()) fail("the data are cut short");
  if (n_blocks > source.size()) fail("the data are cut short");
  const std::vector<std::size_t> compressed = header(bytes, n_blocks, format);
  const std::size_t n_whole = last == 0 ? n_blocks : n_blocks - std::min<std::size_t>(n_blocks, 1);
  if (n_whole > 0 && block > n_bytes / n_whole) fail("the sizes of its blocks are wrong");
  require_size(n_whole * block + (n_blocks > 0 ? last : 0), n_bytes);
  std::vector<std::byte> result(n_bytes);
  std::size_t at = 0;
  for (std::size_t b = 0; b < n_blocks; ++b) {
    const std::vector<std::byte> data = bytes.read(compressed[b]);
    const std::size_t size = b < n_whole ? block : last;
    uLongf length = size;
    if (::uncompress(reinterpret_cast<Bytef*>(result.data() + at), &length, reinterpret_cast<const Bytef*>(data.data()),
                     data.size()) != Z_OK ||
        length != size)
      fail("the compressed data are damaged");
    at += size;
  }
  return result;
}

std::optional<std::size_t> vtk_type_size(std::string_view type) {
  if (type == "Int8" || type == "UInt8") return 1;
  if (type == "Int16" || type == "UInt16") return 2;
  if (type == "Int32" || type == "UInt32" || type == "Float32") return 4;
  if (type == "Int64" || type == "UInt64" || type == "Float64") return 8;
  return std::nullopt;
}

std::vector<double> vtk_numbers(std::vector<std::byte> bytes, std::string_view type, bool is_big_endian) {
  const std::size_t size = vtk_type_size(type).value();
  std::vector<double> result;
  result.reserve(bytes.size() / size);
  const auto convert = [&]<class Number>(Number /*of this type*/) {
    for (std::size_t i = 0; i < bytes.size(); i += size)
      result.push_back(static_cast<double>(number<Number>(&bytes[i], is_big_endian)));
  };
  if (type == "Float64") convert(double{});
  if (type == "Float32") convert(float{});
  if (type == "Int8") convert(std::int8_t{});
  if (type == "UInt8") convert(std::uint8_t{});
  if (type == "Int16") convert(std::int16_t{});
  if (type == "UInt16") convert(std::uint16_t{});
  if (type == "Int32") convert(std::int32_t{});
  if (type == "UInt32") convert(std::uint32_t{});
  if (type == "Int64") convert(std::int64_t{});
  if (type == "UInt64") convert(std::uint64_t{});
  return result;
}

}  // namespace creepcontact::io
