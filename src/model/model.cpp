#include "creepcontact/model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <optional>

#include "computed_temperature.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/model/temperature.hpp"
#include "function_search.hpp"
#include "heat_alone.hpp"
#include "initial_stress.hpp"
#include "model_links.hpp"
#include "model_parts.hpp"
#include "schwarz_options.hpp"
#include "shared_nodes.hpp"
#include "tied_nodes.hpp"

namespace creepcontact::model {

std::size_t find_body(const Bodies& bodies, const std::string& name) {
  const auto found = std::ranges::find(bodies, name, &mechanics::Body::name);
  return found - bodies.begin();
}

std::vector<std::size_t> bodies_with(const Bodies& bodies, const std::string& group) {
  std::vector<std::size_t> result;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto& groups = bodies[b].mesh().groups;
    const auto found = groups.find(group);
    if (found != groups.end() && !found->second.cells.empty()) result.push_back(b);
  }
  return result;
}

void append_ties(const config::Config& config, const SharedNodes& shared, const Bodies& bodies,
                 std::vector<contact::Pair>& pairs) {
  std::vector<contact::Pair> ties = shared.ties(config, bodies);
  if (ties.empty() && config.mesh.share_nodes == config::SharedNodes::tie)
    log::warning(
        "mesh.share_nodes = \"tie\" has no effect: no bodies share nodes outside a contact; to join bodies that only "
        "touch, use a contact with type = \"tied\"");
  std::move(ties.begin(), ties.end(), std::back_inserter(pairs));
}

creep::SolverOptions solver_options(const config::Config& config, const Bodies& bodies) {
  creep::SolverOptions options;
  options.use_schwarz = config.contact_solver.method == settings::ContactMethod::schwarz;
  options.schwarz = schwarz_options(config.contact_solver, bodies);
  options.friction = config.contact_solver.friction;
  const bool sweeps = options.use_schwarz && options.schwarz.acceleration != settings::Acceleration::cg;
  if (sweeps) options.friction = settings::FrictionMethod::tresca;
  options.initial_substeps = config.contact_solver.initial_substeps;
  options.plastic_tolerance = 0.01 * config.time.tolerance;
  options.dense_limit_mb = config.contact_solver.dense_limit_mb;
  if (config.temperature) options.refactor_change = config.temperature->refactor_change;
  if (config.heat) options.refactor_change = config.heat->refactor_change;
  return options;
}

namespace {

std::vector<ChangingValue> changing_values(std::span<const SearchedFunction> functions) {
  std::vector<ChangingValue> result;
  for (const SearchedFunction& function : functions) result.push_back({function.key, function.courses});
  return result;
}

StepLimits step_limits(std::span<const SearchedFunction> functions) {
  std::vector<StepLimit> all;
  for (const SearchedFunction& function : functions)
    all.insert(all.end(), function.events.limits.begin(), function.events.limits.end());
  return StepLimits(all);
}

}  // namespace

