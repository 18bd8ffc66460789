#pragma once
/// Which column of a table of temperatures is what, from the names in its header.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/io/temperatures/temperature_reader.hpp"

namespace creepcontact::io {

/// Indices of columns. Either x and y are there, or r and z.
struct TemperatureColumns {
  std::optional<std::size_t> x, y, z, r, t;
  std::size_t T = 0;

  PointTemperatures::Coordinates coordinates() const;
};

/// "x", "y", "z", "r", "t" or "T" as programs write them: in any case (but t and T), with a unit in brackets or at the
/// end, with words such as "coordinate". Empty: none of them.
std::string quantity_of(std::string_view column);

/// @param file  as messages name it @param given  names that go before those that are recognised
/// @throws ModelError if one is missing, or two may be the same: with all columns found
TemperatureColumns find_columns(const std::string& file, const std::vector<std::string>& names,
                                const ColumnNames& given);

}  // namespace creepcontact::io
