#pragma once
/// Tests that every registered integrator has to pass, named after it: also with other settings, see variants().

#include <gtest/gtest.h>

#include "systems.hpp"

namespace creepcontact::ode {

class EveryIntegrator : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Integrator> make(System& system, double tolerance = 1e-5) const {
    return make_variant(GetParam(), system, accurate_options(GetParam(), tolerance));
  }
  /// Without error control.
  static bool is_euler(const std::string& name) {
    return registered_name(name).ends_with("_euler") && !name.ends_with("_adaptive");
  }
};

/// The names of all integrators of rates, and of those with settings that change the course of a step.
inline std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const IntegratorInfo& info : integrators())
    if (!info.isochronous) names.push_back(info.name);
  for (const char* variant :
       {"explicit_euler_adaptive", "beta_euler_adaptive", "beta_euler_newton", "beta_euler_newton_adaptive"})
    names.emplace_back(variant);
  return names;
}

inline std::string test_name(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}

}  // namespace creepcontact::ode
