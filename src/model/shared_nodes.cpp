#include "shared_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "creepcontact/base/disjoint_sets.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/contact/geometry/node_ties.hpp"
#include "tied_nodes.hpp"

namespace creepcontact::model {
namespace {

using BodyPair = std::pair<std::size_t, std::size_t>;

std::size_t n_bodies(const mesh::SharedMesh& shared) {
  std::size_t n = 0;
  for (const mesh::SharedNode& node : shared.nodes) n = std::max(n, node.owners.back().body + 1);
  return n;
}

std::string plural(std::size_t n) {
  return n == 1 ? "1 node" : fmt::format("{} nodes", n);
}

}  // namespace

std::array<std::size_t, 2> contact_bodies(const config::Contact& contact, const config::Config& config,
                                          const std::array<std::vector<std::size_t>, 2>& owners) {
  std::array<std::size_t, 2> body{owners[0].front(), owners[1].front()};
  if (body[0] != body[1]) return body;
  if (owners[1].size() > 1)
    body[1] = owners[1].back();
  else if (owners[0].size() > 1)
    body[0] = owners[0].back();
  else if (config.cyclic.empty() || contact.between[0].name == contact.between[1].name)
    throw ModelError(
        fmt::format("surfaces '{}' and '{}' belong to the same body '{}'; contact is between two bodies, "
                    "or across sectors of cyclic symmetry",
                    contact.between[0].name, contact.between[1].name, config.bodies[body[0]].name));
  return body;
}

SharedNodes::SharedNodes(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes,
                         mesh::SharedMesh shared)
    : shared_(std::move(shared)), links_(shared_.nodes.size()) {
  if (shared_.nodes.empty()) return;
  link_faces();
  for (const config::Contact& contact : config.contacts) cover(contact, config, whole, meshes);
}

void SharedNodes::link_faces() {
  for (const mesh::SharedFace& face : shared_.faces)
    for (const std::size_t node : face.nodes) {
      auto& links = links_[node];
      auto link = std::find_if(links.begin(), links.end(),
                               [&](const Link& one) { return one.first == face.first && one.second == face.second; });
      if (link == links.end()) link = links.insert(links.end(), {face.first, face.second, 0, false});
      link->area += face.area / static_cast<double>(face.nodes.size());
    }
}

void SharedNodes::cover(const config::Contact& contact, const config::Config& config, const mesh::Mesh& whole,
                        const BodyMeshes& meshes) {
  const auto owners = [&](std::size_t side) {
    return bodies_on(config, whole, meshes, contact.between[side].name, {}, whole.section.dimension() - 1);
  };
  const std::array<std::size_t, 2> sides = contact_bodies(contact, config, {owners(0), owners(1)});
  if (sides[0] == sides[1]) return;
  std::array<std::set<std::int64_t>, 2> surface;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto nodes = mesh::group_nodes(meshes[sides[side]], contact.between[side].name);
    surface[side].insert(nodes.begin(), nodes.end());
  }
  for (std::size_t i = 0; i < shared_.nodes.size(); ++i) {
    const auto is_on = [&](std::size_t side) {
      return std::any_of(shared_.nodes[i].owners.begin(), shared_.nodes[i].owners.end(), [&](const auto& owner) {
        return owner.body == sides[side] && surface[side].contains(owner.node);
      });
    };
    if (!is_on(0) || !is_on(1)) continue;
    const std::size_t first = std::min(sides[0], sides[1]), second = std::max(sides[0], sides[1]);
    auto link = std::find_if(links_[i].begin(), links_[i].end(),
                             [&](const Link& one) { return one.first == first && one.second == second; });
    if (link == links_[i].end()) link = links_[i].insert(links_[i].end(), {first, second, 0, false});
    link->covered = true;
  }
}

