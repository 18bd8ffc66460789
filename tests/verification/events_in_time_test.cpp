/// Pulses, windows, ramps and vibrations in every place that takes a function, against the integral of the creep rate
/// or a run that is told their times. None of them is announced.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "creepcontact/base/function.hpp"
#include "verification/cube.hpp"

namespace creepcontact::test {
namespace {

constexpr double end = 1000, A = 1e-14, n = 4, tolerance = 1e-4;

/// A factor of about 1 as an expression in t, and the times between which it is smooth.
struct Event {
  std::string factor;
  std::vector<double> times;
  int pieces = 400;  ///< of the integral between two times, each by Simpson's rule

  double operator()(double t) const {
    static const std::vector<std::string> variables{"t"};
    return Function::expression(factor, variables)({.t = t});
  }
};

/// Of the rate over the run, for a rate that is a function of the factor.
double integral(const Event& event, const std::function<double(double)>& rate) {
  const Function f = Function::expression(event.factor, {"t"});
  std::vector<double> times{0};
  times.insert(times.end(), event.times.begin(), event.times.end());
  times.push_back(end);
  double sum = 0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double h = (times[i] - times[i - 1]) / event.pieces, inside = 1e-9 * h;
    for (int k = 0; k < event.pieces; ++k) {
      const double begin = times[i - 1] + h * k;
      const auto at = [&](double t) { return rate(f({.t = t})); };
      sum += h / 6 * (at(begin + inside) + 4 * at(begin + h / 2) + at(begin + h - inside));
    }
  }
  return sum;
}

std::vector<Event> random_events(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const double from = 100 + 700 * uniform(random), width = 0.5 * std::pow(100, uniform(random));
  const double high = 1.5 + uniform(random), slow = 10 + 90 * uniform(random);
  std::vector<Event> events;
  events.push_back({fmt::format("(t > {} && t < {} ? {} : 1)", from, from + width, high), {from, from + width}});
  events.push_back({fmt::format("(1 + {}*exp(-((t - {})/{})^2))", high, from, width),
                    {from - 4 * width, from - width, from, from + width, from + 4 * width}});
  events.push_back(
      {fmt::format("(1 + min(max((t - {})/{}, 0), 1) - min(max((t - {})/7, 0), 1))", from, width, from + 60),
       {from, from + width, from + 60, from + 67}});
  const int periods = 150 + static_cast<int>(400 * uniform(random));
  events.push_back({fmt::format("(1 + 0.3*sin(2*pi*t*{}/1000))", periods), {}, 40 * periods});
  std::vector<double> corners;
  for (double t = slow; t < end; t += slow) corners.push_back(t);
  events.push_back({fmt::format("(1 + 0.4*mod(t, {0})/{0})", slow), corners});
  return events;
}

std::string time_keys(const std::string& more = "") {
  return fmt::format("end = {}\noutput = [{}]\ntolerance = {}\n", end, end, tolerance) + more;
}

std::string norton(const std::string& factor = "1e-14") {
  return creep_law_table("norton", "A = " + factor + "\nn = 4");
}

/// A place of a function, as material and loading of the cube.
struct Place {
  std::string name, material, loading;
};

std::vector<Place> places(const std::string& f) {
  const std::string steady = pulled("100");
  std::string forces;
  for (const char* corner : {"100, 0, 0", "100, 100, 0", "100, 0, 100", "100, 100, 100"})
    forces += fmt::format("\n[[loads]]\nat = [{}]\nforce = [\"2.5e5*{}\", 0, 0]\n", corner, f);
  return {
      {"pressure", norton(), fmt::format("\n[[loads]]\non = \"x1\"\npressure = \"-100*{}\"\n", f)},
      {"traction", norton(), pulled(fmt::format("\"100*{}\"", f))},
      {"force", norton(), forces},
      {"rate", creep_law_table("expression", fmt::format("rate = \"1e-14*q^4*{}^4\"", f)), steady},
      {"temperature", norton("\"1e-14*(T/500)^4\""), steady + fmt::format("[temperature]\nvalue = \"500*{}\"\n", f)}};
}

/// @param first, stride  which places
void expect_integral(const Event& event, const std::string& time, std::size_t first, std::size_t stride = 1) {
  const double exact = integral(event, [](double factor) { return A * std::pow(100 * factor, n); });
  const std::vector<Place> all = places(event.factor);
  for (std::size_t i = first % all.size(); i < all.size(); i += stride) {
    const Outcome outcome = run_cube(all[i].material, all[i].loading, time);
    EXPECT_RELATIVE(outcome.history.at("cxx", end), exact, 5 * tolerance) << all[i].name << ": " << event.factor;
  }
}

TEST(EventsInTime, AreSeenInEveryPlace) {
  std::size_t first = 0;
  for (const unsigned seed : {1U, 2U, 3U})
    for (const Event& event : random_events(seed)) expect_integral(event, time_keys(), first++ % 5, 5);
}

TEST(EventsInTime, AreSeenByEveryIntegrator) {
  const Event window{"(t > 400.1 && t < 402.3 ? 2 : 1)", {400.1, 402.3}};
  const Event pulse{"(1 + exp(-((t - 611)/2)^2))", {600, 609, 611, 613, 622}};
  for (const Event& event : {window, pulse}) {
    const double exact = integral(event, [](double factor) { return A * std::pow(100 * factor, n); });
    for (const char* integrator : {"log_adams", "cvode_bdf", "cvode_adams", "arkode_dirk", "arkode_erk"}) {
      const std::string keys = time_keys(fmt::format("integrator = \"{}\"\n", integrator));
      const std::string rate = creep_law_table("expression", fmt::format("rate = \"1e-14*q^4*{}^4\"", event.factor));
      EXPECT_RELATIVE(run_cube(rate, pulled("100"), keys).history.at("cxx", end), exact, 2e-3) << integrator;
    }
  }
}

/// The error of a run that starts anew 400 times is that of one with few restarts (docs/integrators.md).
TEST(EventsInTime, ErrorsOfManyRestartsDoNotAddUp) {
  const double exact = A * (std::pow(200, 5) - std::pow(100, 5)) / 500 * 200;
  const std::string triangles = pulled("{ t = [0, 0.5, 1], values = [100, 200, 100], period = 1 }");
  for (const auto& [integrator, tolerances] : std::vector<std::pair<std::string, double>>{
           {"auto", 1}, {"cvode_bdf", 4.3}, {"cvode_adams", 2}, {"arkode_dirk", 1}}) {
    const Outcome outcome =
        run_cube(norton(), triangles,
                 fmt::format("end = 200\noutput = [200]\ntolerance = 1e-4\nintegrator = \"{}\"\n", integrator));
    EXPECT_RELATIVE(outcome.history.at("cxx", 200), exact, tolerances * 1e-4) << integrator;
  }
}

/// With time.cycle: what happens in one cycle alone, and what happens in all of them.
TEST(EventsInTime, AreSeenInCycles) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (std::size_t run = 0; run < 3; ++run) {
    const double from = 30 + 900 * uniform(random), width = 0.2 + 4 * uniform(random);
    const std::string once = fmt::format("(t > {} && t < {} ? 1.8 : 1)", from, from + width);
    std::vector<double> times{from, from + width};
    expect_integral({once, times}, time_keys("cycle = 10\n"), run, 5);
    for (int k = 0; k < 100; ++k)
      for (const double corner : {0., 2., 5., 6.}) times.push_back(10 * k + corner);
    std::ranges::sort(times);
    const std::string pulses = "min(1, min(mod(t, 10)/2, max(0, 6 - mod(t, 10))))";
    expect_integral({fmt::format("({}*(0.5 + 0.5*{}))", once, pulses), times, 10}, time_keys("cycle = 10\n"), run + 3,
                    5);
  }
}

