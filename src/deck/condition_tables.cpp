/// [[supports]] and [[loads]]

#include <algorithm>
#include <array>
#include <cmath>

#include "draft.hpp"
#include "element_faces.hpp"

namespace creepcontact::deck {
namespace {

/// Components that are prescribed at a node.
std::array<std::optional<Function>, 3> components(const std::map<int, Course>& directions, int n) {
  std::array<std::optional<Function>, 3> result;
  for (const auto& [direction, course] : directions)
    if (direction <= n) result[static_cast<std::size_t>(direction) - 1] = course.function();
  return result;
}

/// Tells supports from each other that are alike but for their places.
std::string text_of(const config::Support& support) {
  std::string text;
  const auto add = [&](const char* name, const std::optional<Function>& value) {
    if (value) text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, value->text());
  };
  constexpr std::array names{"x", "y", "z"}, cylindrical{"radial", "tangential", "axial"};
  for (std::size_t i = 0; i < 3; ++i) add(names[i], support.displacement[i]);
  for (std::size_t i = 0; i < 3; ++i) add(cylindrical[i], support.cylindrical[i]);
  add("along", support.along);
  for (const auto& vector : {support.axis, support.origin, support.direction.value_or(std::array<double, 3>{})})
    for (const double component : vector) text += fmt::format("\n{}", component);
  for (const auto& time : {support.from, support.until}) text += time ? fmt::format("\n{}", *time) : "\n";
  return text + (support.relative ? "\nrelative" : "");
}

bool holds_something(const config::Support& support) {
  const auto is_given = [](const std::optional<Function>& value) { return value.has_value(); };
  return support.along || std::ranges::any_of(support.displacement, is_given) ||
         std::ranges::any_of(support.cylindrical, is_given);
}

/// What holds a node: one support, or along turned directions one per direction.
std::vector<config::Support> supports_of(Draft& draft, std::int64_t node, const std::map<int, Course>& directions) {
  const int n = draft.is_section() ? 2 : 3;
  const Transform* transform = draft.frames.of(node);
  config::Support support;
  if (transform == nullptr) {
    support.displacement = components(directions, n);
    return {support};
  }
  const bool is_on_axis = transform->is_on_axis(draft.position(node));
  if (transform->is_cylindrical && !is_on_axis) {
    support.cylindrical = components(directions, n);
    support.axis = rounded(transform->axis());
    support.origin = rounded(transform->a);
    return {support};
  }
  // On the axis any two directions across it are as good, if the node is held in both.
  const auto holds = [&](int direction) {
    const auto found = directions.find(direction);
    return found != directions.end() && found->second.is_zero();
  };
  const bool is_held_across = holds(1) && holds(2);
  if (is_on_axis && !is_held_across && (directions.contains(1) || directions.contains(2))) {
    draft.impossible.push_back(
        {transform->place, "TRANSFORM",
         fmt::format("a radial or tangential support of node {}, which is on the axis; hold it in "
                     "both directions with 0, or in none",
                     node)});
    return {};
  }
  std::vector<config::Support> result;
  const Matrix3 axes = transform->directions(draft.position(node));
  for (const auto& [direction, course] : directions) {
    if (direction > n) continue;
    support.along = course.function();
    support.direction = rounded(axes.col(direction - 1));
    result.push_back(support);
  }
  return result;
}

void make_body_load(Draft& draft, const Loading::Body& load) {
  for (const DeckBody& body : draft.bodies.bodies) {
    Numbers common;
    std::ranges::set_intersection(load.elements, body.elements, std::back_inserter(common));
    if (common.empty()) continue;
    const auto refuse = [&](const Place& at, const char* card, const std::string& why) {
      draft.impossible.push_back({at, card, why});
    };
    if (common.size() != body.elements.size()) {
      refuse(draft.first("DLOAD"), "DLOAD", fmt::format("a body force on a part of body '{}' only", body.name));
      continue;
    }
    const Material& material = draft.deck.materials.at(body.material);
    if (!material.density || material.density->rows.empty()) {
      refuse(material.place, "MATERIAL", fmt::format("'{}' needs a *DENSITY", material.name));
      continue;
    }
    const double density = material.density->rows.front().front();
    if (std::ranges::any_of(material.density->rows, [&](const auto& row) { return row.front() != density; })) {
      refuse(material.density->place, "DENSITY", "a density that depends on the temperature is not known");
      continue;
    }
    const std::vector<double>& g = load.load.geometry;
    if (load.load.kind == BodyLoad::Kind::centrifugal) {
      const bool is_axisymmetric = draft.analysis == settings::Analysis::axisymmetric;
      const bool is_about_axis = g[3] == 0 && g[5] == 0 && g[4] != 0 && g[0] == 0;
      const bool is_in_plane = g[3] == 0 && g[4] == 0 && g[5] != 0;
      if (draft.is_section() && !(is_axisymmetric ? is_about_axis : is_in_plane)) {
        refuse(draft.first("DLOAD"), "DLOAD",
               is_axisymmetric
                   ? "CENTRIF about another axis than y, the axis of the model"
                   : "CENTRIF of a plane section about an axis in its plane: the force would change along z");
        continue;
      }
      const config::Rotation rotation{rounded(Vector3(g[3], g[4], g[5])), rounded(Vector3(g[0], g[1], g[2])),
                                      load.course.function("sqrt"), rounded(density)};
      draft.add(draft.config.loads, {{}, {body.name}, rotation, {}}, "loads", "*DLOAD, CENTRIF");
      continue;
    }
    const double length = std::hypot(g[0], g[1], g[2]);
    config::BodyForce force;
    for (std::size_t k = 0; k < 3; ++k)
      force.value[k] = load.course.scaled(length > 0 ? density * g[k] / length : 0).function();
    draft.add(draft.config.loads, {{}, {body.name}, force, {}}, "loads", "*DLOAD, GRAV");
  }
}

void make_pressures(Draft& draft) {
  std::map<std::string, std::pair<Function, std::vector<ElementFace>>> pressures;  // by the text of the pressure
  for (const auto& [face, course] : draft.loading.pressures) {
    if (deck::face(element_cell(draft.deck, face.element), face.face) == nullptr) {
      draft.impossible.push_back(
          {draft.first("DLOAD"), "DLOAD", fmt::format("element {} has no face P{}", face.element, face.face)});
      return;
    }
    auto& [pressure, faces] = pressures[course.function().text()];
    pressure = course.function();
    faces.push_back(face);
  }
  int number = 0;
  for (const auto& [text, one] : pressures) {
    const auto& [pressure, faces] = one;
    const std::string on = draft.mesh.add_faces(fmt::format("pressure_{}", ++number), faces);
    draft.add(draft.config.loads, {{on}, {}, config::Pressure{pressure}, {}}, "loads", "*DLOAD");
  }
}

/// Whether a node gives its rotation to a rigid body.
bool turns(const Draft& draft, std::int64_t node) {
  return std::ranges::any_of(draft.rigid,
                             [&](const RigidGroup& group) { return !group.rotation && group.reference == node; });
}

void refuse_rotation(Draft& draft, std::int64_t node, const std::map<int, Course>& directions) {
  for (const auto& [direction, course] : directions)
    if (direction > 3 && !course.is_zero() && !turns(draft, node))
      draft.impossible.push_back(
          {draft.first("BOUNDARY"), "BOUNDARY", fmt::format("a rotation of node {}: nodes of solids have none", node)});
}

}  // namespace

