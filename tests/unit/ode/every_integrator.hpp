#pragma once
/// Tests that every registered integrator has to pass, named after it.

#include <gtest/gtest.h>

#include "systems.hpp"

namespace creepcontact::ode {

class EveryIntegrator : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Integrator> make(System& system, double tolerance = 1e-5) const {
    return make_integrator(GetParam(), system, accurate_options(GetParam(), tolerance));
  }
  static bool is_euler(const std::string& name) { return name.ends_with("_euler"); }
};

inline std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const IntegratorInfo& info : integrators()) names.push_back(info.name);
  return names;
}

inline std::string test_name(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}

}  // namespace creepcontact::ode
