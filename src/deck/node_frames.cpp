#include "node_frames.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace creepcontact::deck {

Matrix3 Transform::directions(const Vector3& position) const {
  Matrix3 result;
  if (is_cylindrical) {
    const Vector3 along = axis(), arm = position - a;
    const Vector3 radial = arm - arm.dot(along) * along;
    result.col(2) = along;
    result.col(0) = is_on_axis(position) ? along.unitOrthogonal() : radial.normalized();
    result.col(1) = along.cross(result.col(0));
    return result;
  }
  result.col(0) = a.normalized();
  result.col(2) = a.cross(b).normalized();
  result.col(1) = result.col(2).cross(result.col(0));
  return result;
}

bool Transform::is_on_axis(const Vector3& position) const {
  constexpr double rounding = 1e-9;  // of the positions
  const Vector3 along = axis(), arm = position - a;
  const double size = std::max({position.norm(), a.norm(), arm.norm()});
  return is_cylindrical && (arm - arm.dot(along) * along).norm() <= rounding * size;
}

NodeFrames::NodeFrames(const Deck& deck, const Resolver& resolver, std::vector<Note>& impossible) : deck_(deck) {
  for (const RawCard& raw : deck.cards) {
    if (raw.card.name != "TRANSFORM") continue;
    const auto refuse = [&](const std::string& why) { impossible.push_back({raw.card.place, raw.card.name, why}); };
    Transform transform{upper_case(raw.card.value("TYPE")) == "C", Vector3::Zero(), Vector3::Zero(), raw.card.place};
    for (std::size_t i = 0; i < 6 && !raw.data.empty(); ++i) {
      const auto value = i < raw.data[0].size() ? number(raw.data[0][i]) : std::nullopt;
      if (!value && i < raw.data[0].size() && !raw.data[0][i].empty())
        refuse("'" + raw.data[0][i] + "' is not a number");
      (i < 3 ? transform.a : transform.b)[static_cast<Eigen::Index>(i % 3)] = value.value_or(0);
    }
    const bool is_valid =
        transform.is_cylindrical ? transform.a != transform.b : !transform.a.cross(transform.b).isZero(0);
    const Numbers nodes = resolver.nodes(raw.card.value("NSET"));
    if (!is_valid) refuse("the two points give no directions");
    if (nodes.empty()) refuse("there is no node set '" + raw.card.value("NSET") + "'");
    for (const std::int64_t node : nodes) of_node_[node] = transforms_.size();
    transforms_.push_back(transform);
  }
}

const Transform* NodeFrames::of(std::int64_t node) const {
  const auto found = of_node_.find(node);
  return found == of_node_.end() ? nullptr : &transforms_[found->second];
}

Matrix3 NodeFrames::directions(std::int64_t node) const {
  const Transform* transform = of(node);
  if (transform == nullptr) return Matrix3::Identity();
  return transform->directions(deck_.positions[deck_.node_of_number.at(node)]);
}

bool NodeFrames::has_direction(std::int64_t node, int direction) const {
  const Transform* transform = of(node);
  return transform == nullptr || direction >= 3 ||
         !transform->is_on_axis(deck_.positions[deck_.node_of_number.at(node)]);
}

void NodeFrames::turn_forces(Loading& loading, std::vector<Note>& impossible) const {
  for (auto& [node, forces] : loading.forces) {
    if (of(node) == nullptr) continue;
    const Matrix3 turned = directions(node);
    std::map<int, Course> global;
    for (const auto& [direction, course] : forces) {
      if (direction > 3) {
        global[direction] = course;
        continue;
      }
      if (!has_direction(node, direction) && !course.is_zero())
        impossible.push_back({of(node)->place, "TRANSFORM",
                              fmt::format("a radial or tangential force at node {}, which is on the axis", node)});
      for (int k = 0; k < 3; ++k)
        if (const double part = turned(k, direction - 1); part != 0)
          global[k + 1] = global[k + 1].plus(course.scaled(part));
    }
    forces = std::move(global);
  }
}

}  // namespace creepcontact::deck
