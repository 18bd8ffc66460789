/// [[springs]]: rows between the means of two surfaces, or two nodes, whose force is a function of their closure.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "creepcontact/base/error.hpp"
#include "creepcontact/contact/geometry/equation_rows.hpp"
#include "mean_motion.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {
namespace {

/// One end: a weighted mean of displacements of nodes.
struct SpringEnd {
  std::size_t body = 0;
  std::vector<std::int64_t> nodes;
  std::vector<double> weights;  // their sum is 1
};

SpringEnd mean_of(const std::string& surface, const config::Config& config, const Bodies& bodies) {
  const std::vector<std::size_t> owners = bodies_with(bodies, surface);
  if (owners.empty()) throw ModelError(fmt::format("no body has the surface '{}'", surface));
  if (owners.size() > 1)
    throw ModelError(fmt::format("the surface '{}' is on {} bodies ('{}', '{}'); name one surface per body", surface,
                                 owners.size(), config.bodies[owners[0]].name, config.bodies[owners[1]].name));
  const WeightedNodes all = weighted_nodes(owners.front(), bodies[owners.front()].mesh(), surface);
  SpringEnd end{all.body, all.nodes, all.weights};
  const double sum = std::accumulate(end.weights.begin(), end.weights.end(), 0.0);
  for (double& weight : end.weights) weight /= sum;
  return end;
}

/// The node next to a point. @param other  a body that is taken only if no other has a node as near
SpringEnd node_at(const Vector3& at, const Bodies& bodies, std::optional<std::size_t> other) {
  constexpr double beside = 1e-9;  // of the distances: as near
  SpringEnd end;
  double least = std::numeric_limits<double>::infinity();
  Eigen::AlignedBox3d box;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (std::size_t i = 0; i < bodies[b].mesh().n_cell_nodes(); ++i) {
      const Vector3& x = bodies[b].mesh().nodes[i];
      box.extend(x);
      const double distance = (x - at).norm();
      const bool replaces = distance < least || (other == end.body && b != *other && distance <= least * (1 + beside));
      if (!replaces) continue;
      least = distance;
      end = {b, {static_cast<std::int64_t>(i)}, {1.0}};
    }
  constexpr double farthest = 0.1;  // of the model: the point is not of it
  if (least > farthest * box.diagonal().norm())
    throw ModelError(fmt::format("there is no node near ({:.6g}, {:.6g}, {:.6g}): the nearest is {:.3g} away", at.x(),
                                 at.y(), at.z(), least));
  return end;
}

/// Its force over its closure, from where nothing has moved.
contact::GasketCurve curve_of(const config::Spring& spring, double area) {
  contact::GasketCurve curve;
  if (spring.stiffness) {
    // Far enough for the first force to be negative, whatever the preload.
    const double far = 1 + std::abs(spring.preload) / *spring.stiffness;
    curve = {{-far, far}, {spring.preload - *spring.stiffness * far, spring.preload + *spring.stiffness * far}};
  } else {
    curve = {spring.curve->closure, spring.curve->force};
    const contact::ClosureCurve given =
        contact::GasketLaw::spring(curve).curve(0, 0);  // throws if it does not increase
    if (spring.preload != 0) {
      if (spring.preload < curve.pressure.front())
        throw std::invalid_argument(fmt::format("preload: {:.6g} is below the first force of the curve, {:.6g}",
                                                spring.preload, curve.pressure.front()));
      const double at = given.closure(spring.preload);
      for (double& value : curve.closure) value -= at;
    }
  }
  for (double& value : curve.pressure) value /= area;
  return curve;
}

contact::Pair make_spring(const config::Spring& spring, const config::Config& config, const Bodies& bodies) {
  SpringEnd first, second;
  const bool has_ground = spring.ground;
  if (spring.between) {
    first = mean_of((*spring.between)[0].name, config, bodies);
    second = mean_of((*spring.between)[1].name, config, bodies);
  } else if (spring.at) {
    first = node_at(vector((*spring.at)[0]), bodies, std::nullopt);
    second = node_at(vector((*spring.at)[1]), bodies, first.body);
    if (first.body == second.body && first.nodes == second.nodes)
      throw ModelError("both ends are the same node; give points next to two nodes");
  } else {
    second = mean_of(spring.on.name, config, bodies);
    first.body = second.body;
  }
  const Vector3 direction = vector(spring.direction).normalized();
  contact::LinearEquation row;  // the distance of the ends along the direction
  double largest = 0;
  const auto add = [&](const SpringEnd& end, double sign) {
    auto& terms = end.body == second.body ? row.slave : row.master;
    for (std::size_t i = 0; i < end.nodes.size(); ++i) {
      terms.push_back({end.nodes[i], sign * end.weights[i] * direction});
      largest = std::max(largest, terms.back().coefficient.cwiseAbs().maxCoeff());
    }
  };
  add(second, 1);
  if (!has_ground) add(first, -1);
  const mechanics::Body &slave = bodies[second.body], &master = bodies[first.body];
  const double area = nodal_area(slave);
  contact::Pair pair;
  pair.name = spring.name;
  pair.slave_body = second.body;
  pair.master_body = first.body;
  pair.coupling = contact::equation_rows({&slave.mesh(), &slave.constraints()}, {&master.mesh(), &master.constraints()},
                                         std::vector{row}, area * largest);
  pair.coupling.area = {area};  // the weighted gap is the distance times this area, the multiplier force over area
  pair.gap = 0.0;
  pair.gap_per_value = Eigen::VectorXd::Zero(1);
  contact::GasketKind kind{spring.name, contact::GasketLaw::spring(curve_of(spring, area))};
  kind.stress_per_pressure = area;
  kind.is_spring = true;
  kind.creep = creep_alone("spring " + spring.name, make_creep_laws(spring.creep));
  pair.gasket = std::make_shared<const contact::Gasket>(std::make_shared<const contact::GasketKind>(std::move(kind)),
                                                        std::nullopt, std::vector<Vector3>(1, Vector3::Zero()));
  return pair;
}

}  // namespace

void append_springs(const config::Config& config, const Bodies& bodies, std::vector<contact::Pair>& pairs,
                    ErrorCollector& errors) {
  for (const config::Spring& spring : config.springs)
    errors.collect(spring.location, [&] {
      try {
        pairs.push_back(make_spring(spring, config, bodies));
      } catch (const std::invalid_argument& error) {
        throw ModelError(fmt::format("spring '{}': {}", spring.name, error.what()));
      }
    });
}

}  // namespace creepcontact::model
