#include "synthetic.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "creepcontact/material/bar.hpp"

namespace creepcontact::fit {

double Noise::operator()() {
  return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform());
}

std::shared_ptr<const material::CreepLaw> law_of(const std::string& name, material::ParameterValues values) {
  const auto& keys = material::find_creep_law(name)->parameters;
  for (std::size_t i = values.size(); i < keys.size(); ++i) values.push_back(keys[i].fallback.value());
  return material::find_creep_law(name)->make(std::move(values));
}

TestData synthetic(const std::shared_ptr<const material::CreepLaw>& law, const std::vector<SyntheticTest>& tests,
                   double scatter, int seed, double young_modulus) {
  Noise noise(seed);
  TestData data{.file = "synthetic", .units = {}, .has_temperature = true, .tests = {}, .notes = {}};
  for (const SyntheticTest& wanted : tests) {
    Test test{.name = "test", .kind = wanted.kind, .stress = wanted.stress, .temperature = wanted.temperature};
    material::BarTest bar{.stress = wanted.stress, .temperature = wanted.temperature};
    if (wanted.kind == TestKind::relaxation) bar.young_modulus = young_modulus;
    std::vector<double> times = wanted.times;
    if (wanted.kind == TestKind::rupture) times = {1e-3, 1e12};
    const material::BarHistory history = material::bar_history({&law, 1}, bar, times, 1e-8);
    const auto add = [&](double time, double value) {
      test.readings.push_back({time, value * (1 + scatter * noise()), 0});
    };
    if (wanted.kind == TestKind::rupture)
      add(0, history.rupture.value());
    else if (wanted.kind == TestKind::rate)
      add(std::numeric_limits<double>::quiet_NaN(), material::initial_rate({&law, 1}, bar));
    else
      for (std::size_t i = 0; i < history.states.size(); ++i)
        add(times[i], wanted.kind == TestKind::creep ? history.states[i].creep_strain : history.states[i].stress);
    if (wanted.kind == TestKind::creep)
      for (const Reading& reading : test.readings) test.floor = std::max(test.floor, 1e-3 * reading.value);
    data.tests.push_back(test);
  }
  return data;
}

std::vector<double> log_times(double first, double last, int n) {
  std::vector<double> times;
  for (int i = 0; i < n; ++i) times.push_back(first * std::pow(last / first, i / (n - 1.0)));
  return times;
}

}  // namespace creepcontact::fit