/// Each cycle leaves an error, mostly of one sign.
TEST(EventsInTime, ErrorsOfManyCyclesDoNotAddUp) {
  const std::string rate = creep_law_table("expression", "rate = \"1e-8*q*(1 + 0.2*sin(2*pi*t/5))\"");
  const Outcome outcome = run_cube(rate, pulled("100"), time_keys("cycle = 5\n"));
  EXPECT_RELATIVE(outcome.history.at("cxx", end), 1e-8 * 100 * end, 2 * tolerance);
}

/// The temperature passes the points of a table: a peak over 2 of 100 degrees.
TEST(EventsInTime, PointsOfTablesInTheTemperature) {
  const std::string table = "{ T = [500, 549, 550, 551, 600], values = [1e-15, 1e-15, 1e-12, 1e-15, 1e-15] }";
  const auto rate = [](double T) { return 1e-15 + (1e-12 - 1e-15) * std::max(0.0, 1 - std::abs(T - 550)); };
  const std::string held = support("x1", "x", "0.05");
  for (const Event& field : std::vector<Event>{
           {"500 + t/10", {490, 500, 510}},
           {"600 - 100*(t/1000)^2", {1000 * std::sqrt(0.49), 1000 * std::sqrt(0.5), 1000 * std::sqrt(0.51)}},
           // It turns back so often that steps do not stop at its turns.
           {"550 + 50*sin(2*pi*t*70.3/1000)", {}, 1000000}}) {
    const double total = integral(field, rate);
    const Outcome outcome =
        run_cube(norton(table), held + "\n[temperature]\nvalue = \"" + field.factor + "\"\n", time_keys());
    // d(sigma)/dt = -E A sigma^n
    const double exact = std::pow(std::pow(100, -3) + 3 * 2e5 * total, -1.0 / 3);
    EXPECT_RELATIVE(outcome.history.at("sxx", end), exact, 3 * tolerance) << field.factor;
  }
  // In a field with a gradient the places pass the peak one after the other.
  const std::string gradient = pulled("100") + "\n[temperature]\nvalue = \"501 + 0.09*t + 0.02*(x - 50)\"\n";
  const auto strain = [&](double accuracy) {
    const std::string time = fmt::format("end = 1000\noutput = [1000]\ntolerance = {}\n", accuracy);
    return run_cube(norton(table), gradient, time).history.at("cxx", end);
  };
  EXPECT_RELATIVE(strain(tolerance), strain(1e-6), 5 * tolerance);
}

