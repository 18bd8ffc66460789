/// The same temperatures from every kind of file give the results of the expression.
#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/io/fields/field_writer.hpp"
#include "creepcontact/model/temperature.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

/// Linear in the place: all interpolations give it exactly.
double linear_field(const Vector3& x) {
  return 50 + 10 * x[0] - 5 * x[1] + 30 * x[2];
}

/// A grid of points around the blocks.
std::vector<Vector3> grid() {
  std::vector<Vector3> points;
  for (const double x : {0.0, 1.0, 2.0})
    for (const double y : {0.0, 1.0})
      for (const double z : {-2.0, -1.0, 0.0, 1.0}) points.emplace_back(x, y, z);
  return points;
}

using Field = std::function<double(const Vector3&)>;

std::string csv_of(const std::string& header, const Field& field) {
  std::string text = header + "\n";
  for (const Vector3& x : grid()) text += fmt::format("{},{},{},{}\n", x[0], x[1], x[2], field(x));
  return text;
}

std::string frd_of(const Field& at_0, const Field& at_4) {
  std::string text = fmt::format("    1C\n    2C{:>30}{:>38}\n", grid().size(), 1);
  int node = 0;
  for (const Vector3& x : grid()) text += fmt::format(" -1{:>10}{:12.5E}{:12.5E}{:12.5E}\n", ++node, x[0], x[1], x[2]);
  text += " -3\n";
  for (const auto& [time, field] : std::vector<std::pair<double, Field>>{{0.0, at_0}, {4.0, at_4}}) {
    text +=
        fmt::format("  100CL  101{:12.9f}{:>12}{:>20}{:>2}{:>5}{:>10}{:>2}\n", time, grid().size(), "", 0, 1, "", 1);
    text += " -4  NDTEMP      1    1\n -5  T           1    1    0    0\n";
    node = 0;
    for (const Vector3& x : grid()) text += fmt::format(" -1{:>10}{:12.5E}\n", ++node, field(x));
    text += " -3\n";
  }
  return text + " 9999\n";
}

class TemperatureFormats : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    return io::test::write_text(blocks_ / name, text).filename().string();
  }

  /// A configuration with the temperature of these keys; the blocks expand and creep by it.
  config::Config config(const std::string& keys) {
    return blocks_.config(pressure_probe + "[temperature]\n" + keys + "\n",
                          {"materials.soft.thermal_expansion=1e-5", "materials.soft.reference_temperature=20",
                           "materials.hard.creep.0.A='1e-3*(1+T/100)'", "time.output=[1, 2]", "output.fields=false"});
  }

  /// Largest difference of two temperatures over all points at these times.
  double difference(const std::string& keys, const std::string& value, const std::vector<double>& times) {
    const Model found = build_model(config(keys)), expected = build_model(config("value = \"" + value + "\""));
    double largest = 0;
    for (std::size_t b = 0; b < found.bodies().size(); ++b)
      for (const double t : times) {
        const std::vector<double> have = found.bodies()[b].at(t).temperature,
                                  want = expected.bodies()[b].at(t).temperature;
        for (std::size_t p = 0; p < have.size(); ++p) largest = std::max(largest, std::abs(have[p] - want[p]));
      }
    return largest;
  }

  std::string message(const std::string& keys) {
    return message_of<Error>([&] { build_model(config(keys)); });
  }

  Case blocks_;
};

const std::string expression = "50 + 10*x - 5*y + 30*z";

TEST_F(TemperatureFormats, GiveTheResultsOfTheExpression) {
  write("units.csv", csv_of("X [mm],Y [mm],Z [mm],Temperature [C]", linear_field));
  write("named.csv", csv_of("a,b,c,d", linear_field));
  write("steps.frd", frd_of(linear_field, linear_field));
  io::FieldMesh mesh;
  std::vector<double> values;
  for (const Vector3& x : grid()) {
    mesh.points.push_back(x);
    values.push_back(linear_field(x));
  }
  io::FieldWriter(blocks_ / ".", "T", mesh, "").write(0, {{"temperature [degC]", 1, values}}, {});
  const auto history = [&](const std::string& keys) {
    const std::filesystem::path out = blocks_ / "out";
    const Summary result = run(config(keys), {.output = out.string()});
    EXPECT_EQ(result.exit_status, 0) << result.message;
    return Table(out / "history.csv").column("pressure");
  };
  const std::vector<double> expected = history("value = \"" + expression + "\"");
  EXPECT_LT(expected.back(), 0.9 * expected.front());
  for (const char* keys :
       {"file = 'units.csv'", "file = 'named.csv'\ncolumns = { x = 'a', y = 'b', z = 'c', T = 'd' }",
        "file = 'steps.frd'", "file = 'T/T_0000.vtu'", "file = ['units.csv', 'units.csv']\ntimes = [0, 4]"}) {
    const std::vector<double> found = history(keys);
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9) << keys;
  }
}

TEST_F(TemperatureFormats, OneFilePerTime) {
  const auto hotter = [](const Vector3& x) { return linear_field(x) + 100; };
  write("t_0.csv", csv_of("x,y,z,T", linear_field));
  write("t_02.0.csv", csv_of("x,y,z,T", hotter));
  const std::string rising = expression + " + 50*min(t, 2)";
  EXPECT_LT(difference("file = 't_*.csv'", rising, {0, 1, 2, 3}), 1e-9);
  EXPECT_LT(difference("file = ['t_0.csv', 't_02.0.csv']\ntimes = [0, 2]", rising, {0, 1, 2, 3}), 1e-9);
  write("a.frd", frd_of(linear_field, hotter));
  EXPECT_LT(difference("file = 'a.frd'", expression + " + 25*t", {0, 1, 4}), 1e-9);
  EXPECT_EQ(build_model(config("file = 't_*.csv'")).breakpoints, (std::vector<double>{2}));
}

