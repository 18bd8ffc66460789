#include <Eigen/Geometry>
#include <map>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/mechanics/cut.hpp"
#include "face_points.hpp"
#include "probe_kinds.hpp"

namespace creepcontact::results {
namespace {

FaceArea area_beyond(const mechanics::Cut& cut, const mesh::Face& face) {
  const mechanics::Cut::FaceArea found = cut.area(face);
  return {found.beyond, found.whole};
}

/// A node of which a share of the force acts beyond the plane.
struct NodeShare {
  std::int64_t node;
  double share;
};

/// Those of which any does: the forces of nodes on the faces are spread over them, the others act at their node.
/// @param except  nodes that do not count
std::vector<NodeShare> shares_beyond(const mechanics::Cut& cut, const std::vector<mesh::Face>& faces,
                                     const std::map<std::int64_t, Matrix3>& except = {}) {
  const auto on_faces = node_shares(faces, [&](const mesh::Face& face) { return area_beyond(cut, face); });
  std::vector<NodeShare> shares;
  for (std::int64_t node = 0; node < std::ssize(cut.mesh().nodes); ++node) {
    if (node == cut.mesh().axial_node || except.contains(node)) continue;
    const auto spread = on_faces.find(node);
    const double share = spread != on_faces.end() ? spread->second : cut.node_share(node);
    if (share != 0) shares.push_back({node, share});
  }
  return shares;
}

/// Empty if the support does not hold a surface, or one inside the body: its forces then act at the nodes.
std::vector<mesh::Face> supported_faces(const mesh::Mesh& mesh, const std::string& surface) {
  const auto group = mesh.groups.find(surface);
  if (group == mesh.groups.end() || group->second.dimension != mesh.section.dimension() - 1) return {};
  try {
    return mesh::boundary_faces(mesh, surface);
  } catch (const ModelError&) {
    return {};
  }
}

/// Areas beyond the plane, for the nodes of a surface.
std::map<std::int64_t, FaceArea> areas_beyond(const mechanics::Cut& cut, const std::string& surface) {
  return areas_around(supported_faces(cut.mesh(), surface),
                      [&](const mesh::Face& face) { return area_beyond(cut, face); });
}

/// The part of a reaction that acts beyond the plane, as a linear map of it; by node. A node may have several supports,
/// each with the reaction along its own direction: at the edge of a plane of symmetry, that of the plane and others.
std::map<std::int64_t, Matrix3> reactions_beyond(const mechanics::Cut& cut, const mechanics::Body& body) {
  struct Sums {
    Matrix3 beyond = Matrix3::Zero(), whole = Matrix3::Zero();
  };
  std::map<std::int64_t, Sums> sums;
  const auto add = [&](std::int64_t node, const FaceArea& area, const Matrix3& directions) {
    sums[node].beyond += area.part * directions;
    sums[node].whole += area.whole * directions;
  };
  for (const mechanics::Support& support : body.supports()) {
    const std::map<std::int64_t, FaceArea> areas = areas_beyond(cut, support.on);
    for (std::size_t i = 0; i < support.nodes.size(); ++i) {
      const std::int64_t node = support.nodes[i];
      if (node == cut.mesh().axial_node) continue;  // it is at no place
      const Vector3& along = support.directions[support.directions.size() == 1 ? 0 : i];
      const auto spread = areas.find(node);
      add(node, spread != areas.end() ? spread->second : FaceArea{cut.node_share(node), 1}, along * along.transpose());
    }
  }
  // Surfaces whose nodes are linked exert forces of any direction.
  const mechanics::NodeLinks& links = body.constraints().links();
  std::vector<std::string> linked = links.turned_faces;
  for (const mechanics::NodeLinks::Rigid& rigid : links.rigid) linked.push_back(rigid.on);
  for (const std::string& surface : linked)
    for (const auto& [node, area] : areas_beyond(cut, surface)) add(node, area, Matrix3::Identity());
  std::map<std::int64_t, Matrix3> maps;
  for (const auto& [node, sum] : sums) {
    const Matrix3 inverse = linalg::symmetric_pseudo_inverse(sum.whole);
    maps[node] = sum.beyond * inverse + cut.node_share(node) * (Matrix3::Identity() - sum.whole * inverse);
  }
  return maps;
}

/// The forces on the part of a body beyond a plane: reactions and contact forces at nodes, and loads integrated up to
/// the plane. Because of equilibrium, this is what the part exerts on the rest.
class SectionProbe final : public Probe {
 public:
  SectionProbe(const mechanics::Cut& cut, std::size_t body, const model::Model& model, const OnPlane& plane,
               const Quantity& quantity, const Vector3& about)
      : body_(body),
        plane_(plane),
        quantity_(quantity),
        about_(about),
        at_supports_(reactions_beyond(cut, model.bodies()[body])),
        at_nodes_(shares_beyond(cut, {}, at_supports_)),
        loads_(model.bodies()[body].loads_beyond(cut)) {
    const std::vector<contact::Pair>& pairs = model.pairs();
    for (std::size_t p = 0; p < pairs.size(); ++p)
      for (const bool is_slave : {true, false}) {
        if ((is_slave ? pairs[p].slave_body : pairs[p].master_body) != body) continue;
        const std::string& surface = is_slave ? pairs[p].slave_surface : pairs[p].master_surface;
        const auto faces =
            pairs[p].ties_nodes() ? std::vector<mesh::Face>() : mesh::boundary_faces(cut.mesh(), surface);
        const contact::MortarCoupling& coupling = pairs[p].coupling;
        contacts_.push_back({p, resultants(cut.mesh(), is_slave ? coupling.slave_rows : coupling.master_rows,
                                           shares_beyond(cut, faces))});
      }
  }

