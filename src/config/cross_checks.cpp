#include "cross_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "creepcontact/config/configured.hpp"
#include "expression_checks.hpp"
#include "section_checks.hpp"

namespace creepcontact::config {
namespace {

template <class T>
std::vector<std::string> names_of(const std::vector<T>& all) {
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const T& one : all) names.push_back(one.name);
  return names;
}

/// A name among `names`; silent if there are none, for then their table is missing and has been reported.
void check_name(const Reference& used, const std::string& what, const std::vector<std::string>& names,
                Diagnostics& errors) {
  if (!used.given() || names.empty()) return;
  if (std::find(names.begin(), names.end(), used.name) != names.end()) return;
  errors.add_unknown(used.location, fmt::format("unknown {} '{}'", what, used.name), used.name, names);
}

/// Names that are used as keys of results and messages.
template <class T>
void check_unique(const std::vector<T>& all, Diagnostics& errors) {
  std::map<std::string, const T*> first;
  for (const T& one : all) {
    const auto [found, is_new] = first.emplace(one.name, &one);
    if (is_new || one.name.empty()) continue;
    errors.add(one.location, fmt::format("the name '{}' is already used by {}", one.name, found->second->location.key),
               "a different name for each");
  }
}

void check_regions(const std::vector<Body>& bodies, Diagnostics& errors) {
  std::map<std::string, std::string> owner;
  for (const Body& body : bodies) {
    for (const Reference& region : body.region) {
      const auto [found, is_new] = owner.emplace(region.name, body.name);
      if (is_new) continue;
      errors.add(region.location, fmt::format("region '{}' already belongs to body '{}'", region.name, found->second),
                 "each region in one body only");
    }
  }
}

/// Data that are wrong or missing have been reported.
bool by_temperature(const Rupture& rupture) {
  if (rupture.rupture_time) return rupture.rupture_time->depends_on_temperature();
  return !rupture.stress.empty() && !rupture.parameter.empty();
}

/// Requires a choice: without [temperature] a material is at its reference temperature, which must then be the user's
/// choice.
void check_temperature(const Config& config, const Item& root, Diagnostics& errors) {
  if (config.has_temperature()) return;
  for (const Contact& contact : config.contacts)
    if (contact.friction.depends_on_temperature())
      errors.add(contact.location, "'friction' depends on T, but no temperature is given",
                 "with [temperature] or [heat]");
  const auto report = [&](const Location& where) {
    errors.add(where, "depends on T, but no temperature is given", "with [temperature] or a reference_temperature");
  };
  const auto check = [&](const Function& function, const Location& where) {
    if (function.depends_on_temperature()) report(where);
  };
  for (const Gasket& gasket : config.gaskets)
    if (!gasket.reference_temperature) {
      const Item table = root.child("gaskets").child(gasket.name);
      if (gasket.loading.size() > 1) report(table.child("loading").location);
      for (const CreepMechanism& mechanism : gasket.creep)
        for (const CreepParameter& parameter : mechanism.parameters)
          for (const Function& value : parameter.values) check(value, parameter.location);
    }
  for (const Material& material : config.materials) {
    const Item table = root.child("materials").child(material.name);
    if (table.has("reference_temperature")) continue;
    check(material.young_modulus, table.child("young_modulus").location);
    check(material.poisson_ratio, table.child("poisson_ratio").location);
    if (const auto& given = material.orthotropic)
      for (const auto& [constants, key] :
           {std::pair(&given->young_moduli, "young_moduli"), std::pair(&given->poisson_ratios, "poisson_ratios"),
            std::pair(&given->shear_moduli, "shear_moduli")})
        for (const Function& constant : *constants) check(constant, table.child("orthotropic").child(key).location);
    if (const auto& given = material.plasticity) {
      const Item plasticity = table.child("plasticity");
      if (given->yield_stress) check(*given->yield_stress, plasticity.child("yield_stress").location);
      check(given->hardening_modulus, plasticity.child("hardening_modulus").location);
      if (given->curve.size() > 1) report(plasticity.child("curve").location);
      for (const KinematicHardening& back : given->kinematic)
        for (const Function* constant : {&back.C, &back.gamma})
          check(*constant, plasticity.child("kinematic").location);
    }
    if (material.yield_strength) check(*material.yield_strength, table.child("yield_strength").location);
    if (material.rupture && by_temperature(*material.rupture)) report(material.rupture->location);
    if (material.fatigue && material.fatigue->cycles_to_failure)
      check(*material.fatigue->cycles_to_failure, table.child("fatigue").child("cycles_to_failure").location);
    for (const CreepMechanism& mechanism : material.creep) {
      bool seen = false;
      for (const CreepParameter& parameter : mechanism.parameters) {
        for (const Function& value : parameter.values) {
          check(value, parameter.location);
          seen = seen || value.depends_on_temperature();
        }
      }
      if (mechanism.depends_on_temperature && !seen) report(mechanism.location);
    }
  }
}

/// Thermal strain is counted from the reference temperature, which has no natural value.
void check_reference_temperature(const Config& config, const Item& root, Diagnostics& errors) {
  if (!config.has_temperature()) return;
  for (const Material& material : config.materials) {
    const Item table = root.child("materials").child(material.name);
    if (std::ranges::all_of(material.thermal_expansion, &Function::is_zero) || table.has("reference_temperature"))
      continue;
    errors.add(table.child("thermal_expansion").location,
               "'reference_temperature' is missing: the temperature at which the thermal strain is zero is not known",
               "with reference_temperature, often the temperature of assembly");
  }
  for (const Gasket& gasket : config.gaskets) {
    const Item table = root.child("gaskets").child(gasket.name);
    if (!gasket.thermal_expansion.is_zero() && !gasket.reference_temperature && !table.has("reference_temperature"))
      errors.add(
          table.child("thermal_expansion").location,
          "'reference_temperature' is missing: the temperature at which the gasket has its thickness is not known",
          "with reference_temperature, often the temperature of assembly");
  }
}

/// Only a known temperature gives the elastic strain of an initial stress.
void check_initial_stress(const Config& config, const Item& root, Diagnostics& errors) {
  for (const InitialStress& stress : config.initial_stress) {
    const auto body = std::ranges::find(config.bodies, stress.name, &Body::name);
    if (body == config.bodies.end()) {
      check_name({stress.name, stress.location}, "body", names_of(config.bodies), errors);
      continue;
    }
    const auto material = std::ranges::find(config.materials, body->material.name, &Material::name);
    if (material == config.materials.end() || material->reference_temperature ||
        root.child("materials").child(material->name).has("reference_temperature"))
      continue;
    std::vector<Function> constants{material->young_modulus, material->poisson_ratio};
    if (const auto& given = material->orthotropic)
      for (const auto& three : {given->young_moduli, given->poisson_ratios, given->shear_moduli})
        constants.insert(constants.end(), three.begin(), three.end());
    if (std::ranges::any_of(constants, &Function::depends_on_temperature))
      errors.add(stress.location,
                 fmt::format("the elastic constants of '{}' depend on T, and it is not known at which temperature the "
                             "body has this stress",
                             material->name),
                 fmt::format("with materials.{}.reference_temperature", material->name));
  }
}

/// What [heat] needs of materials and contacts.
void check_heat(const Config& config, const Item& root, Diagnostics& errors) {
  if (!config.heat) return;
  const Heat& heat = *config.heat;
  if (config.temperature)
    errors.add(heat.location, "next to [temperature]", "one of the two: the temperature is given or computed");
  const Item table = root.child("heat");
  const bool is_steady =
      config.time.end == 0 || (!heat.start && !heat_changes_in_time(config) && !config.has_coupled_heat());
  if (config.time.end == 0 && heat.start)
    errors.add(table.child("start").location, "would be all that is computed up to time.end = 0",
               "\"steady\", or a later time.end");
  const std::vector<std::string> bodies = names_of(config.bodies);
  const auto check_bodies = [&](const auto& all) {
    for (const auto& one : all) check_name(one.body, "body", bodies, errors);
  };
  check_bodies(heat.films);
  check_bodies(heat.fluxes);
  check_bodies(heat.radiation);
  check_bodies(heat.sources);
  check_bodies(heat.temperatures);
  check_bodies(heat.point_flows);
  for (const Material& material : config.materials) {
    if (std::ranges::none_of(config.bodies, [&](const Body& body) { return body.material.name == material.name; }))
      continue;
    const Item own = root.child("materials").child(material.name);
    if (material.conductivity.empty() && !own.has("conductivity"))
      errors.add(own.location, "has no 'conductivity'", "with conductivity, which [heat] needs");
    if (material.heat_capacity && !material.density && !own.has("density"))
      errors.add(own.child("heat_capacity").location, "without 'density'", "with density, mass per volume");
    if (own.has("units") && own.has("conductivity"))
      errors.add(own.child("units").location, "heat data are not converted",
                 "conductivity, heat_capacity and density of materials without 'units'");
    if (!material.heat_capacity && !own.has("heat_capacity") && !is_steady)
      errors.add(own.location, "has no 'heat_capacity'",
                 "with heat_capacity and density, or heat.start = \"steady\" and nothing that changes in time");
  }
  if (!is_steady && !heat.time_unit && !table.has("time_unit"))
    errors.add(table.location, "'time_unit' is missing: how many units of time of the heat data one unit of t is",
               "3600 if t is in hours and the data are per second, 1 if both are the same");
  for (std::size_t i = 0; i < config.contacts.size(); ++i)
    if (const Contact& contact = config.contacts[i]; contact.type == ContactType::unilateral &&
                                                     contact.conductance.kind == Conductance::Kind::not_given &&
                                                     !root.child("contacts").element(i).has("conductance"))
      errors.add(contact.location, "has no 'conductance'",
                 "a number or a function, \"perfect\" or \"insulated\": what is perfect where closed and insulated "
                 "where open may have no solution");
}

/// What cannot be part of a run whose temperature is part of the state.
void check_coupled_heat(const Config& config, const Item& root, Diagnostics& errors) {
  if (!config.heat) return;
  for (const Contact& contact : config.contacts) {
    if (!contact.conductance.value.depends_on_contact()) continue;
    if (contact.type == ContactType::tied)
      errors.add(contact.location, "'conductance' depends on p or gap, but a tied contact always conducts as if closed",
                 "a number, or a function of x, y, z, t and T");
    if (config.is_heat_alone())
      errors.add(contact.location, "'conductance' depends on p or gap, but nothing but the heat is computed",
                 "a number, or a function of x, y, z, t and T; or a run with the mechanics");
  }
  if (!config.has_coupled_heat()) return;
  const std::string why = "a conductance depends on p or gap, and the temperature is part of the state";
  const auto refuse = [&](const Location& at, const std::string& what, const std::string& remedy) {
    errors.add(at, fmt::format("{}: not possible where {}", what, why), remedy);
  };
  for (const Contact& contact : config.contacts) {
    if (!contact.friction.is_zero())
      refuse(contact.location, "'friction'", "contact without friction, or conductances that do not depend on contact");
    if (contact.gasket.given())
      refuse(contact.location, "'gasket'", "no gaskets, or conductances that do not depend on contact");
    if (contact.preload && contact.preload->time == 0 && !config.heat->start)
      refuse(contact.location, "a preload at t = 0 with heat.start = \"steady\"",
             "a temperature as heat.start, or a later preload");
  }
  for (const Material& material : config.materials)
    if (material.plasticity)
      refuse(material.plasticity->location, "'plasticity'",
             "materials that only creep, or conductances that do not depend on contact");
  const Item time = root.child("time");
  if (const std::string& name = config.time.integrator; name != "auto" && name != "cvode_bdf" && name != "arkode_dirk")
    refuse(time.child("integrator").location, fmt::format("the integrator '{}'", name),
           "\"auto\", \"cvode_bdf\" or \"arkode_dirk\", whose iterations know the derivatives of heat");
  if (config.time.linear_solver == LinearSolver::tangent)
    refuse(time.child("linear_solver").location, "\"tangent\"", "\"krylov\"");
  if (config.time.jump_cycles) refuse(time.child("jump_cycles").location, "'jump_cycles'", "a run through all cycles");
}

/// Axes of a material without any are a mistake somewhere else.
void check_material_axes(const Config& config, const Item& root, Diagnostics& errors) {
  for (const Body& body : config.bodies) {
    if (!body.material_axes) continue;
    const auto material = std::ranges::find(config.materials, body.material.name, &Material::name);
    if (material == config.materials.end() || material->orthotropic || material->hill ||
        material->thermal_expansion.size() == 3 || material->conductivity.size() == 3)
      continue;
    errors.add(
        root.child("bodies").child(body.name).child("material_axes").location,
        fmt::format("the material '{}' is the same in all directions", material->name),
        fmt::format("with [materials.{0}.orthotropic], [materials.{0}.hill] or three coefficients of thermal_expansion "
                    "or conductivity",
                    material->name));
  }
}

/// Two pairs of the same surfaces would press twice.
void check_pairs(const std::vector<Contact>& contacts, Diagnostics& errors) {
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (contacts[i].name == contacts[j].name) continue;  // reported already
      const auto& [a, b] = contacts[i].between;
      const auto& [c, d] = contacts[j].between;
      if ((a.name != c.name || b.name != d.name) && (a.name != d.name || b.name != c.name)) continue;
      errors.add(
          contacts[i].location,
          fmt::format("the surfaces '{}' and '{}' are already in contact through contacts[{}]; remove one of the two",
                      a.name, b.name, j));
    }
}

