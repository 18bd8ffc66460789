/// Creep in a temperature that varies through a wall, given as an expression and as a file of points; a hot spot; loads
/// that repeat.
#include <fmt/format.h>

#include "boxes.hpp"
#include "case.hpp"
#include "reference/hot_cylinder.hpp"
#include "rings.hpp"

namespace creepcontact::test {
namespace temperature_tests {
namespace {

constexpr double E = 1.6e5, nu = 0.3, n = 5, alpha = 1.2e-5, pressure = 50, inner = 100, outer = 200;
const std::vector<double> times{1, 10, 100, 1e3, 1e4};

double temperature(double r) {
  return 500 + 100 * std::log(outer / r) / std::log(2.0);
}
double creep_coefficient(double T) {
  return 1e-15 * std::exp(0.02 * (T - 500));
}

/// The temperature at points of the quarter, in 24 layers through the wall.
std::string csv() {
  std::string text = "x,y,z,T\n";
  for (int i = 0; i <= 24; ++i)
    for (int j = 0; j <= 20; ++j)
      for (const double z : {0.0, 5.0}) {
        const double r = inner + (outer - inner) * i / 24, angle = 0.5 * 3.14159265358979 * j / 20;
        text +=
            fmt::format("{:.12g},{:.12g},{},{:.12g}\n", r * std::cos(angle), r * std::sin(angle), z, temperature(r));
      }
  return text;
}

/// Stress theta and z at the radii, as probes theta0, z0, ...
Outcome run_pipe(const std::string& temperature_key, const std::vector<double>& radii) {
  const RingMesh mesh{"pipe", inner, outer, 16, 18, 1.03};
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n" + body("pipe", E, nu, 1, n) +
                     ring_supports({mesh}, true) +
                     fmt::format("[[loads]]\non = \"pipe_inner\"\npressure = {}\n", pressure) + "[temperature]\n" +
                     temperature_key + "[time]\nend = 1e4\ntolerance = 1e-5\noutput = [1, 10, 100, 1e3, 1e4]\n";
  for (std::size_t i = 0; i < radii.size(); ++i) {
    // On the ray in the middle of an element around.
    const double angle = 0.5 * 3.14159265358979 * 8.5 / 18;
    const std::string position =
        fmt::format("at = [{:.12g}, {:.12g}, 2.5]", radii[i] * std::cos(angle), radii[i] * std::sin(angle));
    toml += probe(fmt::format("theta{}", i), "stress_theta", position) +
            probe(fmt::format("z{}", i), "stress_zz", position) + probe(fmt::format("T{}", i), "temperature", position);
  }
  return run_case(toml, rings_geo({mesh}, 5),
                  {"materials.pipe.creep[0].A=1e-15*exp(0.02*(T - 500))", "materials.pipe.thermal_expansion=1.2e-5",
                   "materials.pipe.reference_temperature=500"},
                  {{"temperatures.csv", csv()}});
}

TEST(Temperature, RadialFieldInACreepingCylinder) {
  const reference::HotCylinderHistory history({inner, outer, pressure, E, nu, n,
                                               [](double r) { return creep_coefficient(temperature(r)); },
                                               [](double r) { return alpha * (temperature(r) - 500); }});
  const auto exact = history.stress(times);
  const std::vector<std::size_t> points{2, 5, 8, 12, 15};
  std::vector<double> radii;
  for (const std::size_t p : points) radii.push_back(history.radii()[p]);
  const Outcome given = run_pipe("value = \"500 + 100*ln(200/sqrt(x^2 + y^2))/ln(2)\"\n", radii);
  const Outcome read = run_pipe("file = \"temperatures.csv\"\n", radii);
  for (std::size_t k = 0; k < times.size(); ++k) {
    double largest = 0;
    for (const std::size_t p : points) largest = std::max(largest, exact[k][p].cwiseAbs().maxCoeff());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d& stress = exact[k][points[i]];
      const std::string theta = fmt::format("theta{}", i), z = fmt::format("z{}", i);
      EXPECT_NEAR(given.history.at(theta, times[k]), stress[1], 5e-3 * largest) << radii[i] << ' ' << times[k];
      EXPECT_NEAR(given.history.at(z, times[k]), stress[2], 5e-3 * largest) << radii[i] << ' ' << times[k];
      EXPECT_NEAR(read.history.at(theta, times[k]), given.history.at(theta, times[k]), 2e-3 * largest) << radii[i];
      EXPECT_NEAR(read.history.at(fmt::format("T{}", i), times[k]), temperature(radii[i]), 0.2);
    }
  }
}

/// NAFEMS T1 (The Standard NAFEMS Benchmarks, 1990): a square of 20 x 20 with a hot spot of radius 1 in its middle;
/// only the spot expands. In an infinite plate sigma_yy beside the spot is E alpha T/2.
TEST(Temperature, NafemsT1HotSpot) {
  const auto stress = [](const std::string& outline) {
    const std::string geo = "SetFactory(\"OpenCASCADE\");\n" + outline + R"geo(
      Disk(2) = {0, 0, 0, 1}; Rectangle(3) = {0, 0, 0, 10, 10};
      quarter[] = BooleanIntersection{ Surface{1}; Delete; }{ Surface{3}; };
      spot[] = BooleanIntersection{ Surface{2}; Delete; }{ Surface{3}; Delete; };
      BooleanFragments{ Surface{quarter[]}; Delete; }{ Surface{spot[]}; Delete; }
      spot[] = Surface In BoundingBox {-0.1, -0.1, -0.1, 1.1, 1.1, 0.1};
      plate[] = Surface{:}; plate[] -= {spot[]};
      Physical Surface("spot") = {spot[]}; Physical Surface("plate") = {plate[]};
      Physical Curve("x0") = Curve In BoundingBox {-0.1, -0.1, -0.1, 0.1, 11, 0.1};
      Physical Curve("y0") = Curve In BoundingBox {-0.1, -0.1, -0.1, 11, 0.1, 0.1};
      MeshSize{:} = 1; MeshSize{ PointsOf{ Surface{spot[]}; } } = 0.1;
    )geo";
    std::string toml = "analysis = \"plane_stress\"\n[mesh]\nfile = \"case.geo\"\norder = 2\nshare_nodes = \"tie\"\n";
    for (const std::string name : {"spot", "plate"})
      toml += body(name, 1e5, 0.3) +
              fmt::format("thermal_expansion = {}\nreference_temperature = 0\n", name == "spot" ? "1e-5" : "0");
    toml += support("x0", "x") + support("y0", "y") + "[temperature]\nvalue = 100\n[time]\nend = 0\n" +
            probe("D", "stress_yy", "at = [1, 0, 0]\nbody = \"plate\"");
    return run_case(toml, geo).history.at("D", 0);
  };
  EXPECT_RELATIVE(stress("Rectangle(1) = {-10, -10, 0, 20, 20};"), 50, 0.01) << "published, of an infinite plate";
  EXPECT_RELATIVE(stress("Disk(1) = {0, 0, 0, 10};"), 50 * (1 + 0.01), 2e-3) << "of a round plate";
}

/// Twenty starts and stops: a load from 0 to 100 within 1, held, and back from 24 to 25, every 50.
TEST(Temperature, StartsAndStopsFoundInAnExpression) {
  const double a = 1e-13;
  const auto run = [&](const std::string& value) {
    return run_case("[mesh]\nfile = \"case.geo\"\norder = 1\n" + body("bar", 2e5, 0.3, a, 4) + support("bar_x0", "x") +
                        support("bar_y0", "y") + support("bar_z0", "z") +
                        "[[loads]]\non = \"bar_z1\"\ntraction = [0, 0, " + value + "]\n[time]\nend = 1000\n" +
                        probe("creep", "creep_strain_zz", "body = \"bar\""),
                    boxes_geo({{"bar", {0, 0, 0}, {1, 1, 2}, {1, 1, 2}}}));
  };
  const Outcome found = run("\"100*max(0, min(min(mod(t, 50), 25 - mod(t, 50)), 1))\"");
  const Outcome given = run("{ t = [0, 1, 24, 25], values = [0, 100, 100, 0], period = 50 }");
  const double exact = 20 * a * 1e8 * (23 + 2.0 / 5);
  EXPECT_RELATIVE(given.history.at("creep", 1000), exact, 1e-3);
  EXPECT_RELATIVE(found.history.at("creep", 1000), given.history.at("creep", 1000), 1e-6);
  EXPECT_NEAR(found.summary.number("steps") / given.summary.number("steps"), 1, 0.1) << found.summary.number("steps");
  const std::vector<double> ends = found.steps.times();
  for (const double t : {1.0, 24.0, 25.0, 50.0, 51.0, 974.0, 975.0})
    EXPECT_EQ(std::count(ends.begin(), ends.end(), t), 1) << t;
}

}  // namespace
}  // namespace temperature_tests
}  // namespace creepcontact::test
