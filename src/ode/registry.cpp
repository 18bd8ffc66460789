#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "auto_integrator.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "euler/beta_euler.hpp"
#include "euler/explicit_euler.hpp"
#include "euler/isochronous.hpp"
#include "log_adams.hpp"
#include "singular_start.hpp"
#include "sundials/arkode_integrator.hpp"
#include "sundials/butcher_tables.hpp"
#include "sundials/cvode_integrator.hpp"

namespace creepcontact::ode {

namespace {
template <typename Scheme>
std::unique_ptr<Integrator> make(System& system, const IntegratorOptions& options) {
  return std::make_unique<Scheme>(system, options);
}
}  // namespace

const std::vector<IntegratorInfo>& integrators() {
  static const std::vector<IntegratorInfo> all = {
      {"auto",
       "the default: chooses by itself, `log_adams` while stress relaxes, `cvode_bdf` when creep becomes steady, with "
       "the tangent stiffness if its iterations fail",
       make<AutoIntegrator>},
      {"explicit_euler", "explicit Euler; fixed, stable or adaptive steps (Stankevich 2012)", make<ExplicitEuler>},
      {"beta_euler",
       "implicit Euler with `beta` >= 0.5; fixed-point or Newton iterations, fixed, stable or adaptive steps "
       "(Stankevich 2012)",
       make<BetaEuler>},
      {"cvode_bdf", "CVODE BDF of order 1 to 3, with `tolerance` below 2e-4 to 4, Newton-Krylov, error control",
       CvodeIntegrator::bdf},
      {"cvode_adams", "CVODE Adams of order 1 to 6, fixed-point iterations, error control: while stress relaxes",
       CvodeIntegrator::adams},
      {"log_adams",
       "Adams of order 1 to 3 in logarithmic time, damped by the stiffness of each point, error control: one rate "
       "evaluation per step",
       make<LogAdams>},
      {"arkode_erk",
       "ARKODE explicit Runge-Kutta, 3(2) of Bogacki and Shampine (`table = \"bogacki_shampine_4_2_3\"`), or 5(4) of "
       "Dormand and Prince (`table = \"dormand_prince_7_4_5\"`), error control: for times short compared with the "
       "relaxation",
       ArkodeIntegrator::explicit_rk, table_names(explicit_tables())},
      {"arkode_dirk",
       "ARKODE implicit Runge-Kutta, ESDIRK 3(2) (`table = \"ark324l2sa_dirk_4_2_3\"`), Newton-Krylov, error control: "
       "restarts without loss of order",
       ArkodeIntegrator::diagonally_implicit_rk, table_names(diagonally_implicit_tables())},
      {.name = "isochronous",
       .description = "no integration: equilibrium of ageing theory at every output time, Newton; for the law "
                      "`ageing`, which needs it",
       .make = make<Isochronous>,
       .isochronous = true},
  };
  return all;
}

std::unique_ptr<Integrator> make_integrator(const std::string& name, System& system, const IntegratorOptions& options) {
  const auto& all = integrators();
  const auto found = std::ranges::find(all, name, &IntegratorInfo::name);
  if (found == all.end()) throw std::out_of_range(fmt::format("no integrator named '{}'", name));
  if (system.singular_rate() != nullptr && !found->isochronous)
    return std::make_unique<SingularStart>(*found, system, options);
  return found->make(system, options);
}

}  // namespace creepcontact::ode