void check_preloads(const Config& config, Diagnostics& errors) {
  for (const Contact& contact : config.contacts)
    if (const auto& preload = contact.preload; preload && config.time.end > 0 && preload->time > config.time.end)
      errors.add(contact.location, fmt::format("the preload is applied at t = {:.6g}, after the end", preload->time),
                 fmt::format("'at' between 0 and time.end = {:.6g}", config.time.end));
}

/// Names, times and materials that criteria need.
void check_criteria(const Config& config, const Item& root, Diagnostics& errors) {
  const std::vector<std::string> probes = names_of(config.probes), bodies = names_of(config.bodies),
                                 contacts = names_of(config.contacts);
  for (std::size_t i = 0; i < config.criteria.size(); ++i) {
    const Criterion& criterion = config.criteria[i];
    const Item item = root.child("criteria").element(i);
    if (criterion.probe.given() && probes.empty())
      errors.add(criterion.probe.location, fmt::format("there is no probe '{}'", criterion.probe.name),
                 "the name of one of [[probes]]");
    check_name(criterion.probe, "probe", probes, errors);
    check_name(criterion.body, "body", bodies, errors);
    if (criterion.contact.given() && contacts.empty())
      errors.add(criterion.contact.location, fmt::format("there is no contact '{}'", criterion.contact.name),
                 "the name of one of [[contacts]]");
    check_name(criterion.contact, "contact", contacts, errors);
    for (const auto& [key, time] :
         {std::pair("from", criterion.from), {"until", criterion.until}, {"at", criterion.at}})
      if (time && config.time.end > 0 && *time > config.time.end)
        errors.add(item.child(key).location, fmt::format("{:g} after time.end = {:g}", *time, config.time.end),
                   "a time up to the end of the run");
    const auto lacks = [&](const auto& has, const std::string& what) {
      const bool any = std::ranges::any_of(config.bodies, [&](const Body& body) {
        if (criterion.body.given() && body.name != criterion.body.name) return false;
        const auto material = std::ranges::find(config.materials, body.material.name, &Material::name);
        return material != config.materials.end() && has(*material);
      });
      if (!any)
        errors.add(criterion.location,
                   criterion.body.given() ? fmt::format("the material of '{}' has no {}", criterion.body.name, what)
                                          : fmt::format("no material has a {}", what),
                   fmt::format("with materials.<name>.{}", what));
    };
    for (const std::optional<CriterionLimit>* limit : {&criterion.min, &criterion.max}) {
      if (!*limit) continue;
      if ((*limit)->kind == CriterionLimit::Kind::yield_strength)
        lacks([](const Material& material) { return material.yield_strength.has_value(); }, "yield_strength");
      if ((*limit)->kind == CriterionLimit::Kind::rupture_strength)
        lacks([](const Material& material) { return material.rupture.has_value(); }, "rupture");
    }
    if (criterion.kind == CriterionKind::yield)
      lacks([](const Material& material) { return material.yield_strength.has_value(); }, "yield_strength");
    if (criterion.kind == CriterionKind::creep_life)
      lacks([](const Material& material) { return material.rupture.has_value(); }, "rupture");
  }
  check_unique(config.criteria, errors);
}

