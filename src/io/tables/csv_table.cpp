#include "creepcontact/io/tables/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "../file_text.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/utf8.hpp"
#include "csv_text.hpp"

namespace creepcontact::io {
namespace {

std::optional<double> plain_number(std::string_view cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

/// The separator that would make a number of the cell.
std::optional<char> likely_thousands(const std::string& cell) {
  for (const char sign : {'.', ',', ' ', '\''})
    if (const auto number = without_thousands(cell, *thousands_named({&sign, 1})); number && plain_number(*number))
      return sign;
  return std::nullopt;
}

/// UTF-8 of a character of ISO 8859-1.
std::string latin1_character(char c) {
  const auto code = static_cast<unsigned char>(c);
  if (code < 0xA0U) return "?";
  return {static_cast<char>(0xC0U | (code >> 6U)), static_cast<char>(0x80U | (code & 0x3FU))};
}

/// Excel's "CSV" has the code page of the machine, in which a degree sign is not a character of UTF-8.
void require_utf8(std::string_view text, const std::string& name) {
  const auto refuse = [&](const std::string& found) {
    throw ConfigError(fmt::format("{}: {}; save the file as UTF-8 (in spreadsheets: \"CSV UTF-8\")", name, found));
  };
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) refuse("the encoding is UTF-16");
  int line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text.substr(at));
    if (length == 0)
      refuse(fmt::format("byte 0x{:02X} in line {} is not a character of UTF-8 (in Latin-1 it is '{}')",
                         static_cast<unsigned char>(text[at]), line, latin1_character(text[at])));
    if (text[at] == '\n') ++line;
    at += length;
  }
}

}  // namespace

std::string CsvNumbers::way_out(char thousands) const {
  if (way_out_.empty()) return "write the numbers without it";
  return fmt::format("{} \"{}\"", way_out_, thousands);
}

CsvNumbers::Reading CsvNumbers::read(const std::string& cell, std::size_t line) {
  if (thousands_ != Thousands::none) {
    if (const auto number = without_thousands(cell, thousands_))
      if (const auto value = plain_number(*number)) return {value, ""};
    return {std::nullopt, fmt::format("'{}' is not a number with the given separator of thousands, which is between "
                                      "groups of three digits before the decimal sign",
                                      cell)};
  }
  const auto value = csv_number(cell, format_);
  if (!value) {
    const std::string no_number = fmt::format("'{}' is not a number", cell);
    const auto thousands = likely_thousands(cell);
    if (!thousands) return {std::nullopt, no_number};
    return {std::nullopt, fmt::format("{}; if '{}' separates its thousands, {}{}", no_number, *thousands,
                                      way_out_.empty() ? "" : "give ", way_out(*thousands))};
  }
  const bool has_point = cell.find('.') != std::string::npos, has_comma = cell.find(',') != std::string::npos;
  if (has_point && with_point_.line == 0) with_point_ = {cell, line};
  if (has_comma && with_comma_.line == 0) with_comma_ = {cell, line};
  if ((!has_point || with_comma_.line == 0) && (!has_comma || with_point_.line == 0)) return {value, ""};
  const Sight& other = has_point ? with_comma_ : with_point_;
  return {
      std::nullopt,
      fmt::format("'{}' has a {}, but '{}' in line {} has a {}, and only one of them can be the decimal sign. If the "
                  "point separates thousands, {}; if the comma does, {}",
                  cell, has_point ? "point" : "comma", other.cell, other.line, has_point ? "comma" : "point",
                  (way_out_.empty() ? "" : "give ") + way_out('.'), (way_out_.empty() ? "" : "give ") + way_out(','))};
}

std::string csv_cell(const std::string& text, CsvFormat format) {
  if (text.find_first_of(",\"\r\n") == std::string::npos && text.find(format.separator) == std::string::npos)
    return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

const std::vector<double>* CsvTable::column(const std::string& name) const {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? nullptr : &columns[found - names.begin()];
}

std::optional<double> csv_number(std::string_view cell, const CsvFormat& format) {
  std::string with_point;
  if (format.decimal == ',' && cell.find(',') != std::string_view::npos) {
    with_point = cell;
    *std::find(with_point.begin(), with_point.end(), ',') = '.';
    cell = with_point;
  }
  return plain_number(cell);
}

CsvTable parse_csv_table(std::string_view text, const std::string& name, UnendedRow unended) {
  CsvLines lines(text);
  std::string_view line;
  if (!lines.next(line)) throw ConfigError(fmt::format("{}: no header", name));
  CsvTable table;
  const CsvFormat format = csv_format_of(line);
  table.names = csv_cells(line, format.separator);
  table.columns.resize(table.names.size());
  CsvNumbers numbers(format, Thousands::none, "");
  for (int row = 2; lines.next(line); ++row) {
    if (!lines.ended() && unended == UnendedRow::is_left_out) break;
    const std::vector<std::string> found = csv_cells(line, format.separator);
    if (found.size() == 1 && found[0].empty()) continue;
    const std::string where = fmt::format("{}:{}", name, row);
    if (found.size() != table.names.size())
      throw ConfigError(fmt::format("{}: {} cells under {} columns", where, found.size(), table.names.size()));
    for (std::size_t c = 0; c < found.size(); ++c) {
      const CsvNumbers::Reading reading = numbers.read(found[c], static_cast<std::size_t>(row));
      if (!reading.value) throw ConfigError(fmt::format("{}: {}", where, reading.mistake));
      table.columns[c].push_back(*reading.value);
    }
  }
  return table;
}

CsvCells parse_csv_cells(std::string_view text, const std::string& name) {
  require_utf8(text, name);
  CsvLines lines(text);
  CsvCells table;
  std::string_view line;
  for (int number = 1; lines.next(line); ++number) {
    if (line.starts_with('#')) continue;
    if (table.names.empty()) table.format = csv_format_of(line);
    std::vector<std::string> cells = csv_cells(line, table.format.separator);
    if (std::ranges::all_of(cells, &std::string::empty)) continue;
    if (table.names.empty())
      table.names = std::move(cells);
    else if (cells.size() != table.names.size())
      table.uneven.push_back({number, cells.size()});
    else
      table.rows.push_back({number, std::move(cells)});
  }
  if (table.names.empty()) throw ConfigError(fmt::format("{}: no header", name));
  return table;
}

CsvTable read_csv_table(const std::filesystem::path& path, UnendedRow unended) {
  return parse_csv_table(file_text<ConfigError>(path), path.string(), unended);
}

}  // namespace creepcontact::io
