/// [[springs]] from *SPRING

#include <map>
#include <set>

#include "draft.hpp"

namespace creepcontact::deck {
namespace {

class SpringMaker {
 public:
  explicit SpringMaker(Draft& draft) : draft_(draft) {}

  void make() {
    for (const RawCard* raw : draft_.cards("SPRING")) read(*raw);
    for (const SpringElement& element : draft_.deck.springs)
      if (!made_.contains(element.number))
        draft_.impossible.push_back(
            {element.place, "ELEMENT", fmt::format("no *SPRING gives the stiffness of element {}", element.number)});
  }

 private:
  void read(const RawCard& raw) {
    const std::string wanted = upper_case(raw.card.value("ELSET"));
    const auto found = draft_.deck.element_sets.find(wanted);
    if (found == draft_.deck.element_sets.end())
      return draft_.refuse(raw, fmt::format("there is no set of elements '{}'", raw.card.value("ELSET")));
    const std::set<std::int64_t> members(found->second.members.begin(), found->second.members.end());
    for (const SpringElement& element : draft_.deck.springs)
      if (members.contains(element.number) && made_.insert(element.number).second) spring(raw, element);
  }

  void spring(const RawCard& raw, const SpringElement& element) {
    config::Spring made;
    made.name = fmt::format("spring_{}", element.number);
    // The first line has degrees of freedom; that of SPRINGA is empty.
    std::array<int, 2> freedom{};
    if (element.type != "SPRINGA")
      for (std::size_t i = 0; i < element.nodes.size(); ++i) {
        const auto given = raw.data.empty() || raw.data[0].size() <= i ? std::nullopt : number(raw.data[0][i]);
        if (!given || *given < 1 || *given > 3)
          return draft_.refuse(raw, "expected a direction 1, 2 or 3 for each node of the spring in the first line");
        freedom[i] = static_cast<int>(*given);
      }
    if (element.type == "SPRING2" && freedom[0] != freedom[1])
      return draft_.refuse(raw, "a spring between two different directions is not known");
    if (!set_force(raw, element.type == "SPRINGA" ? 0 : 1, made)) return;
    for (const std::int64_t node : element.nodes)
      if (!draft_.deck.node_of_number.contains(node))
        return draft_.refuse(raw, fmt::format("element {}: there is no node {}", element.number, node));
    Vector3 direction = Vector3::Zero();
    if (element.type == "SPRINGA")
      direction = draft_.position(element.nodes[1]) - draft_.position(element.nodes[0]);
    else
      direction[freedom[0] - 1] = 1;
    if (direction.isZero(0))
      return draft_.refuse(raw, fmt::format("element {}: its nodes are at the same place", element.number));
    if (!set_ends(raw, element, direction, made)) return;
    const Vector3 unit = direction.normalized();
    made.direction = rounded(unit);
    draft_.add(draft_.config.springs, std::move(made), "springs",
               fmt::format("{}: *SPRING of element {}", raw.card.place.text(), element.number));
  }

  bool set_ends(const RawCard& raw, const SpringElement& element, Vector3& direction, config::Spring& made) {
    Numbers held;
    for (const std::int64_t node : element.nodes)
      if (draft_.is_used(node)) held.push_back(node);
    if (held.size() == 2) {
      made.at = {rounded(draft_.position(element.nodes[0])), rounded(draft_.position(element.nodes[1]))};
      return true;
    }
    if (held.empty()) {
      draft_.refuse(raw, fmt::format("element {}: no body has its nodes", element.number));
      return false;
    }
    // The other node is the ground, if it is held there; the direction is from the ground to the body.
    if (element.nodes.size() == 2) {
      const std::int64_t other = element.nodes[held.front() == element.nodes.front() ? 1 : 0];
      if (!draft_.loading.supports.contains(other)) {
        draft_.refuse(raw,
                      fmt::format("element {}: node {} belongs to no body and is not held", element.number, other));
        return false;
      }
      if (other == element.nodes[1]) direction = -direction;
    }
    made.on.name = draft_.mesh.add_nodes(draft_.name_for(held, made.name), held);
    made.ground = true;
    return true;
  }

  /// @param first  line of what follows the directions; the empty one of SPRINGA is not among the lines
  bool set_force(const RawCard& raw, std::size_t first, config::Spring& made) {
    const auto value = [&](std::size_t line, std::size_t field) {
      return line < raw.data.size() && field < raw.data[line].size() ? number(raw.data[line][field]) : std::nullopt;
    };
    if (!raw.card.has("NONLINEAR")) {
      const auto stiffness = value(first, 0);
      if (!stiffness || !(*stiffness > 0)) {
        draft_.refuse(raw, "expected a stiffness above 0 below the line of the directions, which is empty for SPRINGA");
        return false;
      }
      made.stiffness = *stiffness;
      return true;
    }
    // Rows of force and lengthening; a closure is a shortening.
    config::SpringCurve curve;
    for (std::size_t line = raw.data.size(); line-- > first;) {
      const auto force = value(line, 0), lengthening = value(line, 1);
      if (!force || !lengthening) {
        draft_.refuse(raw, "expected rows of a force and a relative displacement below the first line");
        return false;
      }
      curve.force.push_back(0 - *force);
      curve.closure.push_back(0 - *lengthening);
    }
    if (curve.force.size() < 2 || !is_increasing(curve.force) || !is_increasing(curve.closure) ||
        curve.force.front() > 0) {
      draft_.refuse(raw,
                    "expected at least two rows whose forces and displacements increase, with forces of both signs or "
                    "none that pulls");
      return false;
    }
    made.curve = std::move(curve);
    if (said_.insert(raw.card.place.line).second)
      draft_.left_out.push_back({raw.card.place, raw.card.name,
                                 "constant forces beyond the first and the last row: the curve goes on with its last "
                                 "slopes here"});
    return true;
  }

  Draft& draft_;
  std::set<std::int64_t> made_;
  std::set<decltype(Place::line)> said_;
};

}  // namespace

void make_springs(Draft& draft) {
  SpringMaker(draft).make();
}

}  // namespace creepcontact::deck
