#include "model_links.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/mesh/point_tree.hpp"
#include "mean_motion.hpp"

namespace creepcontact::model {
namespace {

constexpr double same_position = 1e-6;  // of the size of the body

contact::Sector sector_of(const config::Cyclic& cyclic) {
  const Eigen::AngleAxisd turn(cyclic.angle * std::numbers::pi / 180, vector(cyclic.axis).normalized());
  return {turn.toRotationMatrix(), vector(cyclic.origin), static_cast<int>(std::lround(360 / cyclic.angle))};
}

bool has_group(const mesh::Mesh& mesh, const std::string& group) {
  const auto found = mesh.groups.find(group);
  return found != mesh.groups.end() && !found->second.cells.empty();
}

std::string names_of(const std::vector<config::Reference>& all) {
  std::string result;
  for (const config::Reference& one : all) result += (result.empty() ? "" : ", ") + one.name;
  return result;
}

double size_of(const mesh::Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3& x : mesh.nodes) box.extend(x);
  return box.diagonal().norm();
}

/// Nodes of `second` at the turned positions of those of `first`.
std::vector<mechanics::NodeLinks::Turned> matches(const mesh::Mesh& mesh, const std::vector<std::int64_t>& first,
                                                  const std::vector<std::int64_t>& second,
                                                  const contact::Sector& sector) {
  std::vector<Vector3> positions;
  positions.reserve(second.size());
  for (const std::int64_t node : second) positions.push_back(mesh.nodes[node]);
  const mesh::PointTree tree(positions);
  const double tolerance = same_position * size_of(mesh);
  std::vector<mechanics::NodeLinks::Turned> result;
  for (const std::int64_t node : first) {
    const mesh::Neighbour nearest = tree.nearest(sector.turned(mesh.nodes[node]), 1).front();
    if (nearest.distance <= tolerance) result.push_back({second[nearest.point], node, sector.rotation});
  }
  return result;
}

double largest_edge(const std::vector<mesh::Face>& faces, const mesh::Mesh& mesh) {
  double largest = 0;
  for (const mesh::Face& face : faces) {
    const auto corners = static_cast<std::size_t>(mesh::n_corners(face.type));
    for (std::size_t i = 0; i < corners; ++i)
      largest = std::max(largest, (mesh.nodes[face.nodes[i]] - mesh.nodes[face.nodes[(i + 1) % corners]]).norm());
  }
  return largest;
}

/// The angle of the mean position of the nodes about the axis, in degrees.
double mean_angle(const mesh::Mesh& mesh, const std::vector<std::int64_t>& nodes, const config::Cyclic& cyclic) {
  const Vector3 axis = vector(cyclic.axis).normalized(), across = axis.unitOrthogonal();
  Vector3 mean = Vector3::Zero();
  for (const std::int64_t node : nodes) mean += mesh.nodes[node] - vector(cyclic.origin);
  return std::atan2(axis.cross(across).dot(mean), across.dot(mean)) * 180 / std::numbers::pi;
}

/// Faces that are tied must lie on each other, whatever their meshes.
void require_same_place(const mesh::Mesh& mesh, const config::Cyclic& cyclic, const std::vector<std::int64_t>& first,
                        const std::vector<std::int64_t>& second) {
  const contact::Sector sector = sector_of(cyclic);
  std::vector<Vector3> turned;
  turned.reserve(first.size());
  for (const std::int64_t node : first) turned.push_back(sector.turned(mesh.nodes[node]));
  const mesh::PointTree tree(turned);
  double farthest = 0;
  for (const std::int64_t node : second)
    farthest = std::max(farthest, tree.nearest(mesh.nodes[node], 1).front().distance);
  const double edge = std::max(largest_edge(mesh::boundary_faces(mesh, cyclic.between[0].name), mesh),
                               largest_edge(mesh::boundary_faces(mesh, cyclic.between[1].name), mesh));
  if (farthest <= edge) return;
  const double between = std::remainder(mean_angle(mesh, second, cyclic) - mean_angle(mesh, first, cyclic), 360);
  throw ModelError(
      fmt::format("'{}' turned by {:.6g} degrees does not lie on '{}': it is up to {:.4g} away; the angle "
                  "between the two faces is about {:.6g} degrees",
                  cyclic.between[0].name, cyclic.angle, cyclic.between[1].name, farthest, between));
}

class LinkMaker {
 public:
  LinkMaker(const config::Config& config, const mesh::Mesh& whole, BodyMeshes& meshes)
      : config_(config), whole_(whole), meshes_(meshes) {
    links_.of_body.resize(meshes.size());
  }