TEST(EventsInTime, ExpressionsInTheTemperature) {
  const std::string held = "\n[temperature]\nvalue = \"500 + t/10\"\n";
  const Outcome jump =
      run_cube(norton("\"(T > 540 && T < 540.3) ? 1e-11 : 1e-15\""), pulled("100") + held, time_keys());
  EXPECT_RELATIVE(jump.history.at("cxx", end), 1e8 * (1e-15 * 997 + 1e-11 * 3), 3 * tolerance);
  const Outcome peak = run_cube(norton("\"1e-15 + 1e-11*exp(-((T - 560)/0.1)^2)\""), pulled("100") + held, time_keys());
  EXPECT_RELATIVE(peak.history.at("cxx", end), 1e8 * (1e-12 + 1e-11 * std::sqrt(std::numbers::pi)), 3 * tolerance);
}

/// Displacements and gaps change the stress, which relaxes in between: against runs that are told the times.
TEST(EventsInTime, OfDisplacementsAndGaps) {
  const std::string blocks = R"(
    [mesh]
    file = "case.geo"
    order = 1
    [bodies.low]
    region = "low"
    material = "steel"
    [bodies.high]
    region = "high"
    material = "steel"
    [materials.steel]
    young_modulus = 200e3
    poisson_ratio = 0.3
    [[materials.steel.creep]]
    law = "norton"
    A = 1e-14
    n = 4
    [[probes]]
    name = "szz"
    quantity = "stress_zz"
    body = "low"
  )" + support("low_z0", "z") +
                             support("high_z1", "z") + support("low_x0", "x") + support("low_y0", "y") +
                             support("high_x0", "x") + support("high_y0", "y");
  const std::string geo =
      boxes_geo({{"low", {0, 0, 0}, {1, 1, 1}, {1, 1, 2}}, {"high", {0, 0, 1}, {1, 1, 1}, {1, 1, 2}}});
  for (const Event& event : random_events(3)) {
    if (event.times.empty() || event.times.size() > 4) continue;
    const std::string told = fmt::format("breakpoints = [{}]\ntolerance = 1e-6\n", fmt::join(event.times, ", "));
    const std::string times = fmt::format("end = {}\noutput = [500, {}]\n", end, end);
    const std::string unannounced = fmt::format("tolerance = {}\n", tolerance);
    const std::string held = support("x1", "x", fmt::format("\"0.05*{}\"", event.factor));
    const double exact = run_cube(norton(), held, times + told).history.at("sxx", end);
    const double found = run_cube(norton(), held, times + unannounced).history.at("sxx", end);
    EXPECT_NEAR(found, exact, 5 * tolerance * 100) << event.factor;
    const std::string contact =
        blocks + contact_table("low_z1", "high_z0", fmt::format("gap = \"-1e-3*{}\"", event.factor));
    const double pressed = run_case(contact + "[time]\n" + times + told, geo).history.at("szz", end);
    EXPECT_NEAR(run_case(contact + "[time]\n" + times + unannounced, geo).history.at("szz", end), pressed,
                5 * tolerance * 100)
        << event.factor;
  }
}

