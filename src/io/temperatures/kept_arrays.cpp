#include "creepcontact/io/temperatures/kept_arrays.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string_view>

#include "creepcontact/base/checksum.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::io {
namespace {

// The kind, the checksum of what follows, the length and the text of the fingerprint, the number of arrays, and of each
// its length and its numbers.
constexpr std::string_view family = "creepcontact arrays ", kind = "creepcontact arrays 1\n";

void append(std::string& bytes, const void* data, std::size_t size) {
  bytes.append(static_cast<const char*>(data), size);
}
void append(std::string& bytes, std::uint64_t number) {
  append(bytes, &number, sizeof(number));
}

std::uint64_t checksum(std::string_view bytes) {
  Checksum sum;
  sum.add(bytes.data(), bytes.size());
  return sum.value();
}

/// What is left of a file.
class Rest {
 public:
  explicit Rest(std::string_view bytes) : bytes_(bytes) {}
  std::string_view take(std::size_t size) {
    if (size > bytes_.size()) throw ConfigError("it is truncated");
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }
  std::uint64_t number() {
    std::uint64_t result = 0;
    std::memcpy(&result, take(sizeof(result)).data(), sizeof(result));
    return result;
  }
  std::vector<double> numbers() {
    const std::uint64_t n = number();
    if (n > bytes_.size() / sizeof(double)) throw ConfigError("it is truncated");
    std::vector<double> result(n);
    if (n > 0) std::memcpy(result.data(), take(n * sizeof(double)).data(), n * sizeof(double));
    return result;
  }
  std::string_view all() const { return bytes_; }

 private:
  std::string_view bytes_;
};

KeptArrays read_content(std::string_view bytes) {
  if (!bytes.starts_with(family)) throw OtherFile("it is not a file that this program keeps");
  if (!bytes.starts_with(kind)) throw ConfigError("it is of another version of the program");
  Rest rest(bytes.substr(kind.size()));
  if (const std::uint64_t written = rest.number(); written != checksum(rest.all()))
    throw ConfigError("it is damaged: its checksum differs");
  KeptArrays result;
  result.fingerprint = rest.take(rest.number());
  const std::uint64_t n = rest.number();
  for (std::uint64_t i = 0; i < n; ++i) {  // each takes some bytes, so that a wrong number ends early
    result.arrays.push_back(rest.numbers());
    if (!std::ranges::all_of(result.arrays.back(), [](double value) { return std::isfinite(value); }))
      throw ConfigError("it has numbers that are not finite");
  }
  if (!rest.all().empty()) throw ConfigError("it is longer than its content");
  return result;
}

}  // namespace

void write_kept_arrays(const std::filesystem::path& path, const KeptArrays& kept) {
  std::string content;
  append(content, kept.fingerprint.size());
  content += kept.fingerprint;
  append(content, kept.arrays.size());
  for (const std::vector<double>& values : kept.arrays) {
    append(content, values.size());
    append(content, values.data(), values.size() * sizeof(double));
  }
  std::string head(kind);
  append(head, checksum(content));
  // A name of this process's own, because others may write the same file.
  std::filesystem::path own = path;
  own += fmt::format(".{}-{:08x}", ::getpid(), std::random_device()());
  content.insert(0, head);
  platform::replace_file(own, content);
  std::error_code error;
  std::filesystem::rename(own, path, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(own, ignored);
  throw Error(fmt::format("cannot write '{}': {}", path.string(), error.message()), 4);
}

KeptArrays read_kept_arrays(const std::filesystem::path& path) {
  const FileBytes file = read_file(path);
  if (!file.failure.empty()) throw ConfigError(file.failure);
  return read_content(file.bytes);
}

}  // namespace creepcontact::io
