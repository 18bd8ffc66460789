#pragma once
/// The result files of a run, read as a user's program reads them: by their names and keys.

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "creepcontact/io/tables/csv_table.hpp"

namespace creepcontact::test {

/// history.csv or steps.csv
class Table {
 public:
  explicit Table(const std::filesystem::path& path);

  const std::vector<std::string>& names() const { return table_.names; }
  std::size_t rows() const { return table_.rows(); }
  /// @throws std::out_of_range if there is none of this name
  const std::vector<double>& column(const std::string& name) const;
  const std::vector<double>& times() const { return column("time"); }
  double sum(const std::string& name) const;
  /// @throws std::out_of_range if there is no such column, or no row of this time
  double at(const std::string& name, double time) const;

 private:
  io::CsvTable table_;
};

/// summary.json. Keys of nested objects are joined by '/': "contacts/fit/final_normal_force".
class SummaryFile {
 public:
  explicit SummaryFile(const std::filesystem::path& path);

  bool has(const std::string& key) const;
  /// @throws std::exception if there is no such key, or no number
  double number(const std::string& key) const;
  /// @throws std::exception if there is no such key, or neither true nor false
  bool truth(const std::string& key) const;
  /// @throws std::exception if there is no such key, or no text
  std::string text(const std::string& key) const;
  /// A list of texts; empty if there is no such key.
  std::vector<std::string> texts(const std::string& key) const;

 private:
  std::shared_ptr<const nlohmann::json> json_;
};

}  // namespace creepcontact::test
