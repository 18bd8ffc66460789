#include "creepcontact/io/tables/csv_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <optional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/io/tables/csv_table.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "csv_text.hpp"

namespace creepcontact::io {
namespace {

std::string header_line(const std::vector<std::string>& columns, const CsvFormat& format) {
  std::string line;
  for (const std::string& column : columns) {
    if (&column != columns.data()) line += format.separator;
    line += csv_cell(column, format);
  }
  return line + '\n';
}

/// Appends a cell to a line.
struct Append {
  const CsvFormat& format;
  std::string& line;

  void operator()(double number) const {
    const auto begin = static_cast<std::ptrdiff_t>(line.size());
    fmt::format_to(std::back_inserter(line), "{}", number);
    if (format.decimal != '.') std::replace(line.begin() + begin, line.end(), '.', format.decimal);
  }
  void operator()(std::int64_t number) const { fmt::format_to(std::back_inserter(line), "{}", number); }
  void operator()(std::string_view word) const { line += word; }
};

std::optional<double> time_of(std::string_view row, const CsvFormat& format) {
  return csv_number(row.substr(0, row.find(format.separator)), format);
}

/// Length of the beginning of `text` that holds whole rows up to last_time.
std::size_t kept_length(std::string_view text, std::size_t begin, double last_time, const CsvFormat& format) {
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) break;
    const auto time = time_of(text.substr(begin, end - begin), format);
    if (!time || *time > last_time) break;
    begin = end + 1;
  }
  return begin;
}

/// Cuts the file of the interrupted run. @returns false if there is nothing to go on with
bool cut(const std::filesystem::path& path, const std::string& header, double last_time, const CsvFormat& format) {
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
                    "probes and the same output.separator, or start again in another directory",
                    path.string(), text.substr(0, text.find('\n')), header.substr(0, header.size() - 1)));
  }
  const std::string_view rows = text;
  platform::replace_file(path, rows.substr(0, kept_length(rows, header.size(), last_time, format)));
  return true;
}

}  // namespace

CsvFile::CsvFile(const std::filesystem::path& path, const std::vector<std::string>& columns, Continuation continuation,
                 CsvFormat format)
    : path_(path), format_(format) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  const std::string header = header_line(columns, format_);
  const bool append = continuation.resume && cut(path, header, continuation.last_time, format_);
  file_.reset(append ? platform::reopen_stream(path, true) : platform::create_stream(path));
  if (!file_) throw ConfigError(fmt::format("cannot write '{}': {}", path.string(), platform::write_failure(errno)));
  if (!append) write_line(header);
}

void CsvFile::write(std::span<const CsvCell> row) {
  line_.clear();
  for (const CsvCell& cell : row) {
    if (&cell != row.data()) line_ += format_.separator;
    std::visit(Append{format_, line_}, cell);
  }
  line_ += '\n';
  write_line(line_);
}

void CsvFile::write_line(std::string_view line) {
  const bool written =
      std::fwrite(line.data(), 1, line.size(), file_.get()) == line.size() && std::fflush(file_.get()) == 0;
  if (!written) throw Error(fmt::format("cannot write '{}': {}", path_.string(), platform::write_failure(errno)), 4);
}

}  // namespace creepcontact::io