  void add(std::size_t index) {
    const config::Cyclic& cyclic = config_.cyclic[index];
    if (config_.analysis == settings::Analysis::axisymmetric)
      throw ModelError("an axisymmetric model has no sectors; remove [[cyclic]]");
    if (whole_.section.dimension() == 2 && !vector(cyclic.axis).normalized().cwiseAbs().isApprox(Vector3::UnitZ()))
      throw ModelError("the axis of a plane section is [0, 0, 1]");
    const auto bodies = [&](std::size_t side) {
      return bodies_on(config_, whole_, meshes_, cyclic.between[side].name, {}, whole_.section.dimension() - 1);
    };
    const std::vector<std::size_t> first = bodies(0), second = bodies(1);
    for (const std::size_t b : first)
      if (!has_group(meshes_[b], cyclic.between[1].name))
        throw ModelError(fmt::format("body '{}' has the face '{}' but not '{}'", config_.bodies[b].name,
                                     cyclic.between[0].name, cyclic.between[1].name));
    for (const std::size_t b : second)
      if (!has_group(meshes_[b], cyclic.between[0].name))
        throw ModelError(fmt::format("body '{}' has the face '{}' but not '{}'", config_.bodies[b].name,
                                     cyclic.between[1].name, cyclic.between[0].name));
    for (const std::size_t b : first) link(index, b);
  }

  void add(const config::Rigid& rigid) {
    std::map<std::size_t, std::set<std::int64_t>> nodes;  // by body
    for (const config::Reference& on : rigid.on)
      for (const std::size_t b : bodies_on(config_, whole_, meshes_, on.name, {}, -1))
        for (const std::int64_t node : mesh::group_nodes(meshes_[b], on.name)) nodes[b].insert(node);
    const Vector3 origin = rigid.origin ? vector(*rigid.origin) : mean_position(nodes);
    std::vector<ModelLinks::RigidPart>& parts = links_.rigid.emplace_back();
    for (const auto& [b, of_body] : nodes) {
      mechanics::NodeLinks::Rigid link{
          names_of(rigid.on), {of_body.begin(), of_body.end()}, origin, rigid.displacement, rigid.rotation};
      if (meshes_[b].section.is_axisymmetric()) {  // a ring that moves without strain moves along the axis
        link.displacement[0] = 0.0;
        link.rotation = {0.0, 0.0, 0.0};
      }
      parts.push_back({b, links_.of_body[b].rigid.size()});
      links_.of_body[b].rigid.push_back(std::move(link));
    }
  }

  Vector3 mean_position(const std::map<std::size_t, std::set<std::int64_t>>& nodes) const {
    Vector3 sum = Vector3::Zero();
    double count = 0;
    for (const auto& [b, of_body] : nodes)
      for (const std::int64_t node : of_body) {
        sum += meshes_[b].nodes[static_cast<std::size_t>(node)];
        ++count;
      }
    return sum / std::max(count, 1.0);
  }

  ModelLinks& links() { return links_; }

 private:
  void link(std::size_t index, std::size_t b) {
    const config::Cyclic& cyclic = config_.cyclic[index];
    const mesh::Mesh& mesh = meshes_[b];
    const auto first = mesh::group_nodes(mesh, cyclic.between[0].name),
               second = mesh::group_nodes(mesh, cyclic.between[1].name);
    std::vector<mechanics::NodeLinks::Turned> found = matches(mesh, first, second, sector_of(cyclic));
    const auto nodes = [&] {
      std::set<std::int64_t> linked;
      for (const auto& one : found) linked.insert(one.node);
      return linked;
    };
    if (found.size() == first.size() && nodes().size() == second.size()) {
      log::info("body '{}': all {} nodes of '{}' match those of '{}'", config_.bodies[b].name, second.size(),
                cyclic.between[1].name, cyclic.between[0].name);
      return add(found, nodes(), cyclic, b);
    }
    if (matches(mesh, second, first, sector_of(cyclic)).size() > found.size())
      throw ModelError(fmt::format("'{}' is '{}' turned by {:.6g} degrees, not by {:.6g}: exchange the two faces",
                                   cyclic.between[1].name, cyclic.between[0].name, -cyclic.angle, cyclic.angle));
    require_same_place(mesh, cyclic, first, second);
    log::info("body '{}': {} of the {} nodes of '{}' match nodes of '{}'; the faces are tied by the mortar method",
              config_.bodies[b].name, nodes().size(), second.size(), cyclic.between[1].name, cyclic.between[0].name);
    // Inside the face nodes that match by chance are left to the mortar method. At its border, where other surfaces
    // begin, the sector is joined to the next one as exactly as it can be.
    const std::set<std::int64_t> border = mesh::border_nodes(mesh::boundary_faces(mesh, cyclic.between[1].name));
    std::erase_if(found, [&](const auto& one) { return !border.contains(one.node); });
    add(found, nodes(), cyclic, b);
    links_.unmatched.push_back({index, b});
  }

