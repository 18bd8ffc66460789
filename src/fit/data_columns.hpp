#pragma once
/// The header of a file of test data: which column is what, and in which unit.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/fit/test_data.hpp"

namespace creepcontact::fit {

/// What a column may hold. Times come before the rate, whose unit of time follows theirs.
enum class ColumnRole {
  time,
  stress,
  strain,
  creep_strain,
  total_strain,
  temperature,
  test,
  batch,
  kind,
  rupture,
  rate
};
inline constexpr int n_column_roles = 11;

/// The columns of a file.
class DataColumns {
 public:
  /// @param file  for messages @param names  cells of the header.
  /// @throws ConfigError for a column that appears twice, a unit that is unknown, of another dimension, or does not fit
  /// the others, and if there are no data that can be fitted
  DataColumns(const std::string& file, const std::vector<std::string>& names);

  struct Column {
    std::size_t index;
    std::string name;   ///< as in the header
    double factor = 1;  ///< from the unit in the file to that of the fit
  };
  const std::optional<Column>& operator[](ColumnRole role) const { return columns_[static_cast<std::size_t>(role)]; }
  /// The units of the fit, as the header of the file gives them.
  const TestUnits& units() const { return units_; }
  const std::vector<std::string>& unused() const { return unused_; }

 private:
  void set_unit(ColumnRole role, const std::string& unit, const std::string& file);

  std::array<std::optional<Column>, n_column_roles> columns_;
  TestUnits units_;
  std::vector<std::string> unused_;
};

}  // namespace creepcontact::fit