/// Thousands of periods that nobody announces: equal steps through them.
TEST(EventsInTime, ThousandsOfPeriods) {
  const Outcome outcome = run_cube(norton(), pulled("\"100 + 50*sin(2*pi*t*2333/1000)\""), time_keys());
  EXPECT_RELATIVE(outcome.history.at("cxx", end), 1.7734375e-3, tolerance);
  EXPECT_LT(outcome.steps.rows(), 100000U);
}

/// A pulse of temperature in one of five blocks, and a hot spot that moves along them.
TEST(EventsInTime, InOneOfSeveralBodies) {
  std::vector<Box> boxes;
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 1\n";
  for (int b = 0; b < 5; ++b) {
    const std::string name = fmt::format("b{}", b);
    boxes.push_back({name, {20.0 * b, 0, 0}, {10, 10, 10}, {1, 1, 2}});
    toml += fmt::format("[bodies.{0}]\nregion = \"{0}\"\nmaterial = \"steel\"\n", name);
  }
  toml += "[materials.steel]\nyoung_modulus = 200e3\npoisson_ratio = 0.3\n" +
          creep_law_table("norton", "A = \"1e-15*exp(0.03*(T - 500))\"\nn = 4");
  for (int b = 0; b < 5; ++b) {
    const std::string name = fmt::format("b{}", b);
    toml += support(name + "_x0", "x") + support(name + "_y0", "y") + support(name + "_z0", "z") +
            fmt::format("[[loads]]\non = \"{}_z1\"\ntraction = [0, 0, 100]\n", name) +
            fmt::format("[[probes]]\nname = \"e{0}\"\nquantity = \"creep_strain_zz\"\nbody = \"b{0}\"\n", b);
  }
  const auto strain = [&](const std::string& temperature, int body) {
    return run_case(toml + "[temperature]\nvalue = \"" + temperature + "\"\n[time]\n" + time_keys(), boxes_geo(boxes))
        .history.at(fmt::format("e{}", body), end);
  };
  EXPECT_RELATIVE(strain("(x > 35 && x < 55 && t > 401.7 && t < 405.7) ? 700 : 500", 2),
                  1e8 * 1e-15 * (996 + 4 * std::exp(6.0)), 3 * tolerance);
  // Uniform in each body: exp(-s^2) of the temperature over the time.
  const std::string moving = "500 + 200*exp(-((floor(x/20) - t/200 + 0.5)/0.02)^2)";
  double integral = 0;
  for (int i = 0; i < 100000; ++i) {
    const double s = (i + 0.5) / 100000 * 5 - 3.5;  // of the fourth body
    integral += 1e-15 * std::exp(6 * std::exp(-s * s / 4e-4)) / 100;
  }
  EXPECT_NEAR(strain(moving, 3), 1e8 * integral, 10 * tolerance * 100 / 200e3) << "the elastic strain is the measure";
}