  double value(Snapshot& snapshot) const override {
    const creep::Equilibrium& at = snapshot.equilibrium();
    Resultant own;  // of this process
    add_reactions(snapshot, own);
    for (const mechanics::PointForces& load : loads_)
      load.add(at.conditions[body_].time, about_, own.force, own.moment);
    Resultant common;  // all members of a team know the state of the contacts
    for (const Contact& contact : contacts_) {
      const contact::Pair& pair = snapshot.assembly().pairs()[contact.pair];
      const Tensor6 sum = contact.resultants * at.contact.multiplier.segment(pair.first_row, pair.coupling.n_rows());
      common.force += sum.head<3>();
      common.moment += sum.tail<3>();
    }
    return snapshot.assembly().team().sum(component(own)) + component(common);
  }

 private:
  struct Contact {
    std::size_t pair;
    Eigen::Matrix<double, 6, Eigen::Dynamic> resultants;  // force and moment of each row's unit multiplier
  };
  Eigen::Matrix<double, 6, Eigen::Dynamic> resultants(const mesh::Mesh& mesh, const contact::RowMatrix& rows,
                                                      const std::vector<NodeShare>& shares) const {
    std::vector<double> share_of(mesh.nodes.size(), 0.0);
    for (const auto& [node, share] : shares) share_of[static_cast<std::size_t>(node)] = share;
    Eigen::Matrix<double, 6, Eigen::Dynamic> result(6, rows.rows());
    for (Index row = 0; row < rows.rows(); ++row) {
      Resultant sum;
      for (contact::RowMatrix::InnerIterator it(rows, row); it; ++it) {
        const auto node = static_cast<std::size_t>(it.col() / 3);
        if (share_of[node] != 0)
          add(mesh.nodes[node] - about_, share_of[node] * it.value() * Vector3::Unit(it.col() % 3), sum);
      }
      result.col(row) << sum.force, sum.moment;
    }
    return result;
  }
  static void add(const Vector3& arm, const Vector3& force, Resultant& into) {
    into.force += force;
    into.moment += arm.cross(force);
  }

  double component(const Resultant& resultant) const {
    return quantity_.of([&](double* into) { plane_.evaluate(resultant, into); });
  }

  void add_reactions(Snapshot& snapshot, Resultant& into) const {
    const std::vector<double>& reactions = snapshot.reactions(body_);
    const Eigen::Map<const Eigen::VectorXd> forces(reactions.data(), std::ssize(reactions));
    const mesh::Mesh& mesh = snapshot.assembly().bodies()[body_].mesh();
    for (const auto& [node, share] : at_nodes_)
      add(mesh.nodes[node] - about_, share * forces.segment<3>(3 * node), into);
    for (const auto& [node, share] : at_supports_)
      add(mesh.nodes[node] - about_, share * forces.segment<3>(3 * node), into);
  }

  std::size_t body_;
  OnPlane plane_;
  const Quantity& quantity_;
  Vector3 about_;
  std::map<std::int64_t, Matrix3> at_supports_;
  std::vector<NodeShare> at_nodes_;  // of all others
  std::vector<mechanics::PointForces> loads_;
  std::vector<Contact> contacts_;
};

Vector3 to_vector(const std::array<double, 3>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

std::unique_ptr<Probe> make_probe(const OnPlane& plane, const ProbeRequest& request) {
  const config::Probe& probe = request.probe;
  const model::Model& model = request.model;
  const std::size_t body = model::find_body(model.bodies(), probe.body.name);
  const mechanics::Cut cut(model.bodies()[body].mesh(), to_vector(probe.section->origin),
                           to_vector(probe.section->normal));
  return std::make_unique<SectionProbe>(cut, body, model, plane, request.quantity, to_vector(probe.origin));
}

}  // namespace creepcontact::results