std::size_t SharedNodes::n_shared(std::size_t first, std::size_t second) const {
  return static_cast<std::size_t>(std::count_if(shared_.nodes.begin(), shared_.nodes.end(), [&](const auto& node) {
    const auto has = [&](std::size_t body) {
      return std::any_of(node.owners.begin(), node.owners.end(), [&](const auto& owner) { return owner.body == body; });
    };
    return has(first) && has(second);
  }));
}

void SharedNodes::check(const config::Config& config, ErrorCollector& errors) const {
  std::map<BodyPair, std::size_t> apart, at_edges;  // nodes
  for (std::size_t i = 0; i < links_.size(); ++i) {
    DisjointSets groups(n_bodies(shared_));
    for (const Link& link : links_[i]) {
      groups.join(link.first, link.second);
      if (!link.covered) ++apart[{link.first, link.second}];
    }
    const auto& owners = shared_.nodes[i].owners;
    for (std::size_t k = 1; k < owners.size(); ++k)
      if (groups.join(owners[k - 1].body, owners[k].body)) ++at_edges[{owners[k - 1].body, owners[k].body}];
  }
  const auto name = [&](std::size_t body) { return config.bodies[body].name; };
  const auto report = [&](const std::string& message) {
    errors.collect(config.mesh.location, [&] { throw ModelError(message); });
  };
  if (config.mesh.share_nodes == config::SharedNodes::error)
    for (const auto& [pair, n] : apart)
      report(
          fmt::format("bodies '{}' and '{}' share {} of the mesh, and no contact covers {}: the bodies would separate "
                      "there. Add a contact (or one with type = \"tied\") between the two surfaces; or tie all bodies "
                      "at shared nodes by mesh.share_nodes = \"tie\"; or make one body of the two regions, if they "
                      "have one material; or separate them in the geometry",
                      name(pair.first), name(pair.second), plural(n_shared(pair.first, pair.second)),
                      n == n_shared(pair.first, pair.second) ? "them" : fmt::format("{} of these", n)));
  for (const auto& [pair, n] : at_edges)
    report(
        fmt::format("bodies '{}' and '{}' share {} along an edge or at a point, and no face: nothing can hold them "
                    "together there; separate them in the geometry, or let them meet in a face",
                    name(pair.first), name(pair.second), plural(n)));
}

std::vector<SharedNodes::Joined> SharedNodes::joined() const {
  std::vector<Joined> result;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    DisjointSets groups(n_bodies(shared_));
    const auto of = [&](std::size_t body) {
      return *std::ranges::find(shared_.nodes[i].owners, body, &mesh::SharedNode::Owner::body);
    };
    for (const Link& link : links_[i])
      if (!link.covered && groups.join(link.first, link.second))
        result.push_back({of(link.first), of(link.second), link.area});
  }
  return result;
}

std::vector<contact::Pair> SharedNodes::ties(const config::Config& config, const Bodies& bodies) const {
  std::map<BodyPair, std::vector<contact::NodeTie>> ties;
  const auto is_turned = [&](const mesh::SharedNode::Owner& owner) {
    return bodies[owner.body].constraints().is_turned(owner.node);
  };
  for (const Joined& both : joined())
    // Nodes that follow others by cyclic symmetry are tied where those are.
    if (!(is_turned(both.first) && is_turned(both.second)))
      ties[{both.first.body, both.second.body}].push_back({both.first.node, both.second.node, both.area});
  std::vector<contact::Pair> pairs;
  for (const auto& [pair_of, nodes] : ties) {
    const mechanics::Body &slave = bodies[pair_of.first], &master = bodies[pair_of.second];
    require_same_supports(nodes, slave, master, config.time.output);
    contact::Pair pair;
    pair.name = fmt::format("shared nodes of '{}' and '{}'", slave.name(), master.name());
    pair.slave_body = pair_of.first;
    pair.master_body = pair_of.second;
    pair.coupling =
        contact::node_ties({&slave.mesh(), &slave.constraints()}, {&master.mesh(), &master.constraints()}, nodes);
    if (pair.coupling.n_rows() > 0) pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace creepcontact::model
