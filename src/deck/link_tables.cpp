/// [[cyclic]], [[rigid]] and [[equations]]

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "draft.hpp"
#include "element_faces.hpp"

namespace creepcontact::deck {
namespace {

/// The two faces of a sector, from its tie.
void write_cyclic(Draft& draft, const RawCard& model) {
  Vector3 a = Vector3::Zero(), b = Vector3::Zero();
  for (std::size_t i = 0; i < 6 && !model.data.empty() && i < model.data[0].size(); ++i)
    (i < 3 ? a : b)[static_cast<Eigen::Index>(i % 3)] = number(model.data[0][i]).value_or(0);
  const auto sectors = number(model.card.value("N"));
  if (!sectors || *sectors < 2 || a == b) return draft.refuse(model, "the number of sectors or the axis is missing");
  const std::string wanted = upper_case(model.card.value("TIE"));
  for (const RawCard* tie : draft.cards("TIE")) {
    if (!tie->card.has("CYCLICSYMMETRY") || (!wanted.empty() && upper_case(tie->card.value("NAME")) != wanted))
      continue;
    if (tie->data.empty() || tie->data[0].size() < 2) return draft.refuse(*tie, "expected two surfaces");
    std::array<std::vector<ElementFace>, 2> faces;
    std::array<Vector3, 2> mean{Vector3::Zero(), Vector3::Zero()};
    for (std::size_t side = 0; side < 2; ++side) {
      const auto surface = draft.deck.surfaces.find(upper_case(tie->data[0][side]));
      if (surface == draft.deck.surfaces.end())
        return draft.refuse(*tie, fmt::format("there is no surface '{}'", tie->data[0][side]));
      faces[side] = faces_of(draft.deck, surface->second, draft.impossible);
      if (faces[side].empty())
        return draft.refuse(*tie, fmt::format("the surface '{}' has no faces", tie->data[0][side]));
      double count = 0;
      for (const ElementFace& face : faces[side])
        for (const std::int64_t node : face_nodes(draft.deck, face)) {
          mean[side] += draft.position(node) - a;
          ++count;
        }
      mean[side] /= count;
    }
    // The second face is the first one turned by the positive angle.
    const Vector3 axis = (b - a).normalized();
    const double angle =
        std::atan2(axis.dot(mean[1].cross(mean[0])), mean[1].dot(mean[0]) - axis.dot(mean[1]) * axis.dot(mean[0]));
    const std::size_t first = angle >= 0 ? 1 : 0;
    std::array<std::string, 2> names;
    for (const std::size_t side : {first, 1 - first})
      names[side] = draft.mesh.add_faces(draft.deck.surfaces.at(upper_case(tie->data[0][side])).name, faces[side]);
    draft.add(
        fmt::format("\n[[cyclic]]                   # {}: *CYCLIC SYMMETRY MODEL\nbetween = [{}, {}]\naxis = "
                    "{}\norigin = {}\nangle = {:.15g}\n",
                    model.card.place.text(), toml_string(names[first]), toml_string(names[1 - first]),
                    toml_vector(axis), toml_vector(a), 360 / *sectors));
  }
}

/// Three components of one kind: those that are given, or nothing.
std::string three(const std::map<std::int64_t, std::map<int, Course>>& of, std::int64_t node, int first) {
  std::string text;
  const auto found = of.find(node);
  if (found == of.end()) return text;
  for (int k = 0; k < 3; ++k)
    if (const auto own = found->second.find(first + k); own != found->second.end())
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", "xyz"[k], own -> second.toml());
  return text;
}

std::string resultant(const std::map<std::int64_t, std::map<int, Course>>& forces, std::int64_t node, int first) {
  const auto found = forces.find(node);
  if (found == forces.end()) return "";
  std::array<std::string, 3> all{"0", "0", "0"};
  bool acts = false;
  for (int k = 0; k < 3; ++k)
    if (const auto own = found->second.find(first + k); own != found->second.end() && !own->second.is_zero()) {
      all[static_cast<std::size_t>(k)] = own->second.toml();
      acts = true;
    }
  return acts ? fmt::format("[{}, {}, {}]", all[0], all[1], all[2]) : "";
}

void write(Draft& draft, const RigidGroup& group) {
  const auto refuse = [&](const std::string& why) { draft.impossible.push_back({group.place, "RIGID BODY", why}); };
  Numbers nodes = group.nodes;
  std::erase_if(nodes, [&](std::int64_t node) { return !draft.is_used(node); });
  if (nodes.empty()) return refuse("no element has its nodes");
  for (const std::int64_t node : nodes)
    if (draft.bodies_at(node) != draft.bodies_at(nodes.front()))
      return refuse("its nodes belong to several bodies; a rigid surface is one of a single body");
  draft.add(fmt::format("\n[[rigid]]                    # {}: *RIGID BODY\non = {}\norigin = {}\n", group.place.text(),
                        toml_string(draft.mesh.add_nodes(draft.name_for(nodes, "rigid"), nodes)),
                        toml_vector(draft.position(group.reference))));
  const std::int64_t turning = group.rotation.value_or(group.reference);
  const int first = group.rotation ? 1 : 4;
  const auto table = [&](const char* key, const std::string& components) {
    if (!components.empty()) draft.add(fmt::format("{} = {{ {} }}\n", key, components));
  };
  const auto list = [&](const char* key, const std::string& text) {
    if (!text.empty()) draft.add(fmt::format("{} = {}\n", key, text));
  };
  if (!draft.is_used(group.reference)) {  // else supports and loads of the node act on the surface
    table("displacement", three(draft.loading.supports, group.reference, 1));
    list("force", resultant(draft.loading.forces, group.reference, 1));
  }
  table("rotation", three(draft.loading.supports, turning, first));
  list("moment", resultant(draft.loading.forces, turning, first));
}

void write(Draft& draft, const DeckEquation& equation) {
  std::map<std::int64_t, std::string> terms;
  for (const auto& [unknown, coefficient] : equation.terms)
    terms[unknown.first] += fmt::format(", {} = {:.15g}", "xyz"[unknown.second], coefficient);
  std::string text;
  for (const auto& [node, coefficients] : terms)
    text += fmt::format("{}{{ node = {}{} }}", text.empty() ? "" : ", ", node, coefficients);
  draft.add(fmt::format("\n[[equations]]                # {}: *{}\nterms = [{}]\n", equation.place.text(),
                        equation.card, text));
  if (!equation.value.is_zero()) draft.add(fmt::format("value = {}\n", equation.value.toml()));
}

}  // namespace

void write_links(Draft& draft) {
  for (const RawCard* model : draft.cards("CYCLIC SYMMETRY MODEL")) write_cyclic(draft, *model);
  for (const RigidGroup& group : draft.rigid) write(draft, group);
  for (const RigidGroup& group : draft.rigid) {
    if (!draft.is_used(group.reference)) draft.loading.forces.erase(group.reference);
    if (group.rotation && !draft.is_used(*group.rotation)) draft.loading.forces.erase(*group.rotation);
  }
  for (const DeckEquation& equation : draft.equations) write(draft, equation);
}

}  // namespace creepcontact::deck
