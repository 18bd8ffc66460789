#pragma once
/// The rows of a file of test data, checked one by one.

#include <optional>
#include <string>
#include <vector>

#include "creepcontact/io/csv_table.hpp"
#include "data_columns.hpp"

namespace creepcontact::fit {

/// Mistakes in rows; all are reported together.
class RowMistakes {
 public:
  explicit RowMistakes(std::string file) : file_(std::move(file)) {}
  void add(int line, const std::string& message);
  /// @throws ConfigError with a line each, if there are any
  void throw_if_any() const;

 private:
  std::string file_;
  std::vector<std::string> lines_;
};

/// One row in the units of the fit.
struct DataRow {
  int line = 0;
  std::optional<TestKind> kind;  ///< nullopt: only a time to rupture in its own column
  std::string test;
  double stress = 0, temperature = 0;
  std::optional<double> time, strain, rate, rupture;
  bool strain_is_total = false;
};

/// @returns the rows without mistakes; empty ones are left out
std::vector<DataRow> read_rows(const io::CsvCells& table, const DataColumns& columns, bool strain_is_total,
                               RowMistakes& mistakes);

}  // namespace creepcontact::fit