  void add(const std::vector<mechanics::NodeLinks::Turned>& found, const std::set<std::int64_t>& linked,
           const config::Cyclic& cyclic, std::size_t b) {
    mechanics::NodeLinks& links = links_.of_body[b];
    for (const auto& old : links.turned)
      if (linked.contains(old.node) || linked.contains(old.of))
        throw ModelError(fmt::format("nodes of '{}' belong to two faces of cyclic symmetry", cyclic.between[1].name));
    links.turned.insert(links.turned.end(), found.begin(), found.end());
    // To the last bit: otherwise the rotation about the axis would strain the sector.
    const contact::Sector sector = sector_of(cyclic);
    for (const auto& one : found)
      if (one.node != one.of) meshes_[b].nodes[one.node] = sector.turned(meshes_[b].nodes[one.of]);
    for (const config::Reference& face : cyclic.between) links.turned_faces.push_back(face.name);
  }

  const config::Config& config_;
  const mesh::Mesh& whole_;
  BodyMeshes& meshes_;
  ModelLinks links_;
};

}  // namespace

std::optional<contact::Sector> sector(const config::Config& config) {
  if (config.cyclic.empty()) return std::nullopt;
  return sector_of(config.cyclic.front());
}

ModelLinks make_links(const config::Config& config, const mesh::Mesh& whole, BodyMeshes& meshes,
                      ErrorCollector& errors) {
  LinkMaker maker(config, whole, meshes);
  for (std::size_t i = 0; i < config.cyclic.size(); ++i)
    errors.collect(config.cyclic[i].location, [&] { maker.add(i); });
  for (const config::Rigid& rigid : config.rigid) errors.collect(rigid.location, [&] { maker.add(rigid); });
  return std::move(maker.links());
}

namespace {

const char* const component_words[] = {"displacement along x", "displacement along y", "displacement along z",
                                       "rotation about x",     "rotation about y",     "rotation about z"};

const std::optional<Function>& prescribed(const config::Rigid& motion, int component) {
  return component < 3 ? motion.displacement[static_cast<std::size_t>(component)]
                       : motion.rotation[static_cast<std::size_t>(component - 3)];
}

MeanMotion motion_of(const BodyMeshes& meshes, const config::Rigid& coupling) {
  std::vector<WeightedNodes> parts;
  for (const config::Reference& on : coupling.on) {
    bool is_somewhere = false;
    for (std::size_t b = 0; b < meshes.size(); ++b)
      if (has_group(meshes[b], on.name)) {
        parts.push_back(weighted_nodes(b, meshes[b], on.name));
        is_somewhere = true;
      }
    if (!is_somewhere) throw ModelError(fmt::format("no body has the surface '{}'", on.name));
  }
  Vector3 mean = Vector3::Zero();
  double sum = 0;
  for (const WeightedNodes& part : parts)
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
      mean += part.weights[i] * meshes[part.body].nodes[static_cast<std::size_t>(part.nodes[i])];
      sum += part.weights[i];
    }
  return {parts, meshes, coupling.origin ? vector(*coupling.origin) : Vector3(mean / sum)};
}

MeanMotion motion_of(const BodyMeshes& meshes, const ModelLinks& links, const ModelLinks::RigidPart& part) {
  const mechanics::NodeLinks::Rigid& link = links.of_body[part.body].rigid[part.link];
  return {{equally_weighted(part.body, link.nodes)}, meshes, link.origin};
}

/// Where the nodes do not tell a component that something is said of.
void require_known(const MeanMotion& motion, const config::Rigid& given, const BodyMeshes& meshes) {
  for (int k = 0; k < 6; ++k) {
    const Function& load =
        k < 3 ? given.force[static_cast<std::size_t>(k)] : given.moment[static_cast<std::size_t>(k - 3)];
    if (motion.knows(k) || (!prescribed(given, k) && load.is_zero())) continue;
    throw ModelError(fmt::format("{}: the {} is not that of its nodes{}; name a surface, or more of them",
                                 names_of(given.on), component_words[k],
                                 meshes.front().section.dimension() == 2 ? ", which move in the plane of the section"
                                                                         : ", which lie on one line"));
  }
}

}  // namespace

void add_motion_loads(const config::Config& config, const BodyMeshes& meshes, const ModelLinks& links, Bodies& bodies,
                      ErrorCollector& errors) {
  for (std::size_t i = 0; i < config.rigid.size(); ++i) {
    const config::Rigid& rigid = config.rigid[i];
    if (links.rigid.size() <= i || links.rigid[i].empty()) continue;
    errors.collect(rigid.location, [&] {  // of all that move together the first part takes them
      motion_of(meshes, links, links.rigid[i].front()).add_loads(rigid.force, rigid.moment, bodies);
    });
  }
  for (const config::Rigid& coupling : config.coupling)
    errors.collect(coupling.location, [&] {
      const MeanMotion motion = motion_of(meshes, coupling);
      require_known(motion, coupling, meshes);
      motion.add_loads(coupling.force, coupling.moment, bodies);
    });
}