void make_supports(Draft& draft) {
  std::map<std::string, std::pair<config::Support, Numbers>> alike;
  const auto add = [&](std::int64_t node, const std::map<int, Course>& directions, const Window& window) {
    for (config::Support& support : supports_of(draft, node, directions)) {
      if (!holds_something(support)) continue;
      if (window.from) support.from = rounded(*window.from);
      if (window.until) support.until = rounded(*window.until);
      support.relative = window.is_relative;
      auto& [first, nodes] = alike[text_of(support)];
      if (nodes.empty()) first = support;
      nodes.push_back(node);
    }
  };
  for (const auto& [node, directions] : draft.loading.supports) {
    if (!draft.is_used(node)) continue;
    refuse_rotation(draft, node, directions);
    std::map<int, Course> always = directions;
    std::map<Window, std::map<int, Course>> for_a_time;
    for (const auto& [direction, course] : directions) {
      const auto windows = draft.loading.windows.find({node, direction});
      if (windows == draft.loading.windows.end()) continue;
      always.erase(direction);
      for (const Window& window : windows->second) for_a_time[window][direction] = course;
    }
    add(node, always, {});
    for (const auto& [window, of_window] : for_a_time) add(node, of_window, window);
  }
  int number = 0;
  for (auto& [text, one] : alike) {
    auto& [support, nodes] = one;
    const std::string general = fmt::format("support_{}", ++number);
    support.on.name = draft.mesh.add_nodes(draft.name_for(nodes, general), nodes);
    const std::string key = draft.add(draft.config.supports, support, "supports", "*BOUNDARY");
    if (support.relative) draft.comment(key + ".relative", "FIXED");
  }
}

void make_loads(Draft& draft) {
  for (const auto& [node, directions] : draft.loading.forces) {
    if (!draft.is_used(node)) {
      draft.impossible.push_back(
          {draft.first("CLOAD"), "CLOAD", fmt::format("a force at node {}, which no element has", node)});
      continue;
    }
    config::PointForce force;
    bool acts = false;
    for (const auto& [direction, course] : directions)
      if (direction > 3 && !course.is_zero() && !turns(draft, node))
        draft.impossible.push_back({draft.first("CLOAD"), "CLOAD",
                                    fmt::format("a moment at node {}: nodes of solids have no rotation", node)});
      else if (direction <= 3 && !course.is_zero()) {
        force.value[static_cast<std::size_t>(direction) - 1] = course.function();
        acts = true;
      }
    force.node = static_cast<int>(node);
    if (acts) draft.add(draft.config.loads, {{}, {}, force, {}}, "loads", "*CLOAD");
  }
  make_pressures(draft);
  for (const Loading::Body& load : draft.loading.bodies) make_body_load(draft, load);
}

}  // namespace creepcontact::deck