void check_fatigue(const Config& config, Diagnostics& errors) {
  for (const Material& material : config.materials)
    if (material.fatigue && !config.time.cycle)
      errors.add(material.fatigue->location, "there are no cycles that would cause fatigue",
                 "with time.cycle, the period of the loads");
}

/// Sectors are those of one structure: contacts reach from each of them into the next ones.
void check_cyclic(const Config& config, Diagnostics& errors) {
  for (const Cyclic& cyclic : config.cyclic) {
    const Cyclic& first = config.cyclic.front();
    if (cyclic.axis == first.axis && cyclic.origin == first.origin && cyclic.angle == first.angle) continue;
    errors.add(cyclic.location, fmt::format("the sector differs from that of {}", first.location.key),
               "the same 'axis', 'origin' and 'angle' in every [[cyclic]]");
  }
}

}  // namespace

void cross_check(const Config& config, const Item& root, Diagnostics& errors) {
  check_sections(config, root, errors);
  const std::vector<std::string> bodies = names_of(config.bodies);
  const std::vector<std::string> materials = names_of(config.materials);
  for (const Body& body : config.bodies) check_name(body.material, "material", materials, errors);
  for (const Support& support : config.supports) check_name(support.body, "body", bodies, errors);
  for (const Load& load : config.loads) check_name(load.body, "body", bodies, errors);
  for (const Probe& probe : config.probes) check_name(probe.body, "body", bodies, errors);
  for (const Contact& contact : config.contacts) {
    check_name(contact.gasket, "gasket", names_of(config.gaskets), errors);
    if (contact.gasket.given() && config.gaskets.empty())
      errors.add(contact.gasket.location, fmt::format("there is no gasket '{}'", contact.gasket.name),
                 fmt::format("with [gaskets.{}]", contact.gasket.name));
  }
  for (const Alpha::OfBody& alpha : config.contact_solver.alpha.of_body) check_name(alpha.body, "body", bodies, errors);
  check_unique(config.contacts, errors);
  check_pairs(config.contacts, errors);
  check_preloads(config, errors);
  check_cyclic(config, errors);
  check_fatigue(config, errors);
  check_unique(config.springs, errors);
  check_unique(config.probes, errors);
  check_unique(config.events, errors);
  check_criteria(config, root, errors);
  check_expressions(config, errors);
  check_regions(config.bodies, errors);
  check_temperature(config, root, errors);
  check_reference_temperature(config, root, errors);
  check_material_axes(config, root, errors);
  check_initial_stress(config, root, errors);
  check_heat(config, root, errors);
  check_coupled_heat(config, root, errors);
}

}  // namespace creepcontact::config