std::vector<MotionEquation> motion_equations(const config::Config& config, const BodyMeshes& meshes,
                                             const ModelLinks& links, ErrorCollector& errors) {
  std::vector<MotionEquation> result;
  for (std::size_t i = 0; i < config.rigid.size() && i < links.rigid.size(); ++i) {
    const config::Rigid& rigid = config.rigid[i];
    const std::vector<ModelLinks::RigidPart>& parts = links.rigid[i];
    for (std::size_t p = 1; p < parts.size(); ++p)
      errors.collect(rigid.location, [&] {
        const MeanMotion first = motion_of(meshes, links, parts[0]), other = motion_of(meshes, links, parts[p]);
        for (int k = 0; k < 6; ++k) {
          if (prescribed(rigid, k) || !(first.knows(k) || other.knows(k))) continue;
          if (!first.knows(k) || !other.knows(k))
            throw ModelError(
                fmt::format("the nodes on body '{}' lie on one line, about which they turn freely; name a "
                            "surface of it",
                            config.bodies[(first.knows(k) ? parts[p] : parts[0]).body].name));
          result.push_back({&rigid.location,
                            parts[p].body,
                            parts[0].body,
                            {other.terms(parts[p].body, k, 1), first.terms(parts[0].body, k, -1)},
                            0.0});
        }
      });
  }
  for (const config::Rigid& coupling : config.coupling)
    errors.collect(coupling.location, [&] {
      const MeanMotion motion = motion_of(meshes, coupling);
      for (int k = 0; k < 6; ++k) {
        if (!prescribed(coupling, k) || !motion.knows(k)) continue;
        const std::vector<std::size_t>& bodies = motion.bodies();
        if (bodies.size() > 2)
          throw ModelError(fmt::format("{}: {} bodies; the motion of a coupling is prescribed for at most two",
                                       names_of(coupling.on), bodies.size()));
        MotionEquation one{&coupling.location, bodies.front(), bodies.back(), {}, *prescribed(coupling, k)};
        one.equation.slave = motion.terms(bodies.front(), k, 1);
        if (bodies.size() == 2) one.equation.master = motion.terms(bodies.back(), k, 1);
        result.push_back(std::move(one));
      }
    });
  return result;
}

namespace {

/// Nodes of a body that links or multipliers of contacts act on.
std::vector<std::int64_t> constrained_otherwise(const mechanics::Body& body, std::size_t number,
                                                const std::vector<contact::Pair>& pairs) {
  std::set<std::int64_t> nodes;
  for (const mechanics::NodeLinks::Turned& link : body.constraints().links().turned) nodes.insert(link.node);
  for (const contact::Pair& pair : pairs)
    if (pair.slave_body == number)
      for (const contact::MultiplierNode& at : pair.coupling.nodes) nodes.insert(at.node);
  return {nodes.begin(), nodes.end()};
}

}  // namespace

std::string sector_tie_name(const config::Config& config, const ModelLinks::UnmatchedFace& faces) {
  const config::Cyclic& cyclic = config.cyclic[faces.cyclic];
  return fmt::format("faces '{}' and '{}' of body '{}'", cyclic.between[0].name, cyclic.between[1].name,
                     config.bodies[faces.body].name);
}

void append_sector_ties(const config::Config& config, const ModelLinks& links, const Bodies& bodies,
                        std::vector<contact::Pair>& pairs, ErrorCollector& errors) {
  for (const ModelLinks::UnmatchedFace& unmatched : links.unmatched) {
    const config::Cyclic& cyclic = config.cyclic[unmatched.cyclic];
    errors.collect(cyclic.location, [&] {
      const mechanics::Body& body = bodies[unmatched.body];
      const auto surface = [&](const std::string& name) {
        return contact::Surface{name, &body.mesh(),  &body.constraints(), mesh::boundary_faces(body.mesh(), name),
                                1,    sector(config)};
      };
      contact::Surface slave = surface(cyclic.between[1].name);
      slave.joining = constrained_otherwise(body, unmatched.body, pairs);
      contact::Pair pair;
      pair.name = sector_tie_name(config, unmatched);
      pair.slave_body = pair.master_body = unmatched.body;
      pair.coupling = contact::mortar_coupling(slave, surface(cyclic.between[0].name), contact::ContactType::tied);
      pairs.push_back(std::move(pair));
    });
  }
}

}  // namespace creepcontact::model
