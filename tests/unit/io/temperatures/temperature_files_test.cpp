/// Temperatures in several files, and in those of other programs.
#include <gtest/gtest.h>

#include <fstream>

#include "../../../../src/io/temperatures/frd_temperatures.hpp"
#include "../../../../src/io/temperatures/vtu_temperatures.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/io/fields/field_writer.hpp"
#include "creepcontact/io/temperatures/temperature_reader.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

using test::message_of;
using test::says;
using Values = std::vector<std::vector<double>>;

class TemperatureFiles : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& text) {
    return test::write_text(directory_ / name, text);
  }
  std::string mistake(const TemperatureSource& source) {
    return message_of<ModelError>([&] { read_temperatures(source); });
  }
  test::TemporaryDirectory directory_;
};

TEST_F(TemperatureFiles, TimesAreInTheNames) {
  file("t_10.csv", "x,y,z,T\n0,0,0,3\n1,0,0,4\n");
  file("t_2.5.csv", "x,y,z,T\n1,0,0,2\n0,0,0,1\n");
  file("other.csv", "");
  const PointTemperatures read = read_temperatures({{directory_ / "t_*.csv"}});
  EXPECT_EQ(read.times, (std::vector<double>{2.5, 10}));
  EXPECT_EQ(read.values, (Values{{1, 2}, {3, 4}}));
  EXPECT_EQ(temperature_files({{directory_ / "t_*.csv"}}),
            (std::vector<std::filesystem::path>{directory_ / "t_2.5.csv", directory_ / "t_10.csv"}));
  file("t_010.csv", "x,y,z,T\n0,0,0,3\n1,0,0,4\n");
  EXPECT_TRUE(says(mistake({{directory_ / "t_*.csv"}}), {"t_", "t_", "same time"}));
  file("t_last.csv", "");
  EXPECT_TRUE(says(mistake({{directory_ / "t_*.csv"}}), {"t_*.csv'", "t_last.csv'", "'last'"}));
  EXPECT_TRUE(says(mistake({{directory_ / "u_*.csv"}}), {"no file", "u_*.csv'"}));
  EXPECT_TRUE(says(mistake({{directory_ / "t_*_*.csv"}}), {"t_*_*.csv'", "'*'"}));
  EXPECT_TRUE(says(mistake({{directory_ / "none/t_*.csv"}}), {"directory", "none'"}));
}

TEST_F(TemperatureFiles, AListWithTimes) {
  const auto a = file("a.csv", "x,y,z,T\n0,0,0,1\n"), b = file("b.csv", "x;y;z;T\n0;0;0;1,5\n");
  const PointTemperatures read = read_temperatures({{a, b}, {0, 7}});
  EXPECT_EQ(read.times, (std::vector<double>{0, 7}));
  EXPECT_EQ(read.values, (Values{{1}, {1.5}}));
  EXPECT_TRUE(says(mistake({{a, b}}), {"a.csv'", "'times'"}));
  const auto c = file("c.csv", "x,y,z,t,T\n0,0,0,1,1\n0,0,0,2,1\n"), d = file("d.csv", "x,y,z,t,T\n0,0,0,9,3\n");
  EXPECT_TRUE(says(mistake({{a, c}, {0, 7}}), {"c.csv'", "2 times"}));
  EXPECT_EQ(read_temperatures({{d, c}}).times, (std::vector<double>{1, 2, 9}));
  EXPECT_TRUE(says(mistake({{c, c}}), {"c.csv'", "t = 1"}));
  const auto moved = file("moved.csv", "x,y,z,T\n0,0,1,1\n");
  EXPECT_TRUE(says(mistake({{a, moved}, {0, 7}}), {"moved.csv'", "(0, 0, 0)", "a.csv'"}));
}

/// As CalculiX 2.20 writes them: short and long node numbers.
std::string frd(const std::string& values_at_2, const std::string& format = "1") {
  return "    1C\n    1UUSER\n    2C                             2                                     " + format +
         "\n"
         " -1         1 0.00000E+00-1.00000E+00 2.00000E+00\n"
         " -1         2 1.00000E+00-1.00000E+00 2.00000E+00\n"
         " -3\n"
         "    1PSTEP                         1           1           1\n"
         "  100CL  101 1.000000000           2                     0    1           " +
         format +
         "\n"
         " -4  DISP        4    1\n -5  D1          1    2    1    0\n"
         " -1         1 9.00000E+00 9.00000E+00 9.00000E+00\n -3\n"
         "  100CL  101 1.000000000           2                     0    1           " +
         format +
         "\n"
         " -4  NDTEMP      1    1\n -5  T           1    1    0    0\n"
         " -1         1 2.00000E+01\n -1         2-3.00000E+01\n -3\n"
         "  100CL  102 2.500000000           2                     0    2           " +
         format +
         "\n"
         " -4  NDTEMP      1    1\n -5  T           1    1    0    0\n" +
         values_at_2 + " -3\n 9999\n";
}
const std::string both = " -1         1 2.10000E+01\n -1         2 3.10000E+01\n";

