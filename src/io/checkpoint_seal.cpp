#include "checkpoint_seal.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "creepcontact/base/checksum.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::io {
namespace {

constexpr std::string_view magic = "creepcontact checkpoint 3\n";

/// The user block: what the bytes behind it must be like. Padded with zeros.
std::string seal(std::uint64_t n_bytes, std::uint64_t checksum) {
  std::string text = fmt::format("{}bytes {}\nxxh3 {:016x}\n", magic, n_bytes, checksum);
  text.resize(seal_size, '\0');
  return text;
}

/// The seal that a file ought to have, from the bytes behind its place.
std::string computed_seal(std::istream& stream) {
  stream.seekg(seal_size);
  std::vector<char> buffer(std::size_t{1} << 16);
  std::uint64_t n_bytes = 0;
  Checksum sum;
  while (stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), stream.gcount() > 0) {
    sum.add(buffer.data(), stream.gcount());
    n_bytes += stream.gcount();
  }
  stream.clear();
  return seal(n_bytes, sum.value());
}

}  // namespace

void write_seal(const std::filesystem::path& path) {
  std::fstream stream(path, std::ios::binary | std::ios::in | std::ios::out);
  const std::string text = computed_seal(stream);
  errno = 0;
  stream.seekp(0);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (!stream)
    throw Error(fmt::format("cannot write the checkpoint '{}': {}", path.string(), platform::write_failure(errno)), 4);
}

void check_seal(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw ConfigError(fmt::format("cannot read the checkpoint '{}': {}", path.string(), std::strerror(errno)));
  std::string found(seal_size, '\0');
  stream.read(found.data(), seal_size);
  const bool complete = stream.gcount() == static_cast<std::streamsize>(seal_size);
  stream.clear();
  if (!found.starts_with(magic))
    throw ConfigError(fmt::format("'{}' is not a checkpoint of this version of creepcontact", path.string()));
  if (!complete || found != computed_seal(stream)) {
    throw ConfigError(
        fmt::format("the checkpoint '{}' is cut short or damaged (its checksum is wrong)", path.string()));
  }
}

}  // namespace creepcontact::io
