#include "creepcontact/results/heat_flows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/creep/joint_values.hpp"
#include "probe_kinds.hpp"

namespace creepcontact::results {
namespace {

using FaceNodes = std::vector<std::int64_t>;

/// Nodes of a face in ascending order, each once: strips have them twice.
FaceNodes key_of(std::span<const std::int64_t> nodes) {
  FaceNodes key(nodes.begin(), nodes.end());
  std::ranges::sort(key);
  key.erase(std::unique(key.begin(), key.end()), key.end());
  return key;
}

class HeatFlowProbe final : public Probe {
 public:
  explicit HeatFlowProbe(SurfaceHeat heat) : heat_(std::move(heat)) {}
  double value(Snapshot& snapshot) const override { return heat_.outwards(snapshot); }

 private:
  mutable SurfaceHeat heat_;  // its work space does not belong to its value
};

}  // namespace

HeatFlows::HeatFlows(const creep::Assembly& assembly) : HeatFlows(assembly, *assembly.conduction()) {}
HeatFlows::HeatFlows(const creep::Assembly& assembly, const heat::Definition& definition)
    : assembly_(assembly), problem_(definition) {}

heat::Balance HeatFlows::at(Snapshot& snapshot) {
  const creep::JointValues joint = creep::joint_values(assembly_, snapshot.equilibrium());
  std::vector<double> T = problem_.unknowns(snapshot.computed_temperatures()), rate(T.size(), 0.0);
  if (!assembly_.has_steady_heat()) problem_.make_consistent(snapshot.time(), T, rate, joint);
  return problem_.balance(snapshot.time(), T, rate, joint);
}

double HeatFlows::scale(Snapshot& snapshot) {
  return problem_.flow_scale(snapshot.time(), problem_.unknowns(snapshot.computed_temperatures()),
                             creep::joint_values(assembly_, snapshot.equilibrium()));
}

SurfaceHeat::SurfaceHeat(const creep::Assembly& assembly, const std::string& group, std::optional<std::size_t> body) {
  const std::vector<mechanics::Body>& bodies = assembly.bodies();
  std::vector<std::set<FaceNodes>> faces(bodies.size());
  std::vector<std::set<std::int64_t>> nodes(bodies.size());
  bool any = false;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (body.value_or(b) != b || !bodies[b].mesh().groups.contains(group)) continue;
    for (const mesh::Face& face : mesh::boundary_faces(bodies[b].mesh(), group)) {
      faces[b].insert(key_of(face.nodes));
      nodes[b].insert(face.nodes.begin(), face.nodes.end());
      any = true;
    }
  }
  if (!any) throw ModelError(fmt::format("no body has faces in a group '{}'", group));

  heat::Definition all = *assembly.conduction();
  const auto split = [](auto& list, std::vector<std::size_t>& parts, const auto& take) {
    auto from = std::exchange(list, {});
    for (auto& one : from) {
      auto inside = take(one);  // which leaves the rest
      parts.push_back(list.size());
      list.push_back(std::move(inside));
      list.push_back(std::move(one));
    }
  };
  split(all.flows, flow_parts_, [&](heat::SurfaceFlow& flow) {
    heat::SurfaceFlow inside = flow;
    std::erase_if(inside.faces, [&](const mesh::Face& face) { return !faces[flow.body].contains(key_of(face.nodes)); });
    std::erase_if(flow.faces, [&](const mesh::Face& face) { return faces[flow.body].contains(key_of(face.nodes)); });
    return inside;
  });
  split(all.given, given_parts_, [&](heat::GivenTemperature& given) {
    heat::GivenTemperature inside = given;
    // A surface next to one whose temperature is given shares an edge with it: what its nodes need is not the
    // surface's.
    const std::set<std::int64_t> held(given.nodes.begin(), given.nodes.end());
    std::set<std::int64_t> whole;
    for (const FaceNodes& face : faces[given.body])
      if (std::ranges::all_of(face, [&](std::int64_t node) { return held.contains(node); }))
        whole.insert(face.begin(), face.end());
    std::erase_if(inside.nodes, [&](std::int64_t node) { return !whole.contains(node); });
    std::erase_if(given.nodes, [&](std::int64_t node) { return whole.contains(node); });
    return inside;
  });
  split(all.point_flows, point_parts_, [&](heat::PointFlow& flow) {
    heat::PointFlow inside = flow;
    const auto is_inside = [&](const heat::BodyNode& at) { return nodes[at.body].contains(at.node); };
    std::erase_if(inside.nodes, [&](const heat::BodyNode& at) { return !is_inside(at); });
    std::erase_if(flow.nodes, is_inside);
    return inside;
  });
  for (const bool is_first : {true, false}) {
    std::vector<std::size_t> parts;
    split(all.interfaces, parts, [&](heat::Interface& interface) {
      heat::Interface inside = interface;
      const auto is_inside = [&](const contact::FacingFaces& both) {
        return is_first ? faces[interface.first].contains(key_of(both.first_nodes))
                        : faces[interface.second].contains(key_of(both.second_nodes));
      };
      std::erase_if(inside.faces, [&](const contact::FacingFaces& both) { return !is_inside(both); });
      std::erase_if(interface.faces, is_inside);
      return inside;
    });
    // The second pass has split the parts of the first one, too.
    for (auto& [part, sign] : interface_parts_) part *= 2;
    const std::size_t n_before = interface_parts_.size();
    for (std::size_t k = 0; k < n_before; ++k)
      interface_parts_.emplace_back(interface_parts_[k].first + 1, interface_parts_[k].second);
    for (const std::size_t part : parts) interface_parts_.emplace_back(part, is_first ? 1.0 : -1.0);
  }
  flows_ = std::make_unique<HeatFlows>(assembly, all);
}

double SurfaceHeat::outwards(Snapshot& snapshot) {
  const heat::Balance balance = flows_->at(snapshot);
  double inwards = 0;
  for (const std::size_t i : flow_parts_) inwards += balance.flows[i];
  for (const std::size_t i : point_parts_) inwards += balance.points[i];
  for (const std::size_t i : given_parts_) inwards += balance.given[i];
  for (const auto& [i, sign] : interface_parts_) inwards -= sign * balance.interfaces[i];
  return -inwards;
}

std::unique_ptr<Probe> make_probe(const ThroughSurface& /*surface*/, const ProbeRequest& request) {
  std::optional<std::size_t> body;
  if (request.probe.body.given()) body = model::find_body(request.model.bodies(), request.probe.body.name);
  return std::make_unique<HeatFlowProbe>(SurfaceHeat(request.model.assembly, request.probe.on.name, body));
}

}  // namespace creepcontact::results
