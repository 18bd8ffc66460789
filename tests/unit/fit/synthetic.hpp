#pragma once
/// Data that a law would give, with scatter.

#include <random>
#include <string>
#include <vector>

#include "creepcontact/fit/test_data.hpp"
#include "creepcontact/material/registry.hpp"

namespace creepcontact::fit {

/// Normal numbers, the same on all platforms.
class Noise {
 public:
  explicit Noise(int seed) : generator_(static_cast<std::uint64_t>(seed) + 1) {}
  double operator()();

 private:
  double uniform() { return (static_cast<double>(generator_() >> 11U) + 0.5) * 0x1p-53; }
  std::mt19937_64 generator_;
};

struct SyntheticTest {
  TestKind kind = TestKind::creep;
  double stress = 0, temperature = 20;
  std::vector<double> times = {};  ///< of a creep or relaxation test
};

/// A law of this name; optional keys that are not given have their fallbacks.
std::shared_ptr<const material::CreepLaw> law_of(const std::string& name, material::ParameterValues values);

/// @param scatter  standard deviation of the factor on each reading
TestData synthetic(const std::shared_ptr<const material::CreepLaw>& law, const std::vector<SyntheticTest>& tests,
                   double scatter, int seed, double young_modulus = 1.5e5);

/// n times from first to last in equal ratios
std::vector<double> log_times(double first, double last, int n);

}  // namespace creepcontact::fit
