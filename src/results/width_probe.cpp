#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact_part.hpp"
#include "creepcontact/results/contact_values.hpp"
#include "probe_kinds.hpp"

namespace creepcontact::results {
namespace {

constexpr double rows_per_section = 3;  // of nodes along the circumference, about

/// Means over the width of a surface around an axis, at sections of equal angle.
class WidthProbe final : public Probe {
 public:
  WidthProbe(const std::vector<ContactPart>& parts, double ContactValues::*value, const ProbeRequest& request)
      : value_(value), reduce_(request.probe.reduce) {
    const Vector3 axis = Vector3(request.probe.axis.data()).normalized(), origin(request.probe.origin.data());
    const Vector3 first = axis.unitOrthogonal(), second = axis.cross(first);
    const bool turns = request.model.bodies().front().mesh().section.dimension() == 3;
    for (const ContactPart& part : parts) {
      const contact::Pair& pair = request.model.pairs()[part.pair];
      for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
        if (part.multiplier_shares[i] == 0) continue;
        const Vector3& place = request.model.bodies()[pair.slave_body].mesh().nodes[pair.coupling.nodes[i].node];
        const Vector3 arm = place - origin;
        const double angle = turns ? std::atan2(arm.dot(second), arm.dot(first)) : 0.0;
        nodes_.push_back({pairs_.size(), i, part.multiplier_shares[i] * pair.coupling.area[i], angle,
                          (arm - arm.dot(axis) * axis).norm()});
      }
      pairs_.push_back(part.pair);
    }
    if (turns) divide();
  }

  double value(Snapshot& snapshot) const override {
    std::vector<double> sum(n_sections_, 0.0), area(n_sections_, 0.0);
    std::vector<PairValues> values;
    for (const std::size_t pair : pairs_)
      values.emplace_back(snapshot.assembly().pairs()[pair], snapshot.equilibrium());
    for (const Node& node : nodes_) {
      sum[node.section] += node.area * (values[node.part][node.number].*value_);
      area[node.section] += node.area;
    }
    Reduction reduction(reduce_);
    for (std::size_t s = 0; s < n_sections_; ++s)
      if (area[s] > 0) reduction.add(sum[s] / area[s], area[s]);
    return reduction.result(serial_team());  // all members of a team know the state of the contacts
  }

 private:
  struct Node {
    std::size_t part, number;
    double area, angle, radius;
    std::size_t section = 0;
  };

  /// Into sections that have some rows of nodes each. A surface that is not all around begins after its widest opening.
  void divide() {
    std::ranges::sort(nodes_, {}, &Node::angle);
    std::size_t first = 0;
    double widest = 0, area = 0, radius = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double before = i > 0 ? nodes_[i - 1].angle : nodes_.back().angle - 2 * std::numbers::pi;
      if (nodes_[i].angle - before > widest) {
        widest = nodes_[i].angle - before;
        first = i;
      }
      area += nodes_[i].area;
      radius += nodes_[i].area * nodes_[i].radius;
    }
    radius /= area;
    const double covered = 2 * std::numbers::pi - widest;
    const double distance = std::sqrt(area / static_cast<double>(nodes_.size()));
    n_sections_ = static_cast<std::size_t>(std::max(1.0, std::floor(covered * radius / (rows_per_section * distance))));
    const double begin = nodes_[first].angle;
    for (Node& node : nodes_) {
      const double turned = node.angle - begin + (node.angle < begin ? 2 * std::numbers::pi : 0.0);
      const double part = turned / covered * static_cast<double>(n_sections_);
      node.section = std::min(static_cast<std::size_t>(std::max(0.0, part)), n_sections_ - 1);
    }
  }

  double ContactValues::*value_;
  config::Reduce reduce_;
  std::vector<std::size_t> pairs_;  // of the parts
  std::vector<Node> nodes_;
  std::size_t n_sections_ = 1;
};

}  // namespace

std::unique_ptr<Probe> make_probe(const OverWidth& width, const ProbeRequest& request) {
  return std::make_unique<WidthProbe>(contact_parts(request.probe, request.model), width.value, request);
}

}  // namespace creepcontact::results