TEST_F(TemperatureFormats, RepeatWithAPeriod) {
  const auto hotter = [](const Vector3& x) { return linear_field(x) + 100; };
  write("t_0.csv", csv_of("x,y,z,T", linear_field));
  write("t_1.csv", csv_of("x,y,z,T", hotter));
  // Up to 1, constant to 1.5, then anew.
  const std::string keys = "file = 't_*.csv'\nperiod = 1.5";
  EXPECT_LT(difference(keys, expression + " + 100*min(mod(t, 1.5), 1)", {0, 0.5, 1.2, 1.5, 2, 3.25, 3.9}), 1e-9);
  EXPECT_EQ(build_model(config(keys)).breakpoints, (std::vector<double>{1, 1.5, 2.5, 3}));
  EXPECT_NE(build_model(config(keys)).temperature->text(), build_model(config("file = 't_*.csv'")).temperature->text());
  EXPECT_TRUE(says(message("file = 't_*.csv'\nperiod = 0.5"), {"temperature: ", "period = 0.5: ", "point 1", "0.5"}));
  write("u_1.csv", csv_of("x,y,z,T", hotter));
  EXPECT_TRUE(says(message("file = 'u_*.csv'\nperiod = 2"), {"temperature: ", "period = 2: ", "t = 0"}));
}

/// In the section (r, z) linear: not linear in the place, and yet exact.
TEST_F(TemperatureFormats, OfASectionAreRevolved) {
  std::string by_radius = "R [mm],Z [mm],T\n", by_x = "x,y,T\n";
  for (const double r : {0.0, 1.0, 2.0, 4.0})
    for (const double z : {-3.0, -1.0, 1.0, 3.0}) {
      by_radius += fmt::format("{},{},{}\n", r, z, 20 * r + 7 * z);
      by_x += fmt::format("{},{},{}\n", r, z, 20 * r + 7 * z);
    }
  write("rz.csv", by_radius);
  write("xy.csv", by_x);
  EXPECT_LT(difference("file = 'rz.csv'", "20*sqrt(x*x + y*y) + 7*z", {0}), 1e-9);
  EXPECT_LT(difference("file = 'rz.csv'\naxis = [-2, 0, 0]\norigin = [1, 0.5, 0]",
                       "20*sqrt((y - 0.5)^2 + z*z) + 7*(1 - x)", {0}),
            1e-9);
  EXPECT_LT(difference("file = 'xy.csv'\naxis = [0, 0, 1]", "20*sqrt(x*x + y*y) + 7*z", {0}), 1e-9);
  EXPECT_TRUE(says(message("file = 'xy.csv'"), {"xy.csv'", "columns = { z = ", "'axis'"}));
  write("solid.csv", csv_of("x,y,z,T", linear_field));
  EXPECT_TRUE(says(message("file = 'solid.csv'\naxis = [0, 0, 1]"), {"solid.csv'", "(", "z = 0"}));
  write("negative.csv", "r,z,T\n-1,0,1\n1,0,2\n");
  EXPECT_TRUE(says(message("file = 'negative.csv'"), {"negative.csv'", "radius -1"}));
}

TEST_F(TemperatureFormats, MistakesInTheKeys) {
  EXPECT_TRUE(says(message("value = 1\nperiod = 2"), {"temperature.period: ", "'file'"}));
  EXPECT_TRUE(says(message("file = ['a.csv', 'b.csv']\ntimes = [0]"), {"temperature.times: ", "1", "2", "'file'"}));
  EXPECT_TRUE(
      says(message("file = ['a.csv', 'b.csv']\ntimes = [2, 1]"), {"temperature.times: ", "1", "2", "increase"}));
  EXPECT_TRUE(says(message("file = ['a_*.csv', 'b.csv']"), {"temperature.file: ", "'*'"}));
  EXPECT_TRUE(says(message("file = 'a_*.csv'\ntimes = [1]"), {"temperature.times: ", "pattern"}));
  EXPECT_TRUE(says(message("file = 'a.csv'\naxis = [0, 0, 0]"), {"temperature.axis: ", "[0, 0, 0]"}));
  EXPECT_TRUE(says(message("file = 'a.csv'\ncolumns = { q = 'b' }"), {"temperature.columns.q: ", "unknown"}));
  EXPECT_TRUE(says(message("file = []"), {"temperature.file: ", "empty"}));
}

TEST_F(TemperatureFormats, PlacesOutsideAreCounted) {
  // In metres instead of millimetres, of which the blocks are.
  std::string text = "x,y,z,T\n";
  for (const Vector3& x : grid()) text += fmt::format("{},{},{},{}\n", x[0] / 1000, x[1] / 1000, x[2] / 1000, 400);
  write("m.csv", text);
  testing::internal::CaptureStderr();
  build_model(config("file = 'm.csv'"));
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(says(said, {"m.csv'", "of 81 nodes", "of 36 in 'lower'", "(0.002, 0.001, -0.002)"}));
}

}  // namespace
}  // namespace creepcontact::run::test
