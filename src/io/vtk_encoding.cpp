#include "vtk_encoding.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace creepcontact::io {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 18;  // bytes

std::string base64(std::span<const std::byte> bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  std::size_t out = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 3, out += 4) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < n ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k <= n; ++k) text[out + k] = digits[group >> (18 - 6 * k) & 63];
  }
  return text;
}

void append_compressed(std::span<const std::byte> block, std::vector<std::byte>& data) {
  uLongf length = ::compressBound(block.size());
  const std::size_t begin = data.size();
  data.resize(begin + length);
  // The fastest level: the last bits of stresses are noise, higher levels gain little on them.
  if (::compress2(reinterpret_cast<Bytef*>(data.data() + begin), &length, reinterpret_cast<const Bytef*>(block.data()),
                  block.size(), Z_BEST_SPEED) != Z_OK)
    throw std::runtime_error("zlib could not compress a field");
  data.resize(begin + length);
}

}  // namespace

std::string vtk_encode(std::span<const std::byte> bytes) {
  const std::size_t n_blocks = (bytes.size() + block_size - 1) / block_size;
  std::vector<std::uint64_t> header{n_blocks, block_size, bytes.size() % block_size};
  std::vector<std::byte> data;
  for (std::size_t b = 0; b < n_blocks; ++b) {
    const std::size_t begin = data.size();
    append_compressed(bytes.subspan(b * block_size, std::min(block_size, bytes.size() - b * block_size)), data);
    header.push_back(data.size() - begin);
  }
  return base64(std::as_bytes(std::span(header))) + base64(data);
}

}  // namespace creepcontact::io
