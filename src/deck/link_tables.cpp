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
void make_cyclic(Draft& draft, const RawCard& model) {
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
    const config::Cyclic cyclic{
        {{{names[first]}, {names[1 - first]}}}, rounded(axis), rounded(a), rounded(360 / *sectors), {}};
    draft.add(draft.config.cyclic, cyclic, "cyclic", model.card.place.text() + ": *CYCLIC SYMMETRY MODEL");
  }
}

/// Three components of one kind, those that are given.
std::array<std::optional<Function>, 3> three(const std::map<std::int64_t, std::map<int, Course>>& of, std::int64_t node,
                                             int first) {
  std::array<std::optional<Function>, 3> all;
  if (const auto found = of.find(node); found != of.end())
    for (int k = 0; k < 3; ++k)
      if (const auto own = found->second.find(first + k); own != found->second.end())
        all[static_cast<std::size_t>(k)] = own->second.function();
  return all;
}

std::array<Function, 3> resultant(const std::map<std::int64_t, std::map<int, Course>>& forces, std::int64_t node,
                                  int first) {
  std::array<Function, 3> all;
  const auto given = three(forces, node, first);
  for (std::size_t k = 0; k < 3; ++k) all[k] = given[k].value_or(0.0);
  return all;
}

void make_rigid(Draft& draft, const RigidGroup& group) {
  const auto refuse = [&](const std::string& why) { draft.impossible.push_back({group.place, group.card, why}); };
  Numbers nodes = group.nodes;
  std::erase_if(nodes, [&](std::int64_t node) { return !draft.is_used(node); });
  if (nodes.empty()) return refuse("no element has its nodes");
  const bool is_rigid = group.surface.empty();
  const auto surface = draft.deck.surfaces.find(group.surface);
  config::Rigid rigid;
  rigid.on = {{.name = is_rigid ? draft.mesh.add_nodes(draft.name_for(nodes, "rigid"), nodes)
                                : draft.mesh.add_faces(
                                      surface == draft.deck.surfaces.end() ? group.surface : surface->second.name,
                                      faces_named(draft.deck, group.surface, draft.impossible)),
               .location = {}}};
  rigid.origin = rounded(draft.position(group.reference));
  const std::int64_t turning = group.rotation.value_or(group.reference);
  const int first = group.rotation ? 1 : 4;
  if (!draft.is_used(group.reference)) {  // else supports and loads of the node act on the surface
    rigid.displacement = three(draft.loading.supports, group.reference, 1);
    rigid.force = resultant(draft.loading.forces, group.reference, 1);
  }
  rigid.rotation = three(draft.loading.supports, turning, first);
  rigid.moment = resultant(draft.loading.forces, turning, first);
  draft.add(is_rigid ? draft.config.rigid : draft.config.coupling, rigid, is_rigid ? "rigid" : "coupling",
            group.place.text() + ": *" + group.card);
}

void make_equation(Draft& draft, const DeckEquation& equation) {
  config::Equation made;
  for (const auto& [unknown, coefficient] : equation.terms) {  // ordered by node
    const int node = static_cast<int>(unknown.first);
    if (made.terms.empty() || made.terms.back().node != node) made.terms.push_back({node, {}});
    made.terms.back().coefficient[static_cast<std::size_t>(unknown.second)] = rounded(coefficient);
  }
  if (!equation.value.is_zero()) made.value = equation.value.function();
  draft.add(draft.config.equations, std::move(made), "equations",
            fmt::format("{}: *{}", equation.place.text(), equation.card));
}

}  // namespace

void make_links(Draft& draft) {
  for (const RawCard* model : draft.cards("CYCLIC SYMMETRY MODEL")) make_cyclic(draft, *model);
  for (const RigidGroup& group : draft.rigid) make_rigid(draft, group);
  for (const RigidGroup& group : draft.rigid) {
    if (!draft.is_used(group.reference)) draft.loading.forces.erase(group.reference);
    if (group.rotation && !draft.is_used(*group.rotation)) draft.loading.forces.erase(*group.rotation);
  }
  for (const DeckEquation& equation : draft.equations) make_equation(draft, equation);
}

}  // namespace creepcontact::deck
