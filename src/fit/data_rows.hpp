#pragma once
/// The rows of a file of test data, checked one by one.

#include <optional>
#include <string>
#include <vector>

#include "creepcontact/io/tables/csv_table.hpp"
#include "data_columns.hpp"

namespace creepcontact::fit {

/// Mistakes in rows; all are reported together, those that differ in numbers alone in one line.
class RowMistakes {
 public:
  explicit RowMistakes(std::string file) : file_(std::move(file)) {}
  void add(int line, const std::string& message);
  /// @throws ConfigError if there are any
  void throw_if_any() const;

 private:
  struct Mistake {
    int line;
    std::string message;
  };
  std::string file_;
  std::vector<Mistake> mistakes_;
};

/// One row in the units of the fit.
struct DataRow {
  int line = 0;
  std::optional<TestKind> kind;  ///< nullopt: only a time to rupture in its own column
  std::string test, batch;
  double stress = 0, temperature = 0;
  std::optional<double> time, strain, rate, rupture;
  bool strain_is_total = false;
};

/// @returns the rows without mistakes; empty ones and those with a wrong number of cells are left out
std::vector<DataRow> read_rows(const io::CsvCells& table, const DataColumns& columns, bool strain_is_total,
                               io::Thousands thousands, RowMistakes& mistakes);

}  // namespace creepcontact::fit
