#include "creepcontact/simulation/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "model_parts.hpp"
#include "schwarz_options.hpp"
#include "shared_nodes.hpp"
#include "temperature.hpp"

namespace creepcontact::simulation {

void Mistakes::collect(const config::Location& where, const std::function<void()>& work) {
  try {
    work();
  } catch (const ModelError& error) {
    const std::string prefix = where.prefix();
    const std::string message = error.what();
    // Some messages already begin with a place.
    lines_.push_back(message.rfind(prefix, 0) == 0 ? message : prefix + message);
  }
}

void Mistakes::raise() const {
  if (empty()) return;
  std::string all;
  for (const std::string& line : lines_) all += (all.empty() ? "" : "\n") + line;
  throw ModelError(all);
}

std::size_t Model::find_body(const std::string& name) const {
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const auto& body) { return body->name() == name; });
  return static_cast<std::size_t>(found - bodies.begin());
}

std::vector<std::size_t> Model::bodies_with(const std::string& group) const {
  std::vector<std::size_t> result;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto& groups = bodies[b]->mesh().groups;
    const auto found = groups.find(group);
    if (found != groups.end() && !found->second.cells.empty()) result.push_back(b);
  }
  return result;
}

bool Model::creeps() const {
  return std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return body->material().creeps(); });
}

/// Motions that nothing but facets would hold (a ring turning on its shaft) are left free exactly.
void let_slide(const config::Config& config, Model& model) {
  const contact::FloatingMotions floating(model.bodies, model.pairs);
  const auto sliding = floating.sliding(model.pairs);
  for (std::size_t p = 0; p < config.contacts.size(); ++p)
    if (!sliding[p].empty()) model.pairs[p] = make_pair(config.contacts[p], config, model, sliding[p]);
  contact::number_rows(model.pairs);
}

void tie_shared_nodes(const config::Config& config, const SharedNodes& shared, Model& model) {
  std::vector<contact::Pair> ties = shared.ties(config, model);
  if (ties.empty() && config.mesh.share_nodes == config::SharedNodes::tie)
    log::warning(
        "mesh.share_nodes = \"tie\" glues nothing: no bodies share nodes that no contact covers; bodies that only "
        "touch "
        "are joined by a contact with type = \"tied\"");
  std::move(ties.begin(), ties.end(), std::back_inserter(model.pairs));
}

Model build_model(const config::Config& config) {
  const mesh::Mesh whole = read_mesh(config.mesh);

  Mistakes mistakes;
  std::vector<mesh::BodyMesh> cut(config.bodies.size());
  for (std::size_t b = 0; b < config.bodies.size(); ++b)
    mistakes.collect(config.bodies[b].location, [&] {
      std::vector<std::string> regions;
      for (const config::Reference& region : config.bodies[b].region) regions.push_back(region.name);
      cut[b] = mesh::extract(whole, regions);
      if (!config.mesh.allow_locking) refuse_locking(config.bodies[b].name, cut[b].mesh);
    });
  mistakes.raise();  // what follows looks for groups on the bodies
  BodyMeshes meshes;
  mesh::SharedMesh shared_mesh = mesh::shared_mesh(cut);
  for (mesh::BodyMesh& body : cut) meshes.push_back(std::move(body.mesh));

  std::vector<std::vector<mechanics::Support>> supports(meshes.size());
  for (const config::Support& support : config.supports)
    mistakes.collect(support.on.location, [&] {
      for (const std::size_t b : bodies_on(config, whole, meshes, support.on.name, support.body, -1))
        for (mechanics::Support& made : make_supports(support, meshes[b])) supports[b].push_back(std::move(made));
    });

  check_groups(config, whole, meshes, mistakes);
  std::optional<SharedNodes> shared;
  try {
    shared.emplace(config, whole, meshes, std::move(shared_mesh));
    shared->check(config, mistakes);
  } catch (const ModelError&) {
    // What a contact covers is not known; its mistake is among the others, or is found when the contact is made.
  }

  Model model;
  if (config.temperature)
    mistakes.collect(config.temperature->location, [&] { model.temperature = temperature_field(*config.temperature); });
  if (config.temperature) model.refactor_change = config.temperature->refactor_change;
  mistakes.raise();
  for (std::size_t b = 0; b < meshes.size(); ++b)
    mistakes.collect(config.bodies[b].location, [&] {
      model.bodies.push_back(std::make_unique<mechanics::Body>(
          config.bodies[b].name, meshes[b], make_material(config.material(config.bodies[b].material.name)), supports[b],
          model.temperature));
    });
  mistakes.raise();

  require_one_theory(config, model);

  for (const config::Load& load : config.loads)
    mistakes.collect(load.location, [&] { add_load(load, config, whole, meshes, model); });
  for (const config::Contact& contact : config.contacts)
    mistakes.collect(contact.location, [&] { model.pairs.push_back(make_pair(contact, config, model, {})); });
  mistakes.raise();
  tie_shared_nodes(config, shared.value(), model);
  contact::number_rows(model.pairs);
  let_slide(config, model);

  model.use_schwarz = config.contact_solver.method == config::ContactMethod::schwarz;
  model.schwarz = schwarz_options(config.contact_solver, model);
  model.dense_limit_mb = config.contact_solver.dense_limit_mb;
  model.temperature_watch = TemperatureWatch(config);
  model.breakpoints = breakpoints(config, model);
  warn_of_places_outside(config, model);
  return model;
}

std::unique_ptr<contact::ContactSolver> make_contact_solver(const Model& model,
                                                            const contact::ContactProblem& problem) {
  if (problem.large) {
    constexpr int most_iterations = 1000;
    contact::SchwarzOptions options = model.schwarz;
    if (!model.use_schwarz || options.acceleration != contact::SchwarzOptions::Acceleration::cg)
      log::warning(
          "contact: {} multipliers are too many for dense matrices; conjugate gradients without them are used "
          "(contact_solver.dense_limit_mb sets the bound)",
          problem.n_rows());
    options.acceleration = contact::SchwarzOptions::Acceleration::cg;
    options.max_iterations = std::max(options.max_iterations, most_iterations);
    return contact::schwarz_solver(problem, options);
  }
  return model.use_schwarz ? contact::schwarz_solver(problem, model.schwarz) : contact::active_set_solver(problem);
}

}  // namespace creepcontact::simulation
