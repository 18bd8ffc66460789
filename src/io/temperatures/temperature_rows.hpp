#pragma once
/// Sorts single temperatures of place and time into lists of the same places at every time.

#include <array>
#include <functional>
#include <map>
#include <string>

#include "creepcontact/io/temperatures/temperature_reader.hpp"

namespace creepcontact::io {

class TemperatureRows {
 public:
  /// @param file  as messages name it @param row_name  "line 7", "row 3": where a row is
  TemperatureRows(std::string file, std::function<std::string(std::size_t)> row_name)
      : file_(std::move(file)), row_name_(std::move(row_name)) {}

  /// @throws ModelError if a number is not finite, or the place has another temperature at this time already
  void add(std::size_t row, const Vector3& position, double time, double temperature);
  /// @throws ModelError if there are no rows, or the places differ between the times
  PointTemperatures sorted() const;

 private:
  struct Value {
    double temperature;
    std::size_t row;
  };
  using Place = std::array<double, 3>;
  std::string file_;
  std::function<std::string(std::size_t)> row_name_;
  std::map<double, std::map<Place, Value>> times_;
};

}  // namespace creepcontact::io
