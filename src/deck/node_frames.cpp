#include "node_frames.hpp"

#include <Eigen/Geometry>

namespace creepcontact::deck {

Matrix3 Transform::directions(const Vector3& position) const {
  Matrix3 result;
  if (is_cylindrical) {
    const Vector3 along = axis(), arm = position - a;
    const Vector3 radial = arm - arm.dot(along) * along;
    result.col(2) = along;
    constexpr double on_axis = 1e-12;
    result.col(0) = along.unitOrthogonal();
    if (radial.norm() > on_axis * arm.norm()) result.col(0) = radial.normalized();
    result.col(1) = along.cross(result.col(0));
    return result;
  }
  result.col(0) = a.normalized();
  result.col(2) = a.cross(b).normalized();
  result.col(1) = result.col(2).cross(result.col(0));
  return result;
}

NodeFrames::NodeFrames(const Deck& deck, const Resolver& resolver, std::vector<Note>& impossible) : deck_(deck) {
  for (const RawCard& raw : deck.cards) {
    if (raw.card.name != "TRANSFORM") continue;
    const auto refuse = [&](const std::string& why) { impossible.push_back({raw.card.place, raw.card.name, why}); };
    const std::string type = upper_case(raw.card.value("TYPE"));
    if (!type.empty() && type != "R" && type != "C") {
      refuse("TYPE=" + type + " is not known; R and C are");
      continue;
    }
    Transform transform{type == "C", Vector3::Zero(), Vector3::Zero(), raw.card.place};
    for (std::size_t i = 0; i < 6 && !raw.data.empty(); ++i) {
      const auto value = i < raw.data[0].size() ? number(raw.data[0][i]) : std::nullopt;
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

void NodeFrames::turn_forces(Loading& loading) const {
  for (auto& [node, forces] : loading.forces) {
    if (of(node) == nullptr) continue;
    const Matrix3 turned = directions(node);
    std::map<int, Course> global;
    for (const auto& [direction, course] : forces) {
      if (direction > 3) {
        global[direction] = course;
        continue;
      }
      for (int k = 0; k < 3; ++k)
        if (const double part = turned(k, direction - 1); part != 0)
          global[k + 1] = global[k + 1].plus(course.scaled(part));
    }
    forces = std::move(global);
  }
}

}  // namespace creepcontact::deck
