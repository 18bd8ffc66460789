#include <fmt/format.h>

#include <deque>
#include <set>

#include "contact_part.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/closed_nodes.hpp"
#include "creepcontact/contact/geometry/contact_area.hpp"
#include "creepcontact/results/contact_values.hpp"
#include "probe_kinds.hpp"
#include "probe_part.hpp"

namespace creepcontact::results {
namespace {

class AreaProbe final : public Probe {
 public:
  AreaProbe(std::vector<ContactPart> sides, const model::Model& model) : sides_(std::move(sides)) {
    const std::vector<contact::Pair>& pairs = model.pairs();
    for (const ContactPart& side : sides_)
      areas_.emplace_back(pairs[side.pair], model.bodies()[pairs[side.pair].slave_body].mesh());
  }

  double value(Snapshot& snapshot) const override {
    double sum = 0;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const contact::Pair& pair = snapshot.assembly().pairs()[sides_[i].pair];
      const Eigen::Map<const Eigen::VectorXd> shares(sides_[i].multiplier_shares.data(),
                                                     std::ssize(pair.coupling.nodes));
      if (pair.coupling.type == contact::ContactType::tied)
        sum += shares.dot(Eigen::Map<const Eigen::VectorXd>(pair.coupling.area.data(), shares.size()));
      else
        sum += shares.dot(areas_[i].of_nodes(contact::closed_nodes(pair, snapshot.equilibrium().contact),
                                             PairValues(pair, snapshot.equilibrium()).open_gaps()));
    }
    return sum;
  }

 private:
  std::vector<ContactPart> sides_;
  std::deque<contact::ContactArea> areas_;  // which are not to be moved
};

/// Values at multiplier nodes.
class MultiplierProbe final : public Probe {
 public:
  MultiplierProbe(std::vector<ContactPart> sides, const AtMultipliers& multipliers, config::Reduce reduce)
      : sides_(std::move(sides)), multipliers_(multipliers), reduce_(reduce) {}

  double value(Snapshot& snapshot) const override {
    const bool is_extreme = reduce_ == config::Reduce::max || reduce_ == config::Reduce::min;
    Reduction reduction(reduce_);
    for (const ContactPart& side : sides_) {
      const contact::Pair& pair = snapshot.assembly().pairs()[side.pair];
      const PairValues values(pair, snapshot.equilibrium(), snapshot.heat_of_contact());
      for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
        if (is_extreme ? side.lies_within[i] == 0 : side.multiplier_shares[i] == 0) continue;
        reduction.add(values[i].*multipliers_.value, side.multiplier_shares[i] * pair.coupling.area[i]);
      }
    }
    // All members of a team know the state of the contacts.
    return reduction.result(serial_team());
  }

 private:
  std::vector<ContactPart> sides_;
  AtMultipliers multipliers_;
  config::Reduce reduce_;
};

/// Force and moment of the contact on the body of a surface.
class ContactResultantProbe final : public Probe {
 public:
  ContactResultantProbe(std::vector<ContactPart> sides, const OnContactSurface& surface, const ProbeRequest& request)
      : sides_(std::move(sides)),
        surface_(surface),
        quantity_(request.quantity),
        origin_(Eigen::Map<const Vector3>(request.probe.origin.data())) {}

  double value(Snapshot& snapshot) const override {
    double sum = 0;
    for (const ContactPart& side : sides_)
      sum += quantity_.of([&](double* into) { surface_.evaluate(resultant(snapshot, side), into); });
    return sum;
  }

 private:
  Resultant resultant(const Snapshot& snapshot, const ContactPart& side) const {
    const contact::Pair& pair = snapshot.assembly().pairs()[side.pair];
    const contact::RowMatrix& rows = side.is_slave ? pair.coupling.slave_rows : pair.coupling.master_rows;
    const Eigen::VectorXd forces =
        rows.transpose() * snapshot.equilibrium().contact.multiplier.segment(pair.first_row, pair.coupling.n_rows());
    const std::vector<Vector3>& nodes = snapshot.assembly().bodies()[side.body].mesh().nodes;
    Resultant sum;
    for (Index i = 0; i < forces.size(); i += 3) {
      const Vector3 force = side.node_shares[i / 3] * forces.segment<3>(i);
      if (force.isZero(0)) continue;
      sum.force += force;
      sum.moment += (nodes[i / 3] - origin_).cross(force);
    }
    return sum;
  }

