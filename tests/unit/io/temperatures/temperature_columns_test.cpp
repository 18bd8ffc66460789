/// Columns of temperatures under the names that programs give them.
#include "../../../../src/io/temperatures/temperature_columns.hpp"

#include <gtest/gtest.h>

#include "creepcontact/base/error.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

using test::message_of;
using test::says;

TEST(TemperatureColumns, QuantitiesByTheirNames) {
  const std::vector<std::pair<const char*, std::vector<const char*>>> known{
      {"x",
       {"x", "X", "x [mm]", "X (m)", "x_mm", "X Location (mm)", "coord_x", "X-coordinate", "Points:0", "x in mm",
        "COORD.COOR1"}},
      {"y", {"y", "Y [in]", "Points_1", "y.coord"}},
      {"z", {"z", "Z{mm}", "Points:2"}},
      {"r", {"r", "R [mm]", "radius", "Radial (m)"}},
      {"t", {"t", "time", "Time [s]", "TIME (h)", "t [h]", "T [s]", "TimeValue", "t_s"}},
      {"T",
       {"T", "Temperature", "temp_C", "TEMP", "T [K]", "t [degC]",
        "Temperature [\xC2\xB0"
        "C]",
        "NT11", "temp", "T_K", "temperature deg C", "Nodal Temperature (C)", "NDTEMP"}},
      {"", {"node", "", "stress [MPa]", "xx", "id", "heat flux x", "[mm]", "(", "T_max x", "element"}}};
  for (const auto& [quantity, names] : known)
    for (const char* const name : names) EXPECT_EQ(quantity_of(name), quantity) << "'" << name << "'";
}

TEST(TemperatureColumns, AreFoundOrNamed) {
  const TemperatureColumns found = find_columns("a.csv", {"Node", "X [mm]", "Y [mm]", "Z [mm]", "Temp [C]"}, {});
  EXPECT_EQ((std::vector{*found.x, *found.y, *found.z, found.T}), (std::vector<std::size_t>{1, 2, 3, 4}));
  EXPECT_FALSE(found.t);
  EXPECT_EQ(find_columns("a.csv", {"r", "z", "T"}, {}).coordinates(), PointTemperatures::Coordinates::rz);
  EXPECT_EQ(find_columns("a.csv", {"x", "y", "T"}, {}).coordinates(), PointTemperatures::Coordinates::xy);
  EXPECT_EQ(find_columns("a.csv", {"a", "b", "z", "q", "T"}, {{"x", "b"}, {"y", "a"}, {"T", "q"}}).T, 3U);
  // A column that was given has no other meaning.
  EXPECT_EQ(find_columns("a.csv", {"x", "y", "z", "T", "temp"}, {{"T", "temp"}}).T, 4U);
  EXPECT_FALSE(find_columns("a.csv", {"x", "y", "z", "t"}, {{"T", "t"}}).t);
}

TEST(TemperatureColumns, MistakesListWhatThereIs) {
  const auto message = [](const std::vector<std::string>& names, const ColumnNames& given = {}) {
    return message_of<ModelError>([&] { find_columns("a.csv", names, given); });
  };
  EXPECT_TRUE(says(message({"x", "y", "z", "Temp", "T [K]"}),
                   {"'a.csv', line 1: ", "'Temp'", "'T [K]'", "columns = { T = ", "x, y, z, Temp, T [K]"}));
  EXPECT_TRUE(says(message({"x", "y", "z", "theta"}),
                   {"'a.csv', line 1: ", "no column", "columns = { T = ", "x, y, z, theta"}));
  EXPECT_TRUE(says(message({"x", "z", "T"}), {"'a.csv', line 1: ", "columns = { x = ", "x, z, T"}));
  EXPECT_TRUE(
      says(message({"x", "y", "z", "T"}, {{"T", "NT"}}), {"'a.csv', line 1: ", "'NT'", "'columns'", "x, y, z, T"}));
}

}  // namespace
}  // namespace creepcontact::io
