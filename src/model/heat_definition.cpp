#include "heat_definition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"

namespace creepcontact::model {
namespace {

/// Errors of an entry of [heat] name its list and place.
template <typename Work>
void for_entries(const auto& entries, const char* list, const Work& work) {
  for (std::size_t i = 0; i < entries.size(); ++i) try {
      work(entries[i]);
    } catch (const ModelError& error) {
      throw ModelError(fmt::format("{}[{}]: {}", list, i, error.what()));
    }
}

class DefinitionMaker {
 public:
  DefinitionMaker(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes)
      : config_(config), heat_(*config.heat), whole_(whole), meshes_(meshes) {}

  heat::Definition made(const SharedNodes& shared, const ModelLinks& links) {
    all_.time_unit = heat_.time_unit.value_or(1);
    all_.absolute_zero = heat_.absolute_zero.value_or(0);
    add_bodies();
    add_flows();
    add_point_flows();
    warn_of_twice_given();
    tell_of_films_in_contact();
    for (const config::Contact& contact : config_.contacts) add_contact(contact);
    for (const SharedNodes::Joined& both : shared.joined())
      all_.equal.push_back({{both.first.body, both.first.node}, {both.second.body, both.second.node}});
    for (std::size_t b = 0; b < meshes_.size(); ++b)
      for (const mechanics::NodeLinks::Turned& link : links.of_body[b].turned)
        all_.equal.push_back({{b, link.node}, {b, link.of}});
    for (const ModelLinks::UnmatchedFace& unmatched : links.unmatched) add_sector_faces(unmatched);
    return std::move(all_);
  }

 private:
  int face_dimension() const { return whole_.section.dimension() - 1; }
  std::vector<std::size_t> bodies_on(const config::Reference& on, const config::Reference& body, int dimension) const {
    return model::bodies_on(config_, whole_, meshes_, on.name, body, dimension);
  }

  void add_bodies() {
    for (std::size_t b = 0; b < meshes_.size(); ++b) {
      const config::Material& material = config_.material(config_.bodies[b].material.name);
      all_.bodies.push_back({config_.bodies[b].name, &meshes_[b], material.conductivity,
                             material.conductivity.size() == 3 ? material_axes(config_.bodies[b]) : std::nullopt,
                             material.heat_capacity.value_or(0.0), material.density.value_or(1)});
    }
  }

  /// A name that no other flow has: the second one on a surface is number 2.
  std::string another(const std::string& name) {
    const int number = ++names_[name];
    return number == 1 ? name : fmt::format("{}, number {}", name, number);
  }

  void add_flow(heat::SurfaceFlow::Kind kind, const config::Reference& on, const config::Reference& body,
                const Function& factor, const Function& beyond) {
    using Kind = heat::SurfaceFlow::Kind;
    const char* const word = kind == Kind::film ? "film" : kind == Kind::flux ? "flux" : "radiation";
    for (const std::size_t b : bodies_on(on, body, face_dimension()))
      all_.flows.push_back({kind, b, mesh::boundary_faces(meshes_[b], on.name), factor, beyond,
                            another(fmt::format("{} on '{}' of body '{}'", word, on.name, config_.bodies[b].name))});
  }

  void add_flows() {
    using Kind = heat::SurfaceFlow::Kind;
    for_entries(heat_.films, "films", [&](const config::HeatFilm& film) {
      add_flow(Kind::film, film.on, film.body, film.coefficient, film.fluid);
    });
    for_entries(heat_.fluxes, "fluxes",
                [&](const config::HeatFlux& flux) { add_flow(Kind::flux, flux.on, flux.body, flux.value, 0.0); });
    for_entries(heat_.radiation, "radiation", [&](const config::HeatRadiation& radiation) {
      const double sigma = *heat_.stefan_boltzmann;
      add_flow(Kind::radiation, radiation.on, radiation.body,
               Function::composed(
                   fmt::format("{:.17g} times {}", sigma, radiation.emissivity.text()), {radiation.emissivity},
                   [sigma](const std::vector<double>& values) {
                     return values[0] <= 1 ? sigma * values[0] : std::numeric_limits<double>::quiet_NaN();
                   }),
               radiation.ambient);
    });
    for_entries(heat_.sources, "sources", [&](const config::HeatSource& source) {
      all_.sources.push_back({body_index(config_, source.body.name), source.value,
                              another(fmt::format("source in body '{}'", source.body.name))});
    });
    for_entries(heat_.temperatures, "temperatures", [&](const config::HeatTemperature& given) {
      for (const std::size_t b : bodies_on(given.on, given.body, -1))
        all_.given.push_back(
            {b, mesh::group_nodes(meshes_[b], given.on.name), given.value,
             another(fmt::format("given temperature of '{}' on body '{}'", given.on.name, config_.bodies[b].name))});
    });
  }

