#include "creepcontact/io/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "csv_text.hpp"
#include "file_text.hpp"

namespace creepcontact::io {
namespace {

double number(const std::string& cell, const CsvFormat& format, const std::string& where) {
  if (const auto value = csv_number(cell, format)) return *value;
  throw ConfigError(fmt::format("{}: '{}' is not a number", where, cell));
}

}  // namespace

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
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

CsvTable parse_csv_table(std::string_view text, const std::string& name, UnendedRow unended) {
  CsvLines lines(text);
  std::string_view line;
  if (!lines.next(line)) throw ConfigError(fmt::format("{}: no header", name));
  CsvTable table;
  const CsvFormat format = csv_format_of(line);
  table.names = csv_cells(line, format.separator);
  table.columns.resize(table.names.size());
  for (int row = 2; lines.next(line); ++row) {
    if (!lines.ended() && unended == UnendedRow::is_left_out) break;
    const std::vector<std::string> found = csv_cells(line, format.separator);
    if (found.size() == 1 && found[0].empty()) continue;
    const std::string where = fmt::format("{}:{}", name, row);
    if (found.size() != table.names.size())
      throw ConfigError(fmt::format("{}: {} cells under {} columns", where, found.size(), table.names.size()));
    for (std::size_t c = 0; c < found.size(); ++c) table.columns[c].push_back(number(found[c], format, where));
  }
  return table;
}

CsvCells parse_csv_cells(std::string_view text, const std::string& name) {
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
