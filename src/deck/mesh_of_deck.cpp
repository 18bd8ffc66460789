#include "creepcontact/deck/mesh_of_deck.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/deck/deck.hpp"
#include "element_faces.hpp"
#include "mesh_output.hpp"

namespace creepcontact::deck {
namespace {

/// Sets of mesh programs may mix volumes with the surfaces around them.
std::map<int, Numbers> by_dimension(const Deck& deck, const Numbers& elements) {
  std::map<int, Numbers> result;
  for (const std::int64_t element : elements) result[mesh::dimension(element_cell(deck, element))].push_back(element);
  return result;
}

/// Triangles and quadrilaterals; lines are left out.
bool is_face(const SkinElements& skin) {
  constexpr std::array faces{"CPS", "CPE", "CAX", "S", "M3D", "STRI", "DC2D", "SFM3D", "R3D"};
  return (skin.n_nodes == 3 || skin.n_nodes == 4 || skin.n_nodes == 6 || skin.n_nodes == 8) &&
         std::ranges::any_of(faces, [&](const char* start) { return skin.type.starts_with(start); });
}

Numbers all_elements(const Deck& deck) {
  Numbers all;
  for (const ElementBlock& block : deck.elements) all.insert(all.end(), block.numbers.begin(), block.numbers.end());
  std::ranges::sort(all);
  return all;
}

}  // namespace

io::MshContent mesh_of_deck(const std::filesystem::path& path) {
  const Deck deck = read_deck(path);
  MeshOutput output(deck);
  const Resolver resolver(deck);
  std::set<std::int64_t> grouped;
  const auto add = [&](const std::string& name, const Numbers& elements) {
    const std::map<int, Numbers> parts = by_dimension(deck, elements);
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
      output.add_body({.name = name, .material = {}, .elements = part->second, .orientation = {}, .section = {}});
      grouped.insert(part->second.begin(), part->second.end());
    }
  };
  for (const auto& [upper, set] : deck.element_sets)
    if (const Numbers elements = resolver.elements(upper); !elements.empty()) add(set.name, elements);
  std::map<std::int64_t, Numbers> skins;  // nodes by the number of the element
  for (const SkinElements& skin : deck.skins) {
    if (!is_face(skin)) continue;
    for (std::size_t i = 0; i < skin.numbers.size(); ++i) {
      const auto first = skin.nodes.begin() + static_cast<std::ptrdiff_t>(i * skin.n_nodes);
      skins[skin.numbers[i]] = {first, first + static_cast<std::ptrdiff_t>(skin.n_nodes)};
    }
  }
  for (const auto& [upper, set] : deck.element_sets) {
    std::vector<Numbers> faces;
    for (const std::int64_t member : set.members)
      if (const auto found = skins.find(member); found != skins.end()) faces.push_back(found->second);
    if (!faces.empty()) output.add_skin(set.name, faces);
  }
  Numbers left = all_elements(deck);
  std::erase_if(left, [&](std::int64_t element) { return grouped.contains(element); });
  if (!left.empty()) add(grouped.empty() ? "elements" : "other_elements", left);
  std::vector<Note> wrong;
  for (const auto& [upper, surface] : deck.surfaces)
    if (const std::vector<ElementFace> faces = faces_of(deck, surface, wrong); !faces.empty())
      output.add_faces(surface.name, faces);
  for (const Note& note : wrong) throw ConfigError(note.place.text() + ": *" + note.card + ": " + note.consequence);
  for (const auto& [upper, set] : deck.node_sets)
    if (const Numbers nodes = resolver.nodes(upper); !nodes.empty()) output.add_nodes(set.name, nodes);
  std::size_t n_other = 0;
  for (const SkinElements& skin : deck.skins) n_other += is_face(skin) ? 0 : 1;
  for (const Note& note : deck.impossible) {
    const bool is_skin = std::ranges::any_of(
        deck.skins, [&](const SkinElements& skin) { return skin.place.text() == note.place.text(); });
    n_other += note.card == "ELEMENT" && !is_skin ? 1 : 0;
  }
  if (n_other > 0)
    log::warning("{}: {} kinds of elements are left out: only solid elements and sections of solids are known",
                 path.string(), n_other);
  for (const Note& note : deck.left_out)
    if (note.card == "ELSET" || note.card == "NSET")
      log::warning("{}: *{}: {}", note.place.text(), note.card, note.consequence);
  return output.take();
}

}  // namespace creepcontact::deck
