#include "creepcontact/io/csv_file.hpp"

#include <fmt/ranges.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/io/csv_table.hpp"
#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::io {
namespace {

std::string header_line(const std::vector<std::string>& columns) {
  std::vector<std::string> cells;
  cells.reserve(columns.size());
  for (const std::string& column : columns) cells.push_back(csv_cell(column));
  return fmt::format("{}\n", fmt::join(cells, ","));
}

std::optional<double> time_of(std::string_view row) {
  double time = 0;
  const auto [end, error] = std::from_chars(row.data(), row.data() + row.size(), time);
  if (error != std::errc() || (end != row.data() + row.size() && *end != ',')) return std::nullopt;
  return time;
}

/// Length of the beginning of `text` that holds whole rows up to last_time.
std::size_t kept_length(std::string_view text, std::size_t begin, double last_time) {
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) break;
    const auto time = time_of(text.substr(begin, end - begin));
    if (!time || *time > last_time) break;
    begin = end + 1;
  }
  return begin;
}

/// Cuts the file of the interrupted run. @returns false if there is nothing to go on with
bool cut(const std::filesystem::path& path, const std::string& header, double last_time) {
  std::ifstream stream(path, std::ios::binary);
  const std::string text = stream ? std::string(std::istreambuf_iterator<char>(stream), {}) : "";
  if (text.empty()) {
    log::warning("'{}' of the interrupted run is missing or empty; its rows up to t = {:.6g} are lost", path.string(),
                 last_time);
    return false;
  }
  if (!text.starts_with(header)) {
    throw ConfigError(
        fmt::format("'{}' has other columns than this run: '{}' instead of '{}'; resume with the same "
                    "probes, or start again in another directory",
                    path.string(), text.substr(0, text.find('\n')), header.substr(0, header.size() - 1)));
  }
  const std::string_view rows = text;
  platform::replace_file(path, rows.substr(0, kept_length(rows, header.size(), last_time)));
  return true;
}

}  // namespace

CsvFile::CsvFile(const std::filesystem::path& path, const std::vector<std::string>& columns, Continuation continuation)
    : path_(path) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  const std::string header = header_line(columns);
  const bool append = continuation.resume && cut(path, header, continuation.last_time);
  file_.reset(std::fopen(path.c_str(), append ? "ab" : "wb"));
  if (!file_) throw ConfigError(fmt::format("cannot write '{}': {}", path.string(), std::strerror(errno)));
  if (!append) write({header.data(), header.size() - 1});
}

void CsvFile::write(std::string_view row) {
  const bool written = std::fwrite(row.data(), 1, row.size(), file_.get()) == row.size() &&
                       std::fputc('\n', file_.get()) != EOF && std::fflush(file_.get()) == 0;
  if (!written) throw Error(fmt::format("cannot write '{}': {}", path_.string(), std::strerror(errno)), 4);
}

void CsvFile::sync() {
  if (::fsync(::fileno(file_.get())) != 0)
    throw Error(fmt::format("cannot write '{}': {}", path_.string(), std::strerror(errno)), 4);
}

}  // namespace creepcontact::io
