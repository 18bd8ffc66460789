/// Ageing theory gives creep strains, the other laws rates: an integrator takes one or the other.

#include <fmt/format.h>

#include "creepcontact/base/error.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {
namespace {

bool is_isochronous(const std::string& integrator) {
  for (const ode::IntegratorInfo& info : ode::integrators())
    if (info.name == integrator) return info.isochronous;
  return false;
}

}  // namespace

void require_one_theory(const config::Config& config, const Bodies& bodies) {
  const bool ageing_wanted = is_isochronous(config.time.integrator);
  for (const mechanics::Body& body : bodies) {
    const config::Material& material = config.material(body.material().name);
    const auto& laws = body.material().creep;
    for (std::size_t i = 0; i < laws.size(); ++i) {
      if (laws[i]->is_isochronous() == ageing_wanted) continue;
      // Mechanisms beyond those of the configuration result from its rupture and fatigue data.
      const config::Location& where = i < material.creep.size() ? material.creep[i].location : material.location;
      const std::string found =
          i < material.creep.size() ? fmt::format("the law '{}'", material.creep[i].law) : "life data";
      if (ageing_wanted && i >= material.creep.size())
        throw ConfigError(
            fmt::format("{}material '{}' has {} data, whose life fraction must be integrated over time: "
                        "time.integrator = \"{}\" does not integrate rates. Remove [materials.{}.{}], or use a "
                        "law that gives a rate (time_hardening, strain_hardening) and another integrator",
                        where.prefix(), material.name, material.rupture ? "rupture" : "fatigue", config.time.integrator,
                        material.name, material.rupture ? "rupture" : "fatigue"));
      if (ageing_wanted)
        throw ConfigError(
            fmt::format("{}time.integrator = \"{}\" solves only for the creep strain of ageing theory and does not "
                        "integrate rates, but material '{}' has {}; allowed: law = \"ageing\" (for Norton's law with m "
                        "= 1), or another integrator",
                        where.prefix(), config.time.integrator, material.name, found));
      throw ConfigError(
          fmt::format("{}material '{}' has {}, which gives a creep strain and not a rate: time.integrator = \"{}\" "
                      "cannot integrate it. Set time.integrator = \"isochronous\", or use law = \"time_hardening\" or "
                      "\"strain_hardening\" with the same A, n, m (the same creep strain at constant stress)",
                      where.prefix(), material.name, found, config.time.integrator));
    }
  }
}

}  // namespace creepcontact::model