  void tell_of_films_in_contact() const {
    for (const config::HeatFilm& film : heat_.films)
      for (const config::Contact& contact : config_.contacts)
        if (std::ranges::any_of(contact.between, [&](const auto& side) { return side.name == film.on.name; }))
          log::info("heat: the film on '{}' acts where contact '{}' is closed, too", film.on.name, contact.name);
  }

  void warn_of_twice_given() const {
    for (std::size_t i = 0; i < all_.given.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const heat::GivenTemperature &later = all_.given[i], &earlier = all_.given[j];
        if (later.body != earlier.body) continue;
        const std::set<std::int64_t> nodes(earlier.nodes.begin(), earlier.nodes.end());
        for (const std::int64_t node : later.nodes) {
          if (!nodes.contains(node)) continue;
          const Vector3& x = meshes_[later.body].nodes[static_cast<std::size_t>(node)];
          const Arguments at{.x = x[0], .y = x[1], .z = x[2]};
          const double one = earlier.value(at), other = later.value(at);
          if (one == other) continue;
          log::warning("heat: at ({:.6g}, {:.6g}, {:.6g}) the {} is {:.6g}, and the {} is {:.6g}: the last one counts",
                       x[0], x[1], x[2], earlier.name, one, later.name, other);
          break;
        }
      }
  }

  void add_point_flows() {
    for_entries(heat_.point_flows, "point_flows", [&](const config::HeatPointFlow& flow) {
      heat::PointFlow made{{}, flow.value, another(fmt::format("flow into the nodes of '{}'", flow.on.name))};
      for (const std::size_t b : bodies_on(flow.on, flow.body, -1))
        for (const std::int64_t node : mesh::group_nodes(meshes_[b], flow.on.name)) made.nodes.push_back({b, node});
      all_.point_flows.push_back(std::move(made));
    });
  }

  void add_contact(const config::Contact& contact) {
    using Kind = config::Conductance::Kind;
    if (contact.conductance.kind == Kind::insulated) return;
    const auto owners = [&](std::size_t side) { return bodies_on(contact.between[side], {}, face_dimension()); };
    const std::array<std::size_t, 2> bodies = contact_bodies(contact, config_, {owners(0), owners(1)});
    heat::Interface made{
        contact.name, bodies[0], bodies[1], {}, contact.conductance.value, contact.conductance.kind != Kind::function};
    made.faces = contact::facing_faces(
        meshes_[bodies[0]], mesh::boundary_faces(meshes_[bodies[0]], contact.between[0].name), meshes_[bodies[1]],
        mesh::boundary_faces(meshes_[bodies[1]], contact.between[1].name), sector(config_));
    all_.interfaces.push_back(std::move(made));
  }

  /// Like a contact of the body with itself in the next sector.
  void add_sector_faces(const ModelLinks::UnmatchedFace& unmatched) {
    const mesh::Mesh& mesh = meshes_[unmatched.body];
    const auto faces = [&](std::size_t side) {
      return mesh::boundary_faces(mesh, config_.cyclic[unmatched.cyclic].between[side].name);
    };
    heat::Interface made{sector_tie_name(config_, unmatched), unmatched.body, unmatched.body, {}, 0.0, true};
    made.faces = contact::facing_faces(mesh, faces(1), mesh, faces(0), sector(config_));
    all_.interfaces.push_back(std::move(made));
  }

  const config::Config& config_;
  const config::Heat& heat_;
  const mesh::Mesh& whole_;
  const BodyMeshes& meshes_;
  heat::Definition all_;
  std::map<std::string, int> names_;  // how often given
};

}  // namespace

heat::Definition heat_definition(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes,
                                 const SharedNodes& shared, const ModelLinks& links) {
  return DefinitionMaker(config, whole, meshes).made(shared, links);
}

}  // namespace creepcontact::model
