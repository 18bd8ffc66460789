#include "places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>

#include "creepcontact/base/overload.hpp"

namespace creepcontact::model {
namespace {

constexpr std::size_t few_cells = 4000;
constexpr double linear_point = 0.577, quadratic_point = 0.775;  // of the way from the centre of an element to a corner

/// Adds the places of a cell other than its nodes.
void add_inner_points(const mesh::Mesh& mesh, mesh::CellType type, std::span<const std::int64_t> nodes,
                      std::size_t body, bool corners, Places& to) {
  Vector3 centre = Vector3::Zero();
  const auto n = static_cast<std::size_t>(mesh::n_corners(type));
  for (std::size_t i = 0; i < n; ++i) centre += mesh.nodes[nodes[i]] / static_cast<double>(n);
  to.push_back({centre, body});
  const double share = mesh::order(type) == 1 ? linear_point : quadratic_point;
  for (std::size_t i = 0; corners && i < n; ++i) to.push_back({centre + share * (mesh.nodes[nodes[i]] - centre), body});
}

/// The entry that a key belongs to: "loads[3].pressure" of "loads" is 3; nullopt: the key is of another list.
std::optional<std::size_t> index_in(const std::string& key, const std::string& list) {
  if (!key.starts_with(list + "[")) return std::nullopt;
  std::size_t index = 0;
  const char* const begin = key.data() + list.size() + 1;
  const auto [end, error] = std::from_chars(begin, key.data() + key.size(), index);
  if (error != std::errc() || end == begin) return std::nullopt;
  return index;
}

}  // namespace

Places KeyPlaces::on_group(const std::string& group, const config::Reference& body) const {
  Places result;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const mesh::Mesh& mesh = bodies_[b].mesh();
    const auto found = mesh.groups.find(group);
    if (found == mesh.groups.end() || (body.given() && bodies_[b].name() != body.name)) continue;
    for (const std::int64_t node : mesh::group_nodes(mesh, group)) result.push_back({mesh.nodes[node], b});
    const std::vector<mesh::CellRef>& cells = found->second.cells;
    if (found->second.dimension == 0) continue;
    for (const mesh::CellRef& cell : cells)
      add_inner_points(mesh, mesh.blocks[cell.block].type, mesh.blocks[cell.block].cell(cell.cell), b,
                       cells.size() < few_cells, result);
  }
  return result;
}

Places KeyPlaces::on_bodies(const std::vector<std::size_t>& bodies) const {
  Places result;
  std::size_t n_cells = 0;
  for (const std::size_t b : bodies)
    for (const mesh::CellBlock& block : bodies_[b].mesh().blocks) n_cells += block.size();
  for (const std::size_t b : bodies) {
    const mesh::Mesh& mesh = bodies_[b].mesh();
    for (std::size_t i = 0; i < mesh.n_cell_nodes(); ++i) result.push_back({mesh.nodes[i], b});
    for (const mesh::CellBlock& block : mesh.blocks)
      for (std::size_t i = 0; mesh.is_bulk(block.type) && i < block.size(); ++i)
        add_inner_points(mesh, block.type, block.cell(i), b, n_cells < few_cells, result);
  }
  return result;
}

Places KeyPlaces::at_node(const config::PointForce& force, const config::Reference& body) const {
  if (!force.at) {
    for (const NodeOfBody& node : nodes_numbered(bodies_, force.node))
      if (!body.given() || bodies_[node.body].name() == body.name)
        return {{bodies_[node.body].mesh().nodes[node.node], node.body}};
    return body.given() ? on_bodies({body_index(config_, body.name)}) : Places{};
  }
  Place nearest;
  double distance = std::numeric_limits<double>::infinity();
  const Vector3 at = vector(*force.at);
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (std::size_t i = 0; i < bodies_[b].mesh().n_cell_nodes(); ++i)
      if (const Vector3& x = bodies_[b].mesh().nodes[i]; (x - at).norm() < distance) {
        distance = (x - at).norm();
        nearest = {x, b};
      }
  return {nearest};
}

Places KeyPlaces::of_load(const config::Load& load) const {
  const auto in_body = [&] { return on_bodies({body_index(config_, load.body.name)}); };
  return std::visit(
      Overload{[&](const config::Pressure&) { return on_group(load.on.name, load.body); },
               [&](const config::Traction&) { return on_group(load.on.name, load.body); },
               [&](const config::PointForce& force) { return at_node(force, load.body); },
               [&](const config::BodyForce&) { return in_body(); }, [&](const config::Rotation&) { return in_body(); }},
      load.kind);
}

std::string KeyPlaces::part(const std::string& key) const {
  for (const char* list : {"loads", "supports", "contacts"})
    if (const auto index = index_in(key, list)) return fmt::format("{}[{}]", list, *index);
  std::string longest;  // names may begin with one another
  const auto take_if_longer = [&](const std::string& prefix) {
    if (key.starts_with(prefix + ".") && prefix.size() > longest.size()) longest = prefix;
  };
  for (const config::Material& material : config_.materials) take_if_longer("materials." + material.name);
  for (const config::Body& body : config_.bodies) take_if_longer("bodies." + body.name);
  return longest;
}

Places KeyPlaces::made(const std::string& part) const {
  if (const auto i = index_in(part, "loads"); i && *i < config_.loads.size()) return of_load(config_.loads[*i]);
  if (const auto i = index_in(part, "supports"); i && *i < config_.supports.size())
    return on_group(config_.supports[*i].on.name, config_.supports[*i].body);
  if (const auto i = index_in(part, "contacts"); i && *i < config_.contacts.size()) {
    Places both;
    for (const config::Reference& surface : config_.contacts[*i].between)
      std::ranges::copy(on_group(surface.name, {}), std::back_inserter(both));
    return both;
  }
  std::vector<std::size_t> bodies;
  for (std::size_t b = 0; b < config_.bodies.size(); ++b)
    if (part == "materials." + config_.bodies[b].material.name || part == "bodies." + config_.bodies[b].name)
      bodies.push_back(b);
  return on_bodies(bodies);
}

std::shared_ptr<const Places> KeyPlaces::of(const std::string& key) {
  const std::string part_of_key = part(key);
  std::shared_ptr<const Places>& known = known_[part_of_key];
  if (known) return known;
  Places places = made(part_of_key);
  if (places.empty() && !part_of_key.starts_with("materials.")) {
    std::vector<std::size_t> all(bodies_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    places = on_bodies(all);
  }
  known = std::make_shared<const Places>(std::move(places));
  return known;
}

std::vector<std::size_t> spread(const Places& places, std::size_t n) {
  std::vector<std::size_t> chosen;
  std::vector<double> distance(places.size(), std::numeric_limits<double>::infinity());
  const auto choose = [&](std::size_t i) {
    chosen.push_back(i);
    for (std::size_t k = 0; k < places.size(); ++k)
      distance[k] = std::min(distance[k], (places[k].position - places[i].position).squaredNorm());
  };
  constexpr std::size_t most_bodies = 16;
  std::size_t last_body = std::numeric_limits<std::size_t>::max();
  for (std::size_t i = 0; i < places.size() && chosen.size() < most_bodies; ++i)
    if (places[i].body != last_body) {
      last_body = places[i].body;
      choose(i);
    }
  while (chosen.size() < std::max(n, std::size_t{1}) && chosen.size() < places.size()) {
    const auto farthest = std::ranges::max_element(distance) - distance.begin();
    if (!(distance[farthest] > 0)) break;
    choose(static_cast<std::size_t>(farthest));
  }
  return chosen;
}

}  // namespace creepcontact::model