/// Nothing creeps; friction is lost for a while, and the shear does not come back.
TEST(EventsInTime, FrictionOfTimeInAnElasticModel) {
  const std::string toml = std::string(R"(
    analysis = "plane_strain"
    [mesh]
    file = "case.geo"
    [bodies.low]
    region = "low"
    material = "steel"
    [bodies.high]
    region = "high"
    material = "steel"
    [materials.steel]
    young_modulus = 2.1e5
    poisson_ratio = 0.3
    [time]
    end = 100
    output = [10, 49, 51, 100]
    [[probes]]
    name = "fx"
    quantity = "contact_force_x"
    on = "high_0"
    [[probes]]
    name = "fy"
    quantity = "contact_force_y"
    on = "high_0"
    [[supports]]
    on = "low_0"
    displacement = { x = 0, y = 0 }
    [[supports]]
    on = "high_1"
    displacement = { x = "1e-3*min(t, 10)/10", y = -0.01 }
  )") + contact_table("low_1", "high_0", "friction = \"(t > 40 && t < 41.3 ? 0.001 : 0.5)\"");
  const std::string geo = R"(
    SetFactory("OpenCASCADE");
    Rectangle(1) = {0, 0, 0, 10, 10}; Rectangle(2) = {0, 10, 0, 10, 10};
    Transfinite Curve{1, 2, 3, 4} = 5; Transfinite Curve{5, 6, 7, 8} = 6;
    Transfinite Surface{1, 2}; Recombine Surface{1, 2};
    Physical Surface("low") = {1}; Physical Surface("high") = {2};
    Physical Curve("low_0") = {1}; Physical Curve("low_1") = {3};
    Physical Curve("high_0") = {5}; Physical Curve("high_1") = {7};
  )";
  const Table history = run_case(toml, geo).history;
  EXPECT_RELATIVE(std::abs(history.at("fx", 100)), 0.001 * std::abs(history.at("fy", 100)), 1e-4);
  EXPECT_GT(std::abs(history.at("fx", 10)), 10 * std::abs(history.at("fx", 100)));
}

/// A fit that creeps for a while, as a run that is told when.
TEST(EventsInTime, AFitThatCreepsForATime) {
  const std::string toml = std::string(R"(
    analysis = "axisymmetric"
    [mesh]
    file = "case.geo"
    [bodies.shaft]
    region = "shaft"
    material = "elastic"
    [bodies.hub]
    region = "hub"
    material = "creeping"
    [materials.elastic]
    young_modulus = 2e5
    poisson_ratio = 0.3
    [materials.creeping]
    young_modulus = 2e5
    poisson_ratio = 0.3
    [[materials.creeping.creep]]
    law = "expression"
    rate = "t > 200 && t < 600 ? 1e-15*q^5 : 0"
    [[supports]]
    on = "bottom"
    displacement = { y = 0 }
    [[probes]]
    name = "p"
    quantity = "contact_pressure"
    on = "hub_bore"
  )") + contact_table("shaft_outer", "hub_bore", "gap = -0.066666666666667") +
                           "[time]\nend = 1000\noutput = [10, 1000]\n";
  const std::string geo = R"(
    SetFactory("OpenCASCADE");
    Rectangle(1) = {0, 0, 0, 50, 10}; Rectangle(2) = {50, 0, 0, 50, 10};
    Transfinite Curve{1, 3} = 9; Transfinite Curve{2, 4} = 3; Transfinite Curve{5, 7} = 12; Transfinite Curve{6, 8} = 4;
    Transfinite Surface{1, 2}; Recombine Surface{1, 2};
    Physical Surface("shaft") = {1}; Physical Surface("hub") = {2};
    Physical Curve("shaft_outer") = {2}; Physical Curve("hub_bore") = {8}; Physical Curve("bottom") = {1, 5};
  )";
  const double told = run_case(toml + "breakpoints = [200, 600]\ntolerance = 1e-6\n", geo).history.at("p", 1000);
  EXPECT_RELATIVE(told, 33.825, 1e-3);
  for (const char* integrator : {"auto", "cvode_bdf", "cvode_adams"}) {
    const Outcome outcome = run_case(toml + fmt::format("integrator = \"{}\"\n", integrator), geo);
    EXPECT_RELATIVE(outcome.history.at("p", 1000), told, 3e-3) << integrator;
  }
}

}  // namespace
}  // namespace creepcontact::test
