#include "pretension.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <unordered_map>

#include "creepcontact/base/disjoint_sets.hpp"
#include "element_faces.hpp"

namespace creepcontact::deck {
namespace {

class Cutter {
 public:
  Cutter(Deck& deck, std::vector<Note>& impossible) : deck_(deck), impossible_(impossible) {}

  std::vector<PretensionSection> cut() {
    std::vector<PretensionSection> sections;
    for (const RawCard& raw : deck_.cards)
      if (raw.card.name == "PRE-TENSION SECTION")
        if (auto made = cut(raw)) sections.push_back(std::move(*made));
    return sections;
  }

 private:
  std::optional<PretensionSection> refuse(const RawCard& raw, const std::string& why) {
    impossible_.push_back({raw.card.place, raw.card.name, why});
    return std::nullopt;
  }

  std::optional<PretensionSection> cut(const RawCard& raw) {
    const std::string name = raw.card.value("SURFACE");
    if (name.empty()) return refuse(raw, "only sections that are a SURFACE of solid elements are known");
    const auto found = deck_.surfaces.find(upper_case(name));
    if (found == deck_.surfaces.end() || found->second.of_nodes)
      return refuse(raw, fmt::format("there is no surface '{}' of element faces", name));
    const std::string& node = raw.card.value("NODE");
    if (node.empty()) return refuse(raw, "NODE is missing: the reference node");
    const Numbers reference = Resolver(deck_).nodes(node);
    if (reference.size() != 1)
      return refuse(raw, fmt::format("NODE={} is {} nodes; expected the reference node, or a set of this node alone",
                                     node, reference.size()));
    PretensionSection section;
    section.reference = reference.front();
    section.place = raw.card.place;
    section.faces = faces_of(deck_, found->second, impossible_);
    if (section.faces.empty()) return refuse(raw, fmt::format("the surface '{}' has no faces", name));

    std::set<std::int64_t> nodes;
    std::map<Numbers, ElementFace> face_of;  // by its corners
    std::set<std::int64_t> own;
    for (const ElementFace& face : section.faces) {
      const Numbers of_face = face_nodes(deck_, face);
      nodes.insert(of_face.begin(), of_face.end());
      face_of[face_corners(deck_, face)] = face;
      own.insert(face.element);
      section.normal += outward_area(deck_, face);
    }
    section.normal = given_normal(raw).value_or(section.normal).normalized();
    split(section, nodes, face_of, own);
    if (section.opposite.size() != section.faces.size())
      return refuse(raw, fmt::format("the surface '{}' is not within a body: {} of its {} faces have an element on the "
                                     "other side",
                                     name, section.opposite.size(), section.faces.size()));
    return section;
  }

  std::optional<Vector3> given_normal(const RawCard& raw) const {
    if (raw.data.empty()) return std::nullopt;
    Vector3 normal = Vector3::Zero();
    for (std::size_t k = 0; k < 3 && k < raw.data[0].size(); ++k)
      normal[static_cast<Eigen::Index>(k)] = number(raw.data[0][k]).value_or(0);
    return normal.isZero(0) ? std::nullopt : std::optional(normal);
  }

  Vector3 position(std::int64_t node) const { return deck_.positions[deck_.node_of_number.at(node)]; }

  /// Elements at the nodes are joined by faces other than those of the section. Those that are joined to elements of
  /// the surface get copies of its nodes; the others keep theirs, as in CalculiX.
  void split(PretensionSection& section, const std::set<std::int64_t>& nodes,
             const std::map<Numbers, ElementFace>& face_of, const std::set<std::int64_t>& own) {
    Numbers near;
    for (const ElementBlock& block : deck_.elements)
      for (const std::int64_t number : block.numbers)
        if (std::ranges::any_of(element_nodes(deck_, number), [&](std::int64_t node) { return nodes.contains(node); }))
          near.push_back(number);
    std::ranges::sort(near);
    DisjointSets sides(near.size() + 1);
    const std::size_t own_side = near.size();
    std::map<Numbers, std::size_t> neighbour;  // by corners of faces
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (own.contains(near[i])) sides.join(i, own_side);
      for (int k = 1; face(element_cell(deck_, near[i]), k) != nullptr; ++k) {
        const Numbers corners = face_corners(deck_, {near[i], k});
        if (face_of.contains(corners)) continue;
        if (const auto [other, is_first] = neighbour.try_emplace(corners, i); !is_first) sides.join(i, other->second);
      }
    }
    std::unordered_map<std::int64_t, std::int64_t> copy_of;
    std::int64_t next = *std::ranges::max_element(deck_.node_numbers) + 1;
    for (const std::int64_t node : nodes) {
      copy_of[node] = next;
      deck_.copies[next] = node;
      section.nodes.emplace_back(next, node);
      deck_.node_of_number.insert(next, static_cast<std::uint32_t>(deck_.positions.size()));
      deck_.node_numbers.push_back(next++);
      deck_.positions.push_back(position(node));
    }
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (sides.find(i) != sides.find(own_side)) {
        for (int k = 1; face(element_cell(deck_, near[i]), k) != nullptr; ++k)
          if (face_of.contains(face_corners(deck_, {near[i], k}))) section.opposite.push_back({near[i], k});
        continue;
      }
      for (std::int64_t& node : element_nodes(deck_, near[i]))
        if (const auto copy = copy_of.find(node); copy != copy_of.end()) node = copy->second;
    }
  }

  Deck& deck_;
  std::vector<Note>& impossible_;
};

}  // namespace

std::vector<PretensionSection> cut_sections(Deck& deck, std::vector<Note>& impossible) {
  return Cutter(deck, impossible).cut();
}

void append_equations(const PretensionSection& section, int n_components, std::vector<DeckEquation>& equations) {
  Vector3 first = section.normal.unitOrthogonal();
  if (n_components == 2) first = Vector3::UnitZ().cross(section.normal);
  std::vector<Vector3> directions{section.normal, first};
  if (n_components == 3) directions.push_back(section.normal.cross(first));
  for (const auto& [own, opposite] : section.nodes)
    for (const Vector3& direction : directions) {
      DeckEquation equation{{}, {}, section.place, "PRE-TENSION SECTION"};
      for (int k = 0; k < 3; ++k)
        if (direction[k] != 0) {
          equation.terms[{own, k}] = direction[k];
          equation.terms[{opposite, k}] = -direction[k];
        }
      if (&direction == directions.data()) equation.terms[{section.reference, 0}] = -1;
      equations.push_back(std::move(equation));
    }
}

}  // namespace creepcontact::deck
