#include "creepcontact/mechanics/constraints.hpp"

#include <fmt/format.h>

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
  Vector3 direction;
};

/// Two supports agree if they do at t = 0, at t = 1 (ramps from zero) and wherever a table has its points.
void require_consistent(const std::vector<Support>& supports, std::size_t support,
                        const NodeConditions::Dependent& dependent, const Vector3& direction, const Vector3& position) {
  std::vector<double> times{0.0, 1.0};
  const auto add_breakpoints = [&](std::size_t i) {
    const auto points = supports[i].value.breakpoints();
    times.insert(times.end(), points.begin(), points.end());
  };
  add_breakpoints(support);
  for (const std::size_t other : dependent.on) add_breakpoints(other);
  for (const double t : times) {
    const double value = value_at(supports[support].value, position, t);
    double implied = 0, size = std::abs(value);
    for (std::size_t i = 0; i < dependent.on.size(); ++i) {
      const double part = dependent.coefficients[i] * value_at(supports[dependent.on[i]].value, position, t);
      implied += part;
      size += std::abs(part);
    }
    if (std::abs(value - implied) <= 1e-8 * size) continue;
    std::string others;
    for (const std::size_t other : dependent.on)
      others += fmt::format("{}'{}'", others.empty() ? "" : ", ", supports[other].on);
    throw ModelError(fmt::format(
        "supports {} and '{}' contradict each other at the node ({:.6g}, {:.6g}, {:.6g}): the displacement "
        "along ({:.4g}, {:.4g}, {:.4g}) would be {:.6g} and {:.6g} at t = {:g}; remove one of them, or give "
        "both the same value",
        others, supports[support].on, position[0], position[1], position[2], direction[0], direction[1], direction[2],
        implied, value, t));
  }
}

}  // namespace

Constraints::Constraints(const std::vector<Vector3>& nodes, const std::vector<Support>& supports)
    : frame_of_node_(nodes.size(), -1) {
  std::map<std::int64_t, std::vector<Candidate>> candidates;  // by node
  for (std::size_t s = 0; s < supports.size(); ++s) {
    supports_.push_back({supports[s].value, {}});
    const auto& directions = supports[s].directions;
    for (std::size_t i = 0; i < supports[s].nodes.size(); ++i)
      candidates[supports[s].nodes[i]].push_back({s, directions[directions.size() == 1 ? 0 : i].normalized()});
  }
  for (const auto& [node, list] : candidates) {
    const Vector3& position = nodes[node];
    NodeConditions conditions;
    for (const Candidate& candidate : list) {
      if (const auto dependent = conditions.add(candidate.support, candidate.direction))
        require_consistent(supports, candidate.support, *dependent, candidate.direction, position);
    }
    frame_of_node_[node] = static_cast<std::int64_t>(frames_.size());
    frames_.push_back({conditions.frame(), conditions.n_held()});
    const Eigen::Matrix3Xd displacements = conditions.displacements();
    for (int i = 0; i < conditions.n_held(); ++i)
      supports_[conditions.label(i)].conditions.push_back({node, position, displacements.col(i)});
  }
  number_free(nodes.size());
}

void Constraints::number_free(std::int64_t n_nodes) {
  free_index_.assign(n_nodes, {-1, -1, -1});
  for (std::int64_t node = 0; node < n_nodes; ++node) {
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
  const Frame* frame = frame_or_null(node);
  return frame ? frame->axes : Matrix3::Identity();
}

int Constraints::n_held(std::int64_t node) const {
  const Frame* frame = frame_or_null(node);
  return frame ? frame->n_held : 0;
}

void Constraints::restrict_to_free(std::span<const double> full, std::span<double> free) const {
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
  return std::any_of(supports_.begin(), supports_.end(),
                     [](const auto& support) { return !support.conditions.empty() && !support.value.is_zero(); });
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
  return nonzero;
}

}  // namespace creepcontact::mechanics
