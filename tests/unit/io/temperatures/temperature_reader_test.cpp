#include "creepcontact/io/temperatures/temperature_reader.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

using test::says;

class TemperatureReader : public testing::Test {
 protected:
  PointTemperatures csv(const std::string& text) {
    return read_temperatures({{test::write_text(directory_ / "T.csv", text)}});
  }
  std::string mistake(const std::string& text) {
    return test::message_of<ModelError>([&] { csv(text); });
  }
  void expect_mistake(const std::string& text, std::initializer_list<std::string_view> facts) {
    const std::string message = mistake(text);
    EXPECT_TRUE(says(message, {(directory_ / "T.csv").string()}));
    EXPECT_TRUE(says(message, facts)) << text;
  }
  /// A dataset with its extents; without values it is not written.
  struct Dataset {
    std::string name;
    std::vector<hsize_t> sizes;
    std::vector<double> values;
  };
  std::filesystem::path hdf5(const std::vector<Dataset>& sets) {
    const auto path = directory_ / "T.h5";
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    for (const Dataset& set : sets) {
      const hid_t space = H5Screate_simple(static_cast<int>(set.sizes.size()), set.sizes.data(), nullptr);
      const hid_t data =
          H5Dcreate2(file, set.name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
      if (!set.values.empty()) H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, set.values.data());
      H5Dclose(data);
      H5Sclose(space);
    }
    H5Fclose(file);
    return path;
  }

  test::TemporaryDirectory directory_;
};

TEST_F(TemperatureReader, SteadyTable) {
  const auto read = csv("x,y,z,T\n1,2,3,500\n\n0,0,0, 20.5 \r\n1,2,3,500\n");
  ASSERT_EQ(read.points.size(), 2u);
  EXPECT_EQ(read.points[0], Vector3(0, 0, 0));
  EXPECT_EQ(read.times, std::vector<double>{0});
  EXPECT_EQ(read.values, (std::vector<std::vector<double>>{{20.5, 500}}));
}

TEST_F(TemperatureReader, TimesColumnsAndRowsInAnyOrder) {
  const auto read = csv("node,T,t,z,y,x\n1,30,5,0,0,0\n2,40,5,0,0,1\n2,20,0,0,0,1\n1,10,0,0,0,0\n");
  EXPECT_EQ(read.times, (std::vector<double>{0, 5}));
  EXPECT_EQ(read.values, (std::vector<std::vector<double>>{{10, 20}, {30, 40}}));
}

TEST_F(TemperatureReader, MistakesAreNamedWithTheirLine) {
  expect_mistake("x,z,T\n1,2,3\n", {"line 1: ", "columns = { x = ", "x, z, T"});
  expect_mistake("x,y,z,T\n1,2,3,4\n1,2,3x,4\n", {"line 3: ", "'z'", "'3x'"});
  expect_mistake("x,y,z,T\n1,2,3,\n", {"line 2: ", "'T'", "''"});
  expect_mistake("x;y;z;T\n1;2;3,5;1.000\n",
                 {"line 2: ", "'T'", "'1.000'", "'3,5'", "line 2", "temperature.thousands = \".\""});
  EXPECT_DOUBLE_EQ(parse_temperatures("x;y;z;T\n1;2;3,5;1.000\n", "a.csv", {}, Thousands::point).values[0][0], 1000);
  expect_mistake("x,y,z,T\n1,2,3\n", {"line 2: ", "3 cells", "'T'"});
  expect_mistake("x,y,z,T\n1,2,3,nan\n", {"line 2: ", "finite"});
  expect_mistake("x,y,z,T\n", {"no temperatures"});
  expect_mistake("x,y,z,T\n0,0,0,1\n0,0,0,2\n", {"line 3: ", "(0, 0, 0)", "2", "1", "line 2"});
  expect_mistake("x,y,z,t,T\n0,0,0,0,1\n1,0,0,0,1\n0,0,0,5,1\n", {"(1, 0, 0)", "line 3", "t = 5"});
  const auto missing = directory_ / "none.csv";
  EXPECT_TRUE(
      says(test::message_of<ModelError>([&] { read_temperatures({{missing}}); }), {"none.csv: ", "No such file"}));
}

TEST_F(TemperatureReader, Hdf5) {
  const std::vector<double> positions{0, 0, 0, 1, 0, 0};
  const auto steady = read_temperatures({{hdf5({{"coordinates", {2, 3}, positions}, {"temperature", {2}, {10, 20}}})}});
  EXPECT_EQ(steady.values, (std::vector<std::vector<double>>{{10, 20}}));
  const auto changing = read_temperatures({{hdf5(
      {{"coordinates", {2, 3}, positions}, {"temperature", {2, 2}, {10, 20, 30, 40}}, {"times", {2}, {0, 7}}})}});
  EXPECT_EQ(changing.times, (std::vector<double>{0, 7}));
  EXPECT_EQ(changing.values, (std::vector<std::vector<double>>{{10, 20}, {30, 40}}));
}

TEST_F(TemperatureReader, Hdf5Mistakes) {
  const std::vector<double> positions{0, 0, 0, 1, 0, 0};
  const auto message = [&](const std::vector<Dataset>& sets) {
    const auto path = hdf5(sets);
    return test::message_of<ModelError>([&] { read_temperatures({{path}}); });
  };
  EXPECT_TRUE(says(message({{"coordinates", {2, 3}, positions}}), {"'temperature'", "coordinates"}));
  EXPECT_TRUE(
      says(message({{"coordinates", {6}, positions}, {"temperature", {2}, {1, 2}}}), {"'coordinates'", "6", "n x 3"}));
  EXPECT_TRUE(says(message({{"coordinates", {2, 3}, positions}, {"temperature", {3}, {1, 2, 3}}}),
                   {"'temperature'", "3", "2 points", "1 times", "1 x 2"}));
  EXPECT_TRUE(
      says(message({{"coordinates", {2, 3}, positions}, {"temperature", {2, 2}, {1, 2, 3, 4}}, {"times", {2}, {7, 0}}}),
           {"'times'", "0", "7"}));
  constexpr hsize_t n = hsize_t{1} << 40;  // points that are in no file
  EXPECT_TRUE(
      says(message({{"coordinates", {n, 3}, {}}, {"temperature", {n}, {}}}), {"'coordinates'", "3298534883328"}));
  const auto text = test::write_text(directory_ / "bad.h5", "x,y,z,T\n");
  EXPECT_TRUE(says(test::message_of<ModelError>([&] { read_temperatures({{text}}); }), {"bad.h5'", "HDF5"}));
}

}  // namespace
}  // namespace creepcontact::io
