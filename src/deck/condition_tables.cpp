/// [[supports]] and [[loads]]

#include <algorithm>
#include <array>
#include <cmath>

#include "draft.hpp"
#include "element_faces.hpp"

namespace creepcontact::deck {
namespace {

/// "x = 0, y = 1": components that are prescribed at a node.
std::string components(const std::map<int, Course>& directions, const std::array<const char*, 3>& names, int n) {
  std::string text;
  for (const auto& [direction, course] : directions)
    if (direction <= n)
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", names[static_cast<std::size_t>(direction) - 1],
                          course.toml());
  return text;
}

struct SupportText {
  std::string displacement, more;
  auto operator<=>(const SupportText&) const = default;  // NOLINT(modernize-use-nullptr): it sees a 0 in the default
};

/// What holds a node: one table, or along turned directions one per direction.
std::vector<SupportText> support_texts(Draft& draft, std::int64_t node, const std::map<int, Course>& directions) {
  const int n = draft.is_section() ? 2 : 3;
  const Transform* transform = draft.frames.of(node);
  if (transform == nullptr) return {{components(directions, {"x", "y", "z"}, n), ""}};
  const bool is_on_axis = transform->is_on_axis(draft.position(node));
  if (transform->is_cylindrical && !is_on_axis)
    return {{components(directions, {"radial", "tangential", "axial"}, n),
             fmt::format("axis = {}\norigin = {}\n", toml_vector(transform->axis()), toml_vector(transform->a))}};
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
  std::vector<SupportText> result;
  const Matrix3 axes = transform->directions(draft.position(node));
  for (const auto& [direction, course] : directions)
    if (direction <= n)
      result.push_back({fmt::format("along = {}", course.toml()),
                        fmt::format("direction = {}\n", toml_vector(axes.col(direction - 1)))});
  return result;
}

void write(Draft& draft, const Loading::Body& load) {
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
      draft.add(
          fmt::format("\n[[loads]]                    # *DLOAD, CENTRIF\nbody = {}\nrotation = {{ axis = {}, origin = "
                      "{}, angular_velocity = {}, density = {:.15g} }}\n",
                      toml_string(body.name), toml_vector({g[3], g[4], g[5]}), toml_vector({g[0], g[1], g[2]}),
                      load.course.toml("sqrt"), density));
      continue;
    }
    const double length = std::hypot(g[0], g[1], g[2]);
    std::array<std::string, 3> force;
    for (std::size_t k = 0; k < 3; ++k) force[k] = load.course.scaled(length > 0 ? density * g[k] / length : 0).toml();
    draft.add(fmt::format("\n[[loads]]                    # *DLOAD, GRAV\nbody = {}\nbody_force = [{}, {}, {}]\n",
                          toml_string(body.name), force[0], force[1], force[2]));
  }
}

void write_pressures(Draft& draft) {
  std::map<std::string, std::vector<ElementFace>> pressures;  // by the pressure
  for (const auto& [face, course] : draft.loading.pressures) {
    if (deck::face(element_cell(draft.deck, face.element), face.face) == nullptr) {
      draft.impossible.push_back(
          {draft.first("DLOAD"), "DLOAD", fmt::format("element {} has no face P{}", face.element, face.face)});
      return;
    }
    pressures[course.toml()].push_back(face);
  }
  int number = 0;
  for (const auto& [pressure, faces] : pressures)
    draft.add(fmt::format("\n[[loads]]                    # *DLOAD\non = {}\npressure = {}\n",
                          toml_string(draft.mesh.add_faces(fmt::format("pressure_{}", ++number), faces)), pressure));
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

void write_supports(Draft& draft) {
  std::map<SupportText, Numbers> nodes_of;
  const auto add = [&](std::int64_t node, const std::map<int, Course>& directions, const std::string& window) {
    for (SupportText& text : support_texts(draft, node, directions)) {
      if (text.displacement.empty()) continue;
      text.more += window;
      nodes_of[text].push_back(node);
    }
  };
  for (const auto& [node, directions] : draft.loading.supports) {
    if (!draft.is_used(node)) continue;
    refuse_rotation(draft, node, directions);
    std::map<int, Course> always = directions;
    std::map<std::string, std::map<int, Course>> for_a_time;
    for (const auto& [direction, course] : directions) {
      const auto windows = draft.loading.windows.find({node, direction});
      if (windows == draft.loading.windows.end()) continue;
      always.erase(direction);
      for (const Window& window : windows->second) {
        std::string text;
        if (window.from) text += fmt::format("from = {:.15g}\n", *window.from);
        if (window.is_relative) text += "relative = true              # FIXED\n";
        if (window.until) text += fmt::format("until = {:.15g}\n", *window.until);
        for_a_time[text][direction] = course;
      }
    }
    add(node, always, "");
    for (const auto& [window, of_window] : for_a_time) add(node, of_window, window);
  }
  int number = 0;
  for (const auto& [text, nodes] : nodes_of) {
    const std::string general = fmt::format("support_{}", ++number);
    draft.add(fmt::format("\n[[supports]]                 # *BOUNDARY\non = {}\ndisplacement = {{ {} }}\n{}",
                          toml_string(draft.mesh.add_nodes(draft.name_for(nodes, general), nodes)), text.displacement,
                          text.more));
  }
}

void write_loads(Draft& draft) {
  for (const auto& [node, directions] : draft.loading.forces) {
    if (!draft.is_used(node)) {
      draft.impossible.push_back(
          {draft.first("CLOAD"), "CLOAD", fmt::format("a force at node {}, which no element has", node)});
      continue;
    }
    std::array<std::string, 3> force{"0", "0", "0"};
    bool acts = false;
    for (const auto& [direction, course] : directions)
      if (direction > 3 && !course.is_zero() && !turns(draft, node))
        draft.impossible.push_back({draft.first("CLOAD"), "CLOAD",
                                    fmt::format("a moment at node {}: nodes of solids have no rotation", node)});
      else if (direction <= 3 && !course.is_zero()) {
        force[static_cast<std::size_t>(direction) - 1] = course.toml();
        acts = true;
      }
    if (acts)
      draft.add(fmt::format("\n[[loads]]                    # *CLOAD\nnode = {}\nforce = [{}, {}, {}]\n", node,
                            force[0], force[1], force[2]));
  }
  write_pressures(draft);
  for (const Loading::Body& load : draft.loading.bodies) write(draft, load);
}

}  // namespace creepcontact::deck