TEST_F(TemperatureFiles, OfCalculix) {
  const PointTemperatures read = read_temperatures({{file("a.frd", frd(both))}});
  EXPECT_EQ(read.points, (std::vector<Vector3>{{0, -1, 2}, {1, -1, 2}}));
  EXPECT_EQ(read.times, (std::vector<double>{1, 2.5}));
  EXPECT_EQ(read.values, (Values{{20, -30}, {21, 31}}));
  const std::string short_numbers =
      "    2C                             1                                     0\n -1    7 1.00000E+00 2.00000E+00 "
      "3.00000E+00\n -3\n"
      "  100CL  101 1.000000000           1                     0    1           0\n -4  NDTEMP      1    1\n"
      " -1    7 5.00000E+00\n -3\n";
  EXPECT_EQ(parse_frd(short_numbers, "b.frd").values, (Values{{5}}));
}

TEST_F(TemperatureFiles, OfCalculixThatCannotBeUsed) {
  const auto message = [](const std::string& text) {
    return message_of<ModelError>([&] { parse_frd(text, "a.frd"); });
  };
  EXPECT_TRUE(says(message(frd(both, "2")), {"'a.frd', line 3: ", "binary"}));
  EXPECT_TRUE(says(message(frd(" -1         1 2.10000E+01\n")), {"'a.frd'", "t = 1", "t = 2.5"}));
  EXPECT_TRUE(says(message(frd(" -1         3 2.10000E+01\n")), {"line 22: ", "node 3"}));
  EXPECT_TRUE(says(message(frd(" -1         1 2.1x000E+01\n")), {"line 22: ", "'2.1x000E+01'", "14", "25"}));
  EXPECT_TRUE(says(message(frd(" -1         1         nan\n")), {"line 22: ", "finite"}));
  EXPECT_TRUE(says(message("    1C\n"), {"'a.frd'", "NDTEMP", "*NODE FILE"}));
  std::string without = frd(both);
  for (std::size_t at = 0; (at = without.find("NDTEMP")) != std::string::npos;) without.replace(at, 6, "STRESS");
  EXPECT_TRUE(says(message(without), {"'a.frd'", "NDTEMP", "DISP, STRESS"}));
  EXPECT_TRUE(says(message(frd(both).substr(0, 143)), {"'a.frd'", "ends", "nodes"}));
}

TEST_F(TemperatureFiles, NodesAtOnePlaceHaveTheirMean) {
  std::string text = frd(both);
  text.replace(text.find(" -1         2 1.0"), 17, " -1         2 0.0");
  testing::internal::CaptureStderr();
  const PointTemperatures read = parse_frd(text, "a.frd");
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(read.points.size(), 1U);
  EXPECT_EQ(read.values, (Values{{-5}, {26}}));
  EXPECT_TRUE(says(said, {"temperature: ", "'a.frd'", "1 of 1", "50"}));
}

/// A grid of one vertex cell and two points around the arrays given.
std::string vtu(const std::string& points, const std::string& temperature, const std::string& head = "",
                const std::string& tail = "") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\" " +
         head +
         "><UnstructuredGrid><Piece NumberOfPoints=\"2\" NumberOfCells=\"0\"><PointData>"
         "<DataArray type=\"Float64\" Name=\"velocity\" NumberOfComponents=\"3\" format=\"ascii\">1 2 3 4 5 "
         "6</DataArray>" +
         temperature + "</PointData><Points>" + points + "</Points></Piece></UnstructuredGrid>" + tail + "</VTKFile>\n";
}
const std::string ascii_points =
    "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0\n 1 0 0.5</DataArray>";
const std::string ascii_temperature =
    "<DataArray type=\"Float64\" Name=\"Temperature [K]\" format=\"ascii\">300 4e2</DataArray>";

TEST_F(TemperatureFiles, OfParaViewAsText) {
  const PointTemperatures read = read_temperatures({{file("a.vtu", vtu(ascii_points, ascii_temperature))}});
  EXPECT_EQ(read.points, (std::vector<Vector3>{{0, 0, 0}, {1, 0, 0.5}}));
  EXPECT_EQ(read.values, (Values{{300, 400}}));
  const std::string other = "<DataArray type=\"Float64\" Name=\"q\" format=\"ascii\">1 2</DataArray>";
  EXPECT_EQ(parse_vtu(vtu(ascii_points, ascii_temperature + other), "a.vtu", "q").values, (Values{{1, 2}}));
}

