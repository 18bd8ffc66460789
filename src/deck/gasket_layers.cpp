#include "gasket_layers.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "element_faces.hpp"

namespace creepcontact::deck {
namespace {

constexpr double same_area = 0.01;  // of the area of the gasket

using Side = std::vector<Numbers>;  // corners of the faces of a gasket

Numbers sorted(Numbers numbers) {
  std::ranges::sort(numbers);
  return numbers;
}

class GasketTaker {
 public:
  GasketTaker(Deck& deck, std::vector<Note>& impossible) : deck_(deck), impossible_(impossible), resolver_(deck) {}

  std::vector<GasketLayer> take() {
    std::vector<GasketLayer> layers;
    std::set<std::int64_t> done;
    for (const GasketSection& section : deck_.gasket_sections) {
      const Numbers& given = deck_.element_sets.at(section.elements).members;
      const std::set<std::int64_t> members(given.begin(), given.end());
      std::vector<const GasketElement*> elements;
      for (const GasketElement& element : deck_.gaskets)
        if (members.contains(element.number) && done.insert(element.number).second) elements.push_back(&element);
      if (elements.empty())
        refuse(section.place, "the set of elements has no elements of gaskets: GK3D8 and others");
      else
        layers.push_back(layer(section, elements));
    }
    for (const GasketElement& element : deck_.gaskets)
      if (!done.contains(element.number)) {
        impossible_.push_back({element.place, "ELEMENT",
                               fmt::format("element {} belongs to no *GASKET SECTION; add it to the element set of one",
                                           element.number)});
        break;
      }
    remove_cards();
    deck_.gaskets.clear();
    return layers;
  }

 private:
  void refuse(const Place& place, const std::string& why) { impossible_.push_back({place, "GASKET SECTION", why}); }

  const Vector3& position(std::int64_t node) const { return deck_.positions[deck_.node_of_number.at(node)]; }
  Vector3 centre(const Numbers& face) const {
    Vector3 sum = Vector3::Zero();
    for (const std::int64_t node : face) sum += position(node);
    return sum / static_cast<double>(face.size());
  }
  /// Area; length of an edge.
  double size(const Numbers& face) const {
    if (face.size() == 2) return (position(face[1]) - position(face[0])).norm();
    double sum = 0;
    for (std::size_t i = 2; i < face.size(); ++i)
      sum += (position(face[i - 1]) - position(face[0])).cross(position(face[i]) - position(face[0])).norm() / 2;
    return sum;
  }
  double size(const std::vector<ElementFace>& faces) const {
    double sum = 0;
    for (const ElementFace& face : faces) {
      Numbers corners = face_nodes(deck_, face);
      corners.resize(face_corners(deck_, face).size());
      sum += size(corners);
    }
    return sum;
  }

  GasketLayer layer(const GasketSection& section, const std::vector<const GasketElement*>& elements) {
    GasketLayer made{section, {}, 0, 0, {}, {}, false};
    double area = 0;
    std::array<Side, 2> sides;
    for (const GasketElement* element : elements) {
      made.shears = made.shears || element->shears;
      for (std::size_t side = 0; side < 2; ++side) {
        sides[side].push_back(element->sides[side]);
        made.nodes.insert(made.nodes.end(), element->sides[side].begin(), element->sides[side].end());
      }
      const double own = size(element->sides[0]);
      area += own;
      made.thickness += own * (centre(element->sides[1]) - centre(element->sides[0])).norm();
    }
    made.thickness = section.thickness.value_or(made.thickness / area);
    for (std::size_t side = 0; side < 2; ++side) {
      auto found = shared_faces(sides[side]);
      if (!found) found = joined_faces(elements, side, made.interaction);
      if (!found)
        refuse(section.place, fmt::format("no body lies {} the gasket: no faces of bodies have its nodes, and no *TIE "
                                          "or *CONTACT PAIR names its side {}",
                                          side == 0 ? "below" : "above", side == 0 ? "SNEG" : "SPOS"));
      else
        made.faces[side] = *found;
    }
    if (made.faces[0].empty() || made.faces[1].empty()) return made;
    // The faces of one side limit the gasket; the others may go on beyond its edge.
    const std::array areas{size(made.faces[0]), size(made.faces[1])};
    made.slave = areas[1] < areas[0] ? 1 : 0;
    if (areas[made.slave] > (1 + same_area) * area)
      refuse(section.place, fmt::format("the gasket has the area {:.6g}, and the faces below and above it have {:.6g} "
                                        "and {:.6g}: it would press where it is not; name the faces under the gasket "
                                        "alone in the surface of one *TIE",
                                        area, areas[0], areas[1]));
    return made;
  }

