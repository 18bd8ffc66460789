#include "vtk_encoding.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace creepcontact::io {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 18;  // bytes

/// @returns the compressed size
std::uint64_t append_compressed(std::span<const std::byte> block, std::string& data) {
  uLongf length = ::compressBound(block.size());
  const std::size_t begin = data.size();
  data.resize(begin + length);
  // The fastest level: the last bits of stresses are noise, higher levels gain little on them.
  if (::compress2(reinterpret_cast<Bytef*>(data.data() + begin), &length, reinterpret_cast<const Bytef*>(block.data()),
                  block.size(), Z_BEST_SPEED) != Z_OK)
    throw std::runtime_error("zlib could not compress a field");
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