/// Base64 of one header and the numbers; the header apart from the numbers.
TEST_F(TemperatureFiles, OfParaViewInBase64) {
  // UInt32 8, Float32 300, 400
  const std::string together =
      "<DataArray type=\"Float32\" Name=\"temp\" format=\"binary\">\n  CAAAAAAAlkMAAMhD\n</DataArray>";
  EXPECT_EQ(parse_vtu(vtu(ascii_points, together), "a.vtu", "").values, (Values{{300, 400}}));
  const std::string apart =
      "<DataArray type=\"Float32\" Name=\"temp\" format=\"binary\">CAAAAA==AACWQwAAyEM=</DataArray>";
  EXPECT_EQ(parse_vtu(vtu(ascii_points, apart), "a.vtu", "").values, (Values{{300, 400}}));
  const std::string appended = "<DataArray type=\"Float32\" Name=\"temp\" format=\"appended\" offset=\"4\"/>";
  EXPECT_EQ(parse_vtu(vtu(ascii_points, appended, "",
                          "<AppendedData encoding=\"base64\">\n_abcdCAAAAAAAlkMAAMhD\n</AppendedData>"),
                      "a.vtu", "")
                .values,
            (Values{{300, 400}}));
}

/// What this program writes: appended, raw, compressed, with 64-bit headers and the time.
TEST_F(TemperatureFiles, OfThisProgram) {
  FieldMesh mesh;
  std::vector<double> values;
  for (int i = 0; i < 50000; ++i) {  // several blocks
    mesh.points.emplace_back(i, 0.5 * i, 1);
    values.push_back(20 + 0.25 * i);
  }
  const auto path = FieldWriter(directory_.path(), "f", mesh, "").write(3.5, {{"temperature [degC]", 1, values}}, {});
  const PointTemperatures read = read_temperatures({{path}});
  EXPECT_EQ(read.times, std::vector<double>{3.5});
  EXPECT_TRUE(read.has_times);
  EXPECT_EQ(read.points, mesh.points);
  EXPECT_EQ(read.values, Values{values});
}

TEST_F(TemperatureFiles, OfParaViewThatCannotBeUsed) {
  const auto message = [](const std::string& text, const std::string& array = "") {
    return message_of<ModelError>([&] { parse_vtu(text, "a.vtu", array); });
  };
  EXPECT_TRUE(says(message("x,y,z,T\n"), {"'a.vtu'", "XML"}));
  EXPECT_TRUE(says(message("<VTKFile type=\"PolyData\"/>"), {"'a.vtu'", "'PolyData'", "UnstructuredGrid"}));
  EXPECT_TRUE(says(message(vtu(ascii_points, ascii_temperature, "compressor=\"vtkLZ4DataCompressor\"")),
                   {"'a.vtu'", "vtkLZ4DataCompressor", "zlib"}));
  EXPECT_TRUE(says(message(vtu(ascii_points, "")), {"'a.vtu'", "no array", "columns = { T = "}));
  EXPECT_TRUE(
      says(message(vtu(ascii_points, ascii_temperature), "q"), {"'a.vtu'", "'q'", "velocity, Temperature [K]"}));
  EXPECT_TRUE(says(message(vtu(ascii_points, ascii_temperature + ascii_temperature)),
                   {"Temperature [K]", "Temperature [K]", "columns = { T = "}));
  EXPECT_TRUE(says(message(vtu(ascii_points, ascii_temperature), "velocity"), {"'a.vtu'", "3 components", "1"}));
  const auto broken = [&](const std::string& data, const std::string& more = "") {
    return message(
        vtu(ascii_points, "<DataArray type=\"Float32\" Name=\"T\" format=\"binary\">" + data + "</DataArray>", more));
  };
  EXPECT_TRUE(says(broken("CAAAAAAAlkM="), {"'a.vtu'", "array 'T'", "cut short"}));
  EXPECT_TRUE(says(broken("DAAAAAAAlkMAAMhD"), {"array 'T'", "12", "8"}));
  EXPECT_TRUE(says(broken("C?AAAAAAlkMAAMhD"), {"array 'T'", "'?'", "base64"}));
  const std::string zlib = "compressor=\"vtkZLibDataCompressor\"";
  EXPECT_TRUE(says(broken("/////wgAAAAIAAAA", zlib), {"array 'T'", "cut short"})) << "blocks that are not there";
  EXPECT_TRUE(says(broken("AQAAAAgAAAAAAAAACAAAAAECAwQFBgcI", zlib), {"array 'T'", "damaged"}));
  std::string many = vtu(ascii_points, "<DataArray type=\"Float32\" Name=\"T\" format=\"binary\">CAAAAA==</DataArray>");
  many.replace(many.find("NumberOfPoints=\"2\""), 18, "NumberOfPoints=\"4000000000\"");
  EXPECT_FALSE(message(many).empty()) << "nothing is allocated for points that are not there";
}

}  // namespace
}  // namespace creepcontact::io