  /// Faces of elements that have the corners of all faces of a side.
  std::optional<std::vector<ElementFace>> shared_faces(const Side& side) {
    if (faces_.empty()) index_faces();
    std::vector<ElementFace> result;
    for (const Numbers& corners : side) {
      const auto found = faces_.find(sorted(corners));
      if (found == faces_.end()) return std::nullopt;
      result.push_back(found->second);
    }
    return result;
  }

  void index_faces() {
    std::set<std::int64_t> of_gaskets;
    for (const GasketElement& element : deck_.gaskets)
      for (const Numbers& side : element.sides) of_gaskets.insert(side.begin(), side.end());
    for (const ElementBlock& block : deck_.elements)
      for (const std::int64_t number : block.numbers) {
        if (std::ranges::none_of(element_nodes(deck_, number), [&](auto node) { return of_gaskets.contains(node); }))
          continue;
        for (int k = 1; face(block.type.cell, k) != nullptr; ++k)
          faces_.emplace(face_corners(deck_, {number, k}), ElementFace{number, k});
      }
  }

  /// Whether a surface, or a set of nodes, holds a side of all elements.
  bool holds(const std::string& name, const std::vector<const GasketElement*>& elements, std::size_t side) const {
    const auto surface = deck_.surfaces.find(upper_case(name));
    std::set<std::int64_t> nodes, numbers;
    if (surface == deck_.surfaces.end()) {
      const Numbers own = resolver_.nodes(name);
      nodes.insert(own.begin(), own.end());
    } else {
      for (const SurfaceEntry& entry : surface->second.entries) {
        if (surface->second.of_nodes) {
          const Numbers own = resolver_.nodes(entry.target);
          nodes.insert(own.begin(), own.end());
        } else if (entry.side == (side == 0 ? "SNEG" : "SPOS") || entry.face == (side == 0 ? 2 : 1)) {
          const auto set = deck_.element_sets.find(upper_case(entry.target));
          if (const auto own = whole_number(entry.target)) numbers.insert(*own);
          if (const auto own = deck_.number_in_instance(entry.target, false)) numbers.insert(*own);
          if (set != deck_.element_sets.end()) numbers.insert(set->second.members.begin(), set->second.members.end());
        }
      }
    }
    return std::ranges::all_of(elements, [&](const GasketElement* element) {
      return numbers.contains(element->number) ||
             std::ranges::all_of(element->sides[side], [&](std::int64_t node) { return nodes.contains(node); });
    });
  }

  /// Faces that a tie or a contact pair joins with a side.
  std::optional<std::vector<ElementFace>> joined_faces(const std::vector<const GasketElement*>& elements,
                                                       std::size_t side, std::string& interaction) {
    for (const RawCard& raw : deck_.cards) {
      if (raw.card.name != "TIE" && raw.card.name != "CONTACT PAIR") continue;
      for (const std::vector<std::string>& names : raw.data) {
        for (std::size_t own = 0; own < 2 && names.size() >= 2; ++own) {
          if (!holds(names[own], elements, side)) continue;
          std::vector<ElementFace> faces = faces_named(deck_, names[1 - own], impossible_);
          if (faces.empty()) continue;
          consumed_.insert({static_cast<std::size_t>(&raw - deck_.cards.data()),
                            static_cast<std::size_t>(&names - raw.data.data())});
          if (raw.card.name == "CONTACT PAIR" && !raw.card.has("TIED")) interaction = raw.card.value("INTERACTION");
          return faces;
        }
      }
    }
    return std::nullopt;
  }

  void remove_cards() {
    for (const auto& [number, line] : consumed_) {  // the last ones first: places stay as they are
      const auto card = deck_.cards.begin() + static_cast<std::ptrdiff_t>(number);
      card->data.erase(card->data.begin() + static_cast<std::ptrdiff_t>(line));
      if (card->data.empty()) deck_.cards.erase(card);
    }
  }

  Deck& deck_;
  std::vector<Note>& impossible_;
  Resolver resolver_;
  std::map<Numbers, ElementFace> faces_;  // of bodies, by their sorted corners
  /// Cards and their lines that join gaskets with bodies, the last one first.
  std::set<std::pair<std::size_t, std::size_t>, std::greater<>> consumed_;
};

}  // namespace

std::vector<GasketLayer> take_gaskets(Deck& deck, std::vector<Note>& impossible) {
  return GasketTaker(deck, impossible).take();
}

}  // namespace creepcontact::deck
