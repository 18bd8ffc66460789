#include <fmt/format.h>

#include <deque>
#include <numeric>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/geometry/contact_area.hpp"
#include "probe_kinds.hpp"

namespace creepcontact::results {
namespace {

/// A pair, and the body that the probed surface belongs to.
struct Side {
  std::size_t pair, body;
};

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
        sum +=
            areas_[i].value(snapshot.equilibrium().contact.multiplier.segment(pair.first_row, pair.coupling.n_rows()),
                            snapshot.equilibrium().gaps.segment(pair.first_row, pair.coupling.n_rows()));
    }
    return sum;
  }

 private:
  std::vector<Side> sides_;
  std::deque<contact::ContactArea> areas_;  // which are not to be moved
};

/// Pressure, gap and force.
class ContactProbe final : public Probe {
 public:
  ContactProbe(std::vector<Side> sides, const Quantity& quantity, config::Reduce reduce)
      : sides_(std::move(sides)), quantity_(quantity), reduce_(reduce) {}

  double value(Snapshot& snapshot) const override {
    Reduction reduction(reduce_);
    double force = 0;
    for (const Side& side : sides_) {
      const contact::Pair& pair = snapshot.assembly().pairs()[side.pair];
      if (is_at(Location::contact_force))
        force += contact_force(snapshot, pair, side.body);
      else
        add_nodes(snapshot, pair, reduction);
    }
    // All members of a team know the state of the contacts.
    return is_at(Location::contact_force) ? force : reduction.result(serial_team());
  }

 private:
  using Location = OutputVariable::Location;
  bool is_at(Location location) const { return quantity_.variable->location == location; }

  void add_nodes(Snapshot& snapshot, const contact::Pair& pair, Reduction& reduction) const {
    const Eigen::VectorXd& multipliers = snapshot.equilibrium().contact.multiplier;
    const Eigen::VectorXd& gaps = snapshot.equilibrium().gaps;
    const bool tied = pair.coupling.type == contact::ContactType::tied;
    for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
      const double area = pair.coupling.area[i];
      const Index row = pair.first_row + (tied ? 3 * i : i);
      const Vector3& normal = pair.coupling.nodes[i].normal;
      // A tied surface carries a vector: its pressure is the part along the normal (tension negative).
      const double pressure = tied ? normal.dot(multipliers.segment<3>(row)) : multipliers[row];
      const double gap = tied ? 0.0 : gaps[row] / area;
      reduction.add(is_at(Location::contact_pressure) ? pressure : gap, area);
    }
  }

  double contact_force(Snapshot& snapshot, const contact::Pair& pair, std::size_t body) const {
    const contact::RowMatrix& rows = pair.slave_body == body ? pair.coupling.slave_rows : pair.coupling.master_rows;
    const Eigen::VectorXd forces =
        rows.transpose() * snapshot.equilibrium().contact.multiplier.segment(pair.first_row, pair.coupling.n_rows());
    double sum = 0;
    for (auto i = static_cast<Index>(quantity_.component); i < forces.size(); i += 3) sum += forces[i];
    return sum;
  }

  std::vector<Side> sides_;
  const Quantity& quantity_;
  config::Reduce reduce_;
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
  return std::make_unique<ContactProbe>(std::move(sides), wanted, probe.reduce);
}

std::unique_ptr<Probe> reaction_probe(const config::Probe& probe, const model::Model& model) {
  std::vector<std::pair<std::size_t, std::vector<std::int64_t>>> nodes;
  for (const std::size_t b : probe_bodies(probe, model))
    nodes.emplace_back(b, mesh::group_nodes(model.bodies()[b].mesh(), probe.on.name));
  return std::make_unique<ReactionProbe>(std::move(nodes), quantity(probe.quantity).component);
}

}  // namespace creepcontact::results
