#include "checkpoint_seal.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/base/checksum.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::io {
namespace {

constexpr std::string_view magic = "creepcontact checkpoint ";  // begins the file; the version of the format follows
constexpr int format_version = 5;

/// The user block: what the bytes behind it must be like. Padded with zeros.
std::string seal(std::uint64_t n_bytes, std::uint64_t checksum) {
  std::string text = fmt::format("{}{}\nbytes {}\nxxh3 {:016x}\n", magic, format_version, n_bytes, checksum);
  text.resize(seal_size, '\0');
  return text;
}

/// @throws ConfigError if the text does not begin a checkpoint, OtherFormat if that of another format
void require_format(std::string_view text, const std::filesystem::path& path) {
  const std::string_view line = text.substr(0, text.find('\n'));
  const std::string_view version = line.starts_with(magic) ? line.substr(magic.size()) : "";
  const bool is_number = !version.empty() && version.find_first_not_of("0123456789") == std::string_view::npos;
  if (!is_number) throw ConfigError(fmt::format("'{}' is not a checkpoint of creepcontact", path.string()));
  if (version != std::to_string(format_version))
    throw OtherFormat(
        fmt::format("run without --resume to start again, or resume with the version of creepcontact that wrote the "
                    "checkpoint '{}': its format has the version {}, and this program reads version {}",
                    path.string(), version, format_version));
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
  require_format(found, path);
  if (!complete || found != computed_seal(stream)) {
    throw ConfigError(
        fmt::format("the checkpoint '{}' is cut short or damaged (its checksum is wrong)", path.string()));
  }
}

}  // namespace creepcontact::io
