#include "creepcontact/mechanics/constraints.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "creepcontact/base/error.hpp"
#include "node_conditions.hpp"

namespace creepcontact::mechanics {

namespace {

double value_at(const Function& function, const Vector3& x, double t) {
  return function({.x = x[0], .y = x[1], .z = x[2], .t = t});
}

struct Candidate {
  std::size_t support = 0;
  Vector3 direction, position;
};

/// Two supports agree if they do at t = 0, at t = 1 (ramps from zero) and wherever a table has its points.
std::vector<double> times_to_compare(const std::vector<const Function*>& values) {
  std::vector<double> times{0.0, 1.0};
  for (const Function* value : values) {
    const auto points = value->breakpoints();
    times.insert(times.end(), points.begin(), points.end());
  }
  return times;
}

/// @param list  all candidates of the node, to which `dependent` refers
void require_consistent(const std::vector<Support>& supports, const std::vector<Candidate>& list,
                        const Candidate& candidate, const NodeConditions::Dependent& dependent) {
  const auto value_of = [&](const Candidate& of) -> const Function& { return supports[of.support].value; };
  std::vector<const Function*> values{&value_of(candidate)};
  for (const std::size_t other : dependent.on) values.push_back(&value_of(list[other]));
  const Vector3 &position = candidate.position, &direction = candidate.direction;
  for (const double t : times_to_compare(values)) {
    const double value = value_at(value_of(candidate), position, t);
    double implied = 0, size = std::abs(value);
    for (std::size_t i = 0; i < dependent.on.size(); ++i) {
      const Candidate& other = list[dependent.on[i]];
      const double part = dependent.coefficients[i] * value_at(value_of(other), other.position, t);
      implied += part;
      size += std::abs(part);
    }
    if (std::abs(value - implied) <= 1e-8 * size) continue;
    std::string others;
    for (const std::size_t other : dependent.on)
      others += fmt::format("{}'{}'", others.empty() ? "" : ", ", supports[list[other].support].on);
    throw ModelError(fmt::format(
        "supports {} and '{}' contradict each other at the node ({:.6g}, {:.6g}, {:.6g}): the displacement "
        "along ({:.4g}, {:.4g}, {:.4g}) would be {:.6g} and {:.6g} at t = {:g}; remove one of them, or give "
        "both the same value",
        others, supports[candidate.support].on, position[0], position[1], position[2], direction[0], direction[1],
        direction[2], implied, value, t));
  }
}

/// Where a node is linked to itself it stays on the axis of the rotation.
std::vector<Support> with_supports_of_the_axis(const std::vector<Support>& supports, const NodeLinks& links) {
  std::vector<Support> all = supports;
  for (const NodeLinks::Turned& turned : links.turned) {
    if (turned.node != turned.of) continue;
    const Vector3 axis = Eigen::AngleAxisd(turned.rotation).axis(), across = axis.unitOrthogonal();
    const std::array<Vector3, 2> directions{across, axis.cross(across)};
    for (const Vector3& direction : directions) all.push_back({"cyclic symmetry", {turned.node}, {direction}, 0.0});
  }
  return all;
}

}  // namespace

Constraints::Constraints(const std::vector<Vector3>& nodes, const std::vector<Support>& given, const NodeLinks& links)
    : frame_of_node_(nodes.size(), -1), links_(links) {
  const std::vector<Support> supports = with_supports_of_the_axis(given, links);
  find_linked_nodes(nodes);
  std::map<std::int64_t, std::vector<Candidate>> candidates;  // by node
  for (std::size_t s = 0; s < supports.size(); ++s) {
    supports_.push_back({supports[s].value, {}});
    const auto& directions = supports[s].directions;
    for (std::size_t i = 0; i < supports[s].nodes.size(); ++i) {
      const std::int64_t node = supports[s].nodes[i];
      if (surface_or_null(node) != nullptr) continue;  // a condition on the surface
      const Vector3 direction = directions[directions.size() == 1 ? 0 : i].normalized();
      if (const NodeLinks::Turned* turned = turned_or_null(node))
        candidates[turned->of].push_back({s, turned->rotation.transpose() * direction, nodes[node]});
      else
        candidates[node].push_back({s, direction, nodes[node]});
    }
  }
  for (const auto& [node, list] : candidates) {
    NodeConditions conditions;
    for (std::size_t i = 0; i < list.size(); ++i)
      if (const auto dependent = conditions.add(i, list[i].direction))
        require_consistent(supports, list, list[i], *dependent);
    frame_of_node_[node] = static_cast<std::int64_t>(frames_.size());
    frames_.push_back({conditions.frame(), conditions.n_held()});
    const Eigen::Matrix3Xd displacements = conditions.displacements();
    for (int i = 0; i < conditions.n_held(); ++i) {
      const Candidate& candidate = list[conditions.label(i)];
      supports_[candidate.support].conditions.push_back({node, candidate.position, displacements.col(i)});
    }
  }
  hold_rigid_surfaces(nodes, supports);
  number_free(nodes.size());
  if (!links_.empty()) make_transformation(nodes);
}

void Constraints::number_free(std::int64_t n_nodes) {
  free_index_.assign(n_nodes, {-1, -1, -1});
  for (std::int64_t node = 0; node < n_nodes; ++node) {
    if (const RigidSurface* surface = surface_or_null(node)) {
      if (surface->nodes.front() != node) continue;
      surfaces_[surface_[node]].first_free = n_free();
      node_of_free_.insert(node_of_free_.end(), surface->free.cols(), node);
      continue;
    }
    if (turned_or_null(node) != nullptr) continue;
    for (int k = n_held(node); k < 3; ++k) {
      free_index_[node][k] = n_free();
      node_of_free_.push_back(node);
    }
  }
}

const Constraints::Frame* Constraints::frame_or_null(std::int64_t node) const {
  const std::int64_t index = frame_of_node_[node];
  return index < 0 ? nullptr : &frames_[index];
}

std::int64_t Constraints::n_free() const {
  return node_of_free_.size();
}
std::int64_t Constraints::n_full() const {
  return 3 * frame_of_node_.size();
}
const std::vector<std::int64_t>& Constraints::node_of_free() const {
  return node_of_free_;
}

const std::array<std::int64_t, 3>& Constraints::free_index(std::int64_t node) const {
  return free_index_[node];
}

Matrix3 Constraints::frame(std::int64_t node) const {
  if (const NodeLinks::Turned* turned = turned_or_null(node)) return turned->rotation * frame(turned->of);
  const Frame* frame = frame_or_null(node);
  return frame ? frame->axes : Matrix3::Identity();
}

int Constraints::n_held(std::int64_t node) const {
  if (const NodeLinks::Turned* turned = turned_or_null(node)) return n_held(turned->of);
  if (const RigidSurface* surface = surface_or_null(node)) return surface->free.cols() == 0 ? 3 : 0;
  const Frame* frame = frame_or_null(node);
  return frame ? frame->n_held : 0;
}

void Constraints::restrict_to_free(std::span<const double> full, std::span<double> free) const {
  if (!links_.empty()) {
    Eigen::Map<Eigen::VectorXd>(free.data(), std::ssize(free)) =
        transformation_.transpose() * Eigen::Map<const Eigen::VectorXd>(full.data(), std::ssize(full));
    return;
  }
  std::size_t next = 0;
  for (std::size_t node = 0; node < frame_of_node_.size(); ++node) {
    const double* f = full.data() + 3 * node;
    if (frame_of_node_[node] < 0) {
      for (std::size_t i = 0; i < 3; ++i) free[next++] = f[i];
      continue;
    }
    const Frame& frame = frames_[frame_of_node_[node]];
    const Eigen::Map<const Vector3> force(f);
    for (int k = frame.n_held; k < 3; ++k) free[next++] = frame.axes.col(k).dot(force);
  }
}

void Constraints::expand(std::span<const double> free, std::span<const double> prescribed,
                         std::span<double> full) const {
  if (!links_.empty()) {
    Eigen::Map<Eigen::VectorXd> u(full.data(), std::ssize(full));
    u = transformation_ * Eigen::Map<const Eigen::VectorXd>(free.data(), std::ssize(free));
    if (!prescribed.empty()) u += Eigen::Map<const Eigen::VectorXd>(prescribed.data(), std::ssize(prescribed));
    return;
  }
  std::size_t next = 0;
  for (std::size_t node = 0; node < frame_of_node_.size(); ++node) {
    double* u = full.data() + 3 * node;
    if (frame_of_node_[node] < 0) {
      for (std::size_t i = 0; i < 3; ++i) u[i] = free[next++];
      continue;
    }
    const Frame& frame = frames_[frame_of_node_[node]];
    Eigen::Map<Vector3> displacement(u);
    displacement.setZero();
    if (!prescribed.empty()) displacement = Eigen::Map<const Vector3>(prescribed.data() + 3 * node);
    for (int k = frame.n_held; k < 3; ++k) displacement += free[next++] * frame.axes.col(k);
  }
}

bool Constraints::has_nonzero_values() const {
  const auto moves = [](const auto& support) { return !support.conditions.empty() && !support.value.is_zero(); };
  const auto moves_surface = [](const RigidSurface& surface) {
    return std::ranges::any_of(surface.conditions, [](const auto& one) { return !one.value.is_zero(); });
  };
  return std::ranges::any_of(supports_, moves) || std::ranges::any_of(surfaces_, moves_surface);
}

bool Constraints::prescribed(double t, std::span<double> full) const {
  std::fill(full.begin(), full.end(), 0.0);
  bool nonzero = false;
  for (const auto& [value, conditions] : supports_) {
    if (conditions.empty() || value.is_zero()) continue;
    const bool varies = value.depends_on_position();
    double g = varies ? 0.0 : value_at(value, Vector3::Zero(), t);
    for (const Condition& condition : conditions) {
      if (varies) g = value_at(value, condition.position, t);
      if (g == 0) continue;
      Eigen::Map<Vector3>(full.data() + 3 * condition.node) += g * condition.displacement;
      nonzero = true;
    }
  }
  return prescribed_at_links(t, full) || nonzero;
}

}  // namespace creepcontact::mechanics
