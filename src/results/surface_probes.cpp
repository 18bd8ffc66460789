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

/// Of the normal rows.
Eigen::VectorXd of_nodes(const contact::Pair& pair, const Eigen::VectorXd& all_rows) {
  return pair.coupling.first_rows(all_rows.segment(pair.first_row, pair.coupling.n_rows()));
}

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
                                             of_nodes(pair, snapshot.equilibrium().gaps)));
    }
    return sum;
  }

 private:
  std::vector<ContactPart> sides_;
  std::deque<contact::ContactArea> areas_;  // which are not to be moved
};

/// Values at multiplier nodes, force and moment.
class ContactProbe final : public Probe {
 public:
  ContactProbe(std::vector<ContactPart> sides, const Quantity& quantity, const config::Probe& probe)
      : sides_(std::move(sides)),
        quantity_(quantity),
        reduce_(probe.reduce),
        origin_(Eigen::Map<const Vector3>(probe.origin.data())) {}

  double value(Snapshot& snapshot) const override {
    const bool is_field = quantity_.variable->is_contact_field();
    Reduction reduction(reduce_);
    double resultant = 0;
    for (const ContactPart& side : sides_) {
      const contact::Pair& pair = snapshot.assembly().pairs()[side.pair];
      if (is_field)
        add_nodes(snapshot, pair, side, reduction);
      else
        resultant += this->resultant(snapshot, pair, side);
    }
    // All members of a team know the state of the contacts.
    return is_field ? reduction.result(serial_team()) : resultant;
  }

 private:
  using Location = OutputVariable::Location;
  static double value_of(Location location, const ContactValues& values) {
    switch (location) {
      case Location::contact_pressure:
        return values.pressure;
      case Location::contact_shear:
        return values.shear;
      case Location::contact_slip:
        return values.slip;
      case Location::contact_status:
        return values.status;
      default:
        return values.gap;
    }
  }

  void add_nodes(Snapshot& snapshot, const contact::Pair& pair, const ContactPart& side, Reduction& reduction) const {
    const bool is_extreme = reduce_ == config::Reduce::max || reduce_ == config::Reduce::min;
    for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
      if (is_extreme ? side.lies_within[i] == 0 : side.multiplier_shares[i] == 0) continue;
      reduction.add(value_of(quantity_.variable->location, contact_values(pair, i, snapshot.equilibrium())),
                    side.multiplier_shares[i] * pair.coupling.area[i]);
    }
  }

  double resultant(Snapshot& snapshot, const contact::Pair& pair, const ContactPart& side) const {
    const contact::RowMatrix& rows = side.is_slave ? pair.coupling.slave_rows : pair.coupling.master_rows;
    const Eigen::VectorXd forces =
        rows.transpose() * snapshot.equilibrium().contact.multiplier.segment(pair.first_row, pair.coupling.n_rows());
    const std::vector<Vector3>& nodes = snapshot.assembly().bodies()[side.body].mesh().nodes;
    const bool is_moment = quantity_.variable->location == Location::contact_moment;
    Vector3 sum = Vector3::Zero();
    for (Index i = 0; i < forces.size(); i += 3) {
      const Vector3 force = side.node_shares[i / 3] * forces.segment<3>(i);
      if (is_moment && !force.isZero(0))
        sum += (nodes[i / 3] - origin_).cross(force);
      else
        sum += force;
    }
    return sum[quantity_.component];
  }

  std::vector<ContactPart> sides_;
  const Quantity& quantity_;
  config::Reduce reduce_;
  Vector3 origin_;
};

/// Forces at the nodes of one body, some of them turned.
struct NodalSum {
  std::size_t body = 0;
  std::vector<std::pair<std::int64_t, Matrix3>> nodes;
};

/// What supports exert on these nodes. What a sector exerts on the next one is no reaction: forces at nodes that follow
/// others by cyclic symmetry count there.
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
  ReactionProbe(std::vector<NodalSum> sums, int component) : sums_(std::move(sums)), component_(component) {}

  double value(Snapshot& snapshot) const override {
    double sum = 0;
    for (const auto& [body, nodes] : sums_) {
      const std::vector<double>& forces = snapshot.reactions(body);
      for (const auto& [node, rotation] : nodes)
        sum += rotation.row(component_).dot(Eigen::Map<const Vector3>(forces.data() + 3 * node));
    }
    return snapshot.assembly().team().sum(sum);
  }

 private:
  std::vector<NodalSum> sums_;
  int component_;
};

}  // namespace

std::unique_ptr<Probe> contact_probe(const config::Probe& probe, const model::Model& model) {
  std::vector<ContactPart> sides = contact_parts(probe, model);
  const Quantity& wanted = quantity(probe.quantity);
  if (wanted.variable->location == OutputVariable::Location::contact_area)
    return std::make_unique<AreaProbe>(std::move(sides), model);
  return std::make_unique<ContactProbe>(std::move(sides), wanted, probe);
}

std::unique_ptr<Probe> reaction_probe(const config::Probe& probe, const model::Model& model) {
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
  return std::make_unique<ReactionProbe>(std::move(sums), quantity(probe.quantity).component);
}

}  // namespace creepcontact::results
