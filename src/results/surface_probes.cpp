#include <fmt/format.h>

#include <deque>
#include <numeric>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/geometry/contact_area.hpp"
#include "creepcontact/results/contact_values.hpp"
#include "probe_kinds.hpp"

namespace creepcontact::results {
namespace {

/// A pair, and the body that the probed surface belongs to.
struct Side {
  std::size_t pair, body;
};

/// Of the normal rows.
Eigen::VectorXd of_nodes(const contact::Pair& pair, const Eigen::VectorXd& all_rows) {
  return pair.coupling.first_rows(all_rows.segment(pair.first_row, pair.coupling.n_rows()));
}

class AreaProbe final : public Probe {
 public:
  AreaProbe(std::vector<Side> sides, const model::Model& model) : sides_(std::move(sides)) {
    const std::vector<contact::Pair>& pairs = model.pairs();
    for (const Side& side : sides_)
      areas_.emplace_back(pairs[side.pair], model.bodies()[pairs[side.pair].slave_body].mesh());
  }

  double value(Snapshot& snapshot) const override {
    double sum = 0;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const contact::Pair& pair = snapshot.assembly().pairs()[sides_[i].pair];
      if (pair.coupling.type == contact::ContactType::tied)
        sum += std::accumulate(pair.coupling.area.begin(), pair.coupling.area.end(), 0.0);
      else
        sum += areas_[i].value(of_nodes(pair, snapshot.equilibrium().contact.multiplier),
                               of_nodes(pair, snapshot.equilibrium().gaps));
    }
    return sum;
  }

 private:
  std::vector<Side> sides_;
  std::deque<contact::ContactArea> areas_;  // which are not to be moved
};

/// Values at multiplier nodes, force and moment.
class ContactProbe final : public Probe {
 public:
  ContactProbe(std::vector<Side> sides, const Quantity& quantity, const config::Probe& probe)
      : sides_(std::move(sides)),
        quantity_(quantity),
        reduce_(probe.reduce),
        origin_(Eigen::Map<const Vector3>(probe.origin.data())) {}

  double value(Snapshot& snapshot) const override {
    const bool is_field = quantity_.variable->is_contact_field();
    Reduction reduction(reduce_);
    double resultant = 0;
    for (const Side& side : sides_) {
      const contact::Pair& pair = snapshot.assembly().pairs()[side.pair];
      if (is_field)
        add_nodes(snapshot, pair, reduction);
      else
        resultant += this->resultant(snapshot, pair, side.body);
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

  void add_nodes(Snapshot& snapshot, const contact::Pair& pair, Reduction& reduction) const {
    for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i)
      reduction.add(value_of(quantity_.variable->location, contact_values(pair, i, snapshot.equilibrium())),
                    pair.coupling.area[i]);
  }

  double resultant(Snapshot& snapshot, const contact::Pair& pair, std::size_t body) const {
    const contact::RowMatrix& rows = pair.slave_body == body ? pair.coupling.slave_rows : pair.coupling.master_rows;
    const Eigen::VectorXd forces =
        rows.transpose() * snapshot.equilibrium().contact.multiplier.segment(pair.first_row, pair.coupling.n_rows());
    const std::vector<Vector3>& nodes = snapshot.assembly().bodies()[body].mesh().nodes;
    const bool is_moment = quantity_.variable->location == Location::contact_moment;
    Vector3 sum = Vector3::Zero();
    for (Index i = 0; i < forces.size(); i += 3) {
      const Vector3 force = forces.segment<3>(i);
      if (is_moment && !force.isZero(0))
        sum += (nodes[i / 3] - origin_).cross(force);
      else
        sum += force;
    }
    return sum[quantity_.component];
  }

  std::vector<Side> sides_;
  const Quantity& quantity_;
  config::Reduce reduce_;
  Vector3 origin_;
};

class ReactionProbe final : public Probe {
 public:
  ReactionProbe(std::vector<std::pair<std::size_t, std::vector<std::int64_t>>> nodes, int component)
      : nodes_(std::move(nodes)), component_(component) {}

  double value(Snapshot& snapshot) const override {
    double sum = 0;
    for (const auto& [body, nodes] : nodes_) {
      const std::vector<double>& forces = snapshot.reactions(body);
      for (const std::int64_t node : nodes) sum += forces[3 * node + component_];
    }
    return snapshot.assembly().team().sum(sum);
  }

 private:
  std::vector<std::pair<std::size_t, std::vector<std::int64_t>>> nodes_;
  int component_;
};

}  // namespace

std::unique_ptr<Probe> contact_probe(const config::Probe& probe, const model::Model& model) {
  std::vector<Side> sides;
  std::set<std::string> surfaces;
  const std::vector<contact::Pair>& pairs = model.pairs();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const contact::Pair& pair = pairs[p];
    if (pair.ties_nodes()) continue;
    surfaces.insert({pair.slave_surface, pair.master_surface});
    const auto wanted = [&](std::size_t body) {
      return !probe.body.given() || model.bodies()[body].name() == probe.body.name;
    };
    if (pair.slave_surface == probe.on.name && wanted(pair.slave_body))
      sides.push_back({p, pair.slave_body});
    else if (pair.master_surface == probe.on.name && wanted(pair.master_body))
      sides.push_back({p, pair.master_body});
  }
  if (sides.empty()) {
    std::string names;
    for (const std::string& name : surfaces) names += (names.empty() ? "'" : ", '") + name + "'";
    throw ModelError(fmt::format("surface '{}' is in no contact; surfaces in contact: {}", probe.on.name,
                                 names.empty() ? "none" : names));
  }
  const Quantity& wanted = quantity(probe.quantity);
  if (wanted.variable->location == OutputVariable::Location::contact_area)
    return std::make_unique<AreaProbe>(std::move(sides), model);
  return std::make_unique<ContactProbe>(std::move(sides), wanted, probe);
}

std::unique_ptr<Probe> reaction_probe(const config::Probe& probe, const model::Model& model) {
  std::vector<std::pair<std::size_t, std::vector<std::int64_t>>> nodes;
  for (const std::size_t b : probe_bodies(probe, model))
    nodes.emplace_back(b, mesh::group_nodes(model.bodies()[b].mesh(), probe.on.name));
  return std::make_unique<ReactionProbe>(std::move(nodes), quantity(probe.quantity).component);
}

}  // namespace creepcontact::results
