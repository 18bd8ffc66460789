#include "vtk_encoding.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

namespace creepcontact::io {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 18;  // bytes

constexpr std::size_t sample_size = std::size_t{1} << 12;  // bytes
constexpr double hardly_smaller = 0.7;                     // compressed over raw size

/// The fastest level: the last bits of stresses are noise, higher levels gain little on them. What hardly shrinks, to
/// judge by a sample from its middle, is stored as it is, which takes a tenth of the time.
int level_for(std::span<const std::byte> block) {
  if (block.size() <= 8 * sample_size) return Z_BEST_SPEED;  // the sample would cost more than it saves
  std::array<Bytef, 2 * sample_size> compressed;
  uLongf length = compressed.size();
  const std::byte* const middle = block.data() + (block.size() - sample_size) / 2;
  ::compress2(compressed.data(), &length, reinterpret_cast<const Bytef*>(middle), sample_size, Z_BEST_SPEED);
  return static_cast<double>(length) > hardly_smaller * sample_size ? Z_NO_COMPRESSION : Z_BEST_SPEED;
}

/// @returns the compressed size
std::uint64_t append_compressed(std::span<const std::byte> block, std::string& data) {
  uLongf length = ::compressBound(block.size());
  const std::size_t begin = data.size();
  data.resize(begin + length);
  if (::compress2(reinterpret_cast<Bytef*>(data.data() + begin), &length, reinterpret_cast<const Bytef*>(block.data()),
                  block.size(), level_for(block)) != Z_OK)
    throw std::bad_alloc();  // zlib knows no other failure here
  data.resize(begin + length);
  return length;
}

}  // namespace

std::string vtk_encode(std::span<const std::byte> bytes) {
  const std::size_t n_blocks = (bytes.size() + block_size - 1) / block_size;
  std::vector<std::uint64_t> header{n_blocks, block_size, bytes.size() % block_size};
  const std::size_t header_size = (header.size() + n_blocks) * sizeof(std::uint64_t);
  std::string data(header_size, '\0');
  for (std::size_t b = 0; b < n_blocks; ++b)
    header.push_back(
        append_compressed(bytes.subspan(b * block_size, std::min(block_size, bytes.size() - b * block_size)), data));
  std::memcpy(data.data(), header.data(), header_size);
  return data;
}

}  // namespace creepcontact::io
