// The tolerance bounds the error of the stress for laws with singular starts and variables of their own, too.

#include <fmt/format.h>

#include <limits>

#include "verification/case.hpp"
#include "verification/stress_runs.hpp"

namespace creepcontact {
namespace law_tolerance_tests {
namespace {

using namespace test;

struct Case {
  std::string name, file;
  std::vector<std::string> overrides;
  std::int64_t max_solves;  ///< of `auto` for an error of the stress below 1e-3
};

std::string law(const std::string& material, const std::string& keys) {
  return "materials." + material + ".creep=[{law=" + keys + "}]";
}

std::vector<Case> cases() {
  const std::vector<std::string> coarse_fit{"mesh.parameters.around_shaft=6", "mesh.parameters.around_disc=5"};
  const auto fit = [&](const std::string& keys) {
    std::vector<std::string> all = coarse_fit;
    for (const char* material : {"rotor", "wheel"}) all.push_back(law(material, keys));
    return all;
  };
  return {
      {"CylinderTimeHardening",
       "thick_cylinder.toml",
       {law("steel", "\"time_hardening\",A=3.125e-14,n=5,m=0.4"), "time.end=100"},
       200},
      {"CylinderStrainHardening",
       "thick_cylinder.toml",
       {law("steel", "\"strain_hardening\",A=3.125e-14,n=5,m=0.4"), "time.end=100"},
       250},
      {"CylinderSoderberg",
       "thick_cylinder.toml",
       {law("steel", "\"soderberg\",C=1e-10,p=3,r=0.1,A=3.125e-14,n=5"), "time.end=100"},
       420},  // 216 to 411 at 1e-2 and 315 to 394 at 3e-3, as the last bits fall
      {"CylinderRccMr",
       "thick_cylinder.toml",
       {law("steel", "\"rcc_mr\",C1=3.125e-14,C2=0.4,n1=5,C=2e-15,n=5,C3=1e9,n3=-3.5"), "time.end=100"},
       850},  // 700 to 775 as the last bits fall: every point passes the corner of its rate, where primary creep ends,
              // at a time of its own
      {"CylinderThetaProjection",
       "thick_cylinder.toml",
       {law("steel", "\"theta_projection\",theta_1=\"1e-10*q^3\",theta_2=0.1,theta_3=\"1e-12*q^4\",theta_4=\"1e-4*q\""),
        "time.end=100"},
       250},
      {"CylinderHereditary",
       "thick_cylinder.toml",
       {law("steel", "\"hereditary\",compliances=[2e-6,4e-6,1e-5],times=[1e-3,0.1,3]")},
       250},
      {"CylinderDamage",
       "thick_cylinder.toml",
       {law("steel", "\"kachanov_rabotnov\",A=3.125e-14,n=5,B=1e-15,r=5,phi=5"), "time.end=20"},
       300},
      {"PlatePrimaryAndSecondary",
       "plate_with_hole.toml",
       {"materials.chromium_steel.creep=[{law=\"norton\",A=1.2e-24,n=8},{law=\"strain_hardening\",A=1e-16,n=6,m=0.333}"
        "]"},
       300},
      {"FitStrainHardening", "shrink_fit.toml", fit("\"strain_hardening\",A=1e-15,n=5,m=0.5"), 250},
      {"FitHereditary", "shrink_fit.toml", fit("\"burgers\",viscosity=1e11,compliance=3e-6,time=100"), 250},
  };
}

class LawTolerance : public testing::TestWithParam<Case> {};

TEST_P(LawTolerance, BoundsTheRelativeErrorOfTheStress) {
  StressRuns runs = StressRuns::of_file(GetParam().file, GetParam().overrides);
  const StressHistory reference = runs.run(1e-7, "cvode_bdf");
  for (const std::string integrator : {"auto", "cvode_bdf", "arkode_dirk"}) {
    auto enough = std::numeric_limits<std::int64_t>::max();  // solves of the cheapest run with an error below 1e-3
    for (const double tolerance : {1e-2, 3e-3, 1e-3, 1e-4, 1e-5}) {
      if (integrator == "arkode_dirk" && tolerance != 1e-3) continue;
      const StressHistory history = runs.run(tolerance, integrator);
      const StressError error = runs.error(history, reference);
      const std::string measured =
          fmt::format("{} at {:g}: norm {:.2g}, maximum {:.2g} of the tolerance; {} solves, {} steps, {} failures",
                      integrator, tolerance, error.norm / tolerance, error.maximum / tolerance, history.elastic_solves,
                      history.steps.steps, history.steps.convergence_failures);
      RecordProperty(fmt::format("{}_at_{:g}", integrator, tolerance), measured);
      EXPECT_LT(error.norm, (integrator == "auto" ? 3 : 4) * tolerance) << measured;
      EXPECT_LT(error.maximum, 6 * tolerance) << measured;
      EXPECT_LT(history.elastic_solves, 5000) << measured;  // stability that is not seen takes ten thousands
      if (error.norm < 1e-3) enough = std::min(enough, history.elastic_solves);
    }
    if (integrator == "auto") {
      EXPECT_LE(enough, GetParam().max_solves);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, LawTolerance, testing::ValuesIn(cases()), [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace law_tolerance_tests
}  // namespace creepcontact