Model build_model(const config::Config& given, MeshStore* meshes_read) {
  const bool is_heat_alone = given.is_heat_alone();
  const config::Config config = is_heat_alone ? without_mechanics(given) : given;
  const std::shared_ptr<const mesh::Mesh> read =
      meshes_read != nullptr ? meshes_read->mesh_of(config) : std::make_shared<const mesh::Mesh>(read_mesh(config));
  const mesh::Mesh& whole = *read;

  ErrorCollector errors;
  std::vector<mesh::BodyMesh> cut(config.bodies.size());
  for (std::size_t b = 0; b < config.bodies.size(); ++b)
    errors.collect(config.bodies[b].location, [&] {
      std::vector<std::string> regions;
      for (const config::Reference& region : config.bodies[b].region) regions.push_back(region.name);
      cut[b] = mesh::extract(whole, regions);
      cut[b].mesh.section.project_distorted = config.mesh.project_distorted;
      cut[b].mesh.section.thickness = config.bodies[b].thickness.value_or(config.mesh.thickness);
      if (!config.mesh.allow_locking && !config.is_heat_alone()) refuse_locking(config.bodies[b].name, cut[b].mesh);
    });
  errors.raise();  // what follows looks for groups on the bodies
  BodyMeshes meshes;
  mesh::SharedMesh shared_mesh = mesh::shared_mesh(cut);
  for (mesh::BodyMesh& body : cut) meshes.push_back(std::move(body.mesh));

  std::vector<std::vector<mechanics::Support>> supports(meshes.size());
  for (const config::Support& support : config.supports)
    errors.collect(support.on.location, [&] {
      for (const std::size_t b : bodies_on(config, whole, meshes, support.on.name, support.body, -1))
        if (support.acts_always())  // the others are equations
          for (mechanics::Support& made : make_supports(support, meshes[b])) supports[b].push_back(std::move(made));
    });

  if (is_heat_alone)
    for (std::size_t b = 0; b < meshes.size(); ++b) supports[b] = hold(meshes[b]);
  else
    prescribe_axial_strain(config, meshes, supports);
  check_groups(config, whole, meshes, errors);
  std::optional<SharedNodes> shared;
  try {
    shared.emplace(given, whole, meshes, std::move(shared_mesh));
    shared->check(given, errors);
  } catch (const ModelError&) {
    // What a contact covers is not known; its mistake is among the others, or is found when the contact is made.
  }

  std::optional<mechanics::TemperatureField> temperature;
  std::optional<creep::HeatModel> heat;
  std::optional<heat::Figures> figures;
  if (config.temperature)
    errors.collect(config.temperature->location, [&] { temperature = temperature_field(*config.temperature, whole); });
  ModelLinks links = make_links(given, whole, meshes, errors);
  errors.raise();
  if (config.heat)
    errors.collect(config.heat->location, [&] {
      ComputedTemperature computed = computed_temperature(given, whole, meshes, shared.value(), links);
      temperature = std::move(computed.field);
      heat = std::move(computed.heat);
      figures = std::move(computed.figures);
    });
  errors.raise();
  if (is_heat_alone) links = make_links(config, whole, meshes, errors);
  std::map<std::string, material::Material> materials;
  for (const config::Material& material : config.materials)
    if (std::ranges::any_of(config.bodies, [&](const auto& body) { return body.material.name == material.name; }))
      errors.collect(material.location, [&] { materials.emplace(material.name, make_material(material)); });
  errors.raise();
  std::vector<mechanics::StressField> initial(meshes.size());
  for (const config::InitialStress& stress : config.initial_stress)
    errors.collect(stress.location, [&] {
      const std::size_t b = body_index(config, stress.name);
      initial[b] = initial_stress(stress, meshes[b]);
    });
  errors.raise();
  Bodies bodies;
  for (std::size_t b = 0; b < meshes.size(); ++b)
    errors.collect(config.bodies[b].location, [&] {
      bodies.emplace_back(config.bodies[b].name, meshes[b], materials.at(config.bodies[b].material.name), supports[b],
                          temperature, links.of_body[b], is_heat_alone ? std::nullopt : material_axes(config.bodies[b]),
                          initial[b]);
    });
  errors.raise();
  if (temperature) tell_interpolation(config, bodies, *temperature);

  require_one_theory(config, bodies);

  for (const config::Load& load : config.loads)
    errors.collect(load.location, [&] { add_load(load, config, whole, meshes, bodies); });
  add_motion_loads(config, meshes, links, bodies, errors);
  GasketKinds gaskets;
  for (const config::Gasket& gasket : config.gaskets)
    errors.collect(gasket.location, [&] { gaskets[gasket.name] = make_gasket(gasket); });
  const SharedCouplings couplings(config, meshes_read);
  std::vector<contact::Pair> pairs;
  for (const config::Contact& contact : config.contacts)
    if (!contact.gasket.given() || gaskets.contains(contact.gasket.name))  // else its mistake has been collected
      errors.collect(contact.location,
                     [&] { pairs.push_back(make_pair(contact, config, bodies, temperature, gaskets, couplings, {})); });
  errors.raise();
  for (std::size_t p = 0; p < pairs.size(); ++p)
    errors.collect(config.contacts[p].location, [&] {
      require_same_supports(pairs[p].coupling.ties, bodies[pairs[p].slave_body], bodies[pairs[p].master_body],
                            config.time.output);
    });
  errors.raise();
  if (!is_heat_alone) append_ties(config, shared.value(), bodies, pairs);
  leave_out_dependent_ties(bodies, config.time.output, pairs);
  append_sector_ties(config, links, bodies, pairs, errors);
  append_equations(config, whole, meshes, bodies, motion_equations(config, meshes, links, errors), pairs, errors);
  append_springs(config, bodies, pairs, errors);
  errors.raise();
  if (!is_heat_alone) share_axial_strain(config, bodies, pairs);

  creep::SolverOptions options = solver_options(config, bodies);
  std::vector<SearchedFunction> functions;
  std::vector<double> times;
  if (config.time.end > 0) {
    functions = search_functions(config, bodies, temperature);
    times = breakpoints(config, functions, temperature);
  }
  if (temperature) warn_of_positions_outside(config, bodies, *temperature);
  warn_of_gaskets(config, bodies);
  // Motions that nothing but facets would hold (a ring turning on its shaft) are left free exactly.
  const auto remake = [&](const Bodies& all, std::size_t pair, std::span<const mechanics::RigidMotion> sliding) {
    return make_pair(config.contacts[pair], config, all, temperature, gaskets, couplings, sliding);
  };
  std::optional<LoadCycles> cycles;
  if (config.time.cycle) cycles.emplace(config, changing_values(functions), times);
  Model model{creep::Assembly(std::move(bodies), std::move(pairs), remake),
              std::move(options),
              std::move(temperature),
              std::move(times),
              step_limits(functions),
              std::move(cycles),
              std::move(figures)};
  if (heat) heat->is_alone = is_heat_alone;
  if (heat) model.assembly.set_heat(of_assembly(std::move(*heat), config, model.assembly));
  if (model.cycles) require_cycles(config, model.assembly, *model.cycles);
  return model;
}

}  // namespace creepcontact::model