  std::vector<ContactPart> sides_;
  OnContactSurface surface_;
  const Quantity& quantity_;
  Vector3 origin_;
};

/// Forces at the nodes of one body, some of them turned.
struct NodalSum {
  std::size_t body = 0;
  std::vector<std::pair<std::int64_t, Matrix3>> nodes;
};

/// The forces of supports on these nodes. What a sector exerts on the next one is not a reaction: forces at nodes
/// that follow others by cyclic symmetry count at these others.
NodalSum reactions_at(std::size_t body, const mechanics::NodeLinks& links, const std::vector<std::int64_t>& nodes) {
  NodalSum sum{body, {}};
  std::set<std::int64_t> own(nodes.begin(), nodes.end());
  for (const mechanics::NodeLinks::Turned& link : links.turned)
    if (link.node != link.of) own.erase(link.node);
  for (const std::int64_t node : own) sum.nodes.emplace_back(node, Matrix3::Identity());
  for (const mechanics::NodeLinks::Turned& link : links.turned)
    if (link.node != link.of && own.contains(link.of)) sum.nodes.emplace_back(link.node, link.rotation.transpose());
  return sum;
}

class ReactionProbe final : public Probe {
 public:
  ReactionProbe(std::vector<NodalSum> sums, const OnSupports& supports, const Quantity& quantity)
      : sums_(std::move(sums)), supports_(supports), quantity_(quantity) {}

  double value(Snapshot& snapshot) const override {
    Vector3 sum = Vector3::Zero();
    for (const auto& [body, nodes] : sums_) {
      const std::vector<double>& forces = snapshot.reactions(body);
      for (const auto& [node, rotation] : nodes)
        for (int k = 0; k < 3; ++k) sum[k] += rotation.row(k).dot(Eigen::Map<const Vector3>(forces.data() + 3 * node));
    }
    return snapshot.assembly().team().sum(quantity_.of([&](double* into) { supports_.evaluate(sum, into); }));
  }

 private:
  std::vector<NodalSum> sums_;
  OnSupports supports_;
  const Quantity& quantity_;
};

}  // namespace

std::unique_ptr<Probe> make_probe(const AtMultipliers& multipliers, const ProbeRequest& request) {
  std::vector<ContactPart> parts = contact_parts(request.probe, request.model);
  if (multipliers.models == AtMultipliers::In::with_gaskets)
    for (const ContactPart& part : parts)
      if (const contact::Pair& pair = request.model.pairs()[part.pair]; !pair.gasket)
        throw ModelError(
            fmt::format("contact '{}' has no gasket, whose {} this is", pair.name, request.quantity.variable->label));
  return std::make_unique<MultiplierProbe>(std::move(parts), multipliers, request.probe.reduce);
}

std::unique_ptr<Probe> make_probe(const OnContactSurface& surface, const ProbeRequest& request) {
  return std::make_unique<ContactResultantProbe>(contact_parts(request.probe, request.model), surface, request);
}

std::unique_ptr<Probe> make_probe(const AreaInContact& /*area*/, const ProbeRequest& request) {
  return std::make_unique<AreaProbe>(contact_parts(request.probe, request.model), request.model);
}

std::unique_ptr<Probe> make_probe(const OnSupports& supports, const ProbeRequest& request) {
  const config::Probe& probe = request.probe;
  const model::Model& model = request.model;
  std::vector<NodalSum> sums;
  const ProbePart where(probe);
  double found = 0;
  for (const std::size_t b : probe_bodies(probe, model)) {
    const mesh::Mesh& mesh = model.bodies()[b].mesh();
    std::vector<std::int64_t> held = mesh::group_nodes(mesh, probe.on.name);
    std::erase_if(held, [&](std::int64_t node) { return !where.holds(mesh.nodes[node]); });
    if (!held.empty()) found = 1;
    sums.push_back(reactions_at(b, model.bodies()[b].constraints().links(), held));
  }
  if (!where.is_whole()) where.require(model.assembly.team().max(found) > 0, fmt::format("'{}'", probe.on.name));
  return std::make_unique<ReactionProbe>(std::move(sums), supports, request.quantity);
}

}  // namespace creepcontact::results
