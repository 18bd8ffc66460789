#include "general_contact.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "creepcontact/mesh/surface_patch.hpp"
#include "element_faces.hpp"

namespace creepcontact::deck {
namespace {

constexpr double facing_reach = 0.02;  // of the diagonal of the smaller body
constexpr double same_area = 0.01;     // of areas

/// A smooth piece of a body that named surfaces contain as a whole or not at all.
struct Piece {
  std::size_t body = 0;
  std::vector<ElementFace> faces;
  std::set<std::string> surfaces;  // that contain it
  mesh::SurfacePatch patch;
};

class GeneralContact {
 public:
  GeneralContact(const Deck& deck, const Bodies& bodies, settings::Analysis analysis, std::vector<Note>& impossible)
      : deck_(deck), bodies_(bodies), impossible_(impossible) {
    mesh_.section.analysis = analysis;
  }

  std::vector<FacingSurfaces> find(const std::vector<ElementFace>& tied, const std::vector<JoinedFaces>& joined) {
    if (!asks_for_pieces()) return {};
    read_surfaces();
    tied_ = {tied.begin(), tied.end()};
    joined_ = &joined;
    mesh_.nodes = deck_.positions;
    count_faces();
    for (std::size_t body = 0; body < bodies_.bodies.size(); ++body) add_pieces(body);
    for (std::size_t a = 0; a < bodies_.bodies.size(); ++a)
      for (std::size_t b = a + 1; b < bodies_.bodies.size(); ++b) add_pairs(a, b);
    drop_hidden();
    std::vector<FacingSurfaces> result;
    for (const Pair& pair : pairs_) result.push_back(surfaces_of(pair));
    return result;
  }

 private:
  struct Pair {
    std::size_t first = 0, second = 0;  // pieces
    mesh::FacingPatches facing;
    Place place;
  };

  bool asks_for_pieces() const {
    return std::ranges::any_of(deck_.cards, [](const RawCard& raw) {
      return raw.card.name == "CONTACT INCLUSIONS" &&
             (raw.card.has("ALLEXTERIOR") || !std::ranges::all_of(raw.data, names_two_surfaces));
    });
  }

  static std::string name(const std::vector<std::string>& line, std::size_t i) {
    return i < line.size() ? upper_case(line[i]) : "";
  }

  /// The faces of all surfaces that the cards of general contact name.
  void read_surfaces() {
    static const std::set<std::string> cards{"CONTACT INCLUSIONS", "CONTACT EXCLUSIONS", "CONTACT PROPERTY ASSIGNMENT"};
    for (const RawCard& raw : deck_.cards) {
      if (!cards.contains(raw.card.name)) continue;
      for (const std::vector<std::string>& line : raw.data)
        for (std::size_t i = 0; i < 2; ++i) {
          const std::string own = name(line, i);
          if (own.empty() || surfaces_.contains(own)) continue;
          if (!deck_.surfaces.contains(own))
            impossible_.push_back({raw.card.place, raw.card.name, fmt::format("there is no surface '{}'", line[i])});
          const std::vector<ElementFace> faces = faces_named(deck_, own, impossible_);
          surfaces_[own] = {faces.begin(), faces.end()};
        }
    }
  }

  void count_faces() {
    for (const ElementBlock& block : deck_.elements)
      for (const std::int64_t number : block.numbers)
        for (int k = 1; face(block.type.cell, k) != nullptr; ++k) {
          const auto [found, is_new] = outer_.try_emplace(face_corners(deck_, {number, k}), ElementFace{number, k});
          if (!is_new) found->second = {};  // between two elements
        }
  }

  /// The face of the deck that is a face of a mesh; nullopt: it is none of those that may touch something.
  std::optional<ElementFace> free_face(const mesh::Face& face) const {
    Numbers corners;
    for (int i = 0; i < mesh::n_corners(face.type); ++i)
      corners.push_back(deck_.node_numbers[static_cast<std::size_t>(face.nodes[static_cast<std::size_t>(i)])]);
    std::ranges::sort(corners);
    const auto found = outer_.find(corners);
    if (found == outer_.end() || found->second.element == 0 || tied_.contains(found->second)) return std::nullopt;
    return found->second;
  }

  void add_pieces(std::size_t body) {
    mesh_.blocks.clear();
    std::map<mesh::CellType, mesh::CellBlock> blocks;
    Eigen::AlignedBox3d& box = boxes_.emplace_back();
    for (const std::int64_t number : bodies_.bodies[body].elements) {
      const mesh::CellType type = element_cell(deck_, number);
      const auto nodes = element_nodes(deck_, number);
      mesh::CellBlock& block = blocks[type];
      block.type = type;
      for (const int place : gmsh_order(type)) {
        block.connectivity.push_back(deck_.node_of_number.at(nodes[static_cast<std::size_t>(place)]));
        box.extend(deck_.positions[static_cast<std::size_t>(block.connectivity.back())]);
      }
    }
    for (auto& [type, block] : blocks) mesh_.blocks.push_back(std::move(block));
    for (const mesh::SurfacePatch& patch :
         mesh::smooth_patches(mesh_, bodies_.bodies[body].name, 1, mesh::sharp_edge)) {
      std::map<std::set<std::string>, std::pair<std::vector<mesh::Face>, std::vector<ElementFace>>> parts;
      for (const mesh::Face& face : patch.faces) {
        const auto found = free_face(face);
        if (!found) continue;
        std::set<std::string> containing;
        for (const auto& [surface, faces] : surfaces_)
          if (faces.contains(*found)) containing.insert(surface);
        auto& [meshed, of_deck] = parts[containing];
        meshed.push_back(face);
        of_deck.push_back(*found);
      }
      for (auto& [containing, part] : parts)
        pieces_.push_back({body, std::move(part.second), containing,
                           mesh::surface_patch(patch.number, patch.body, std::move(part.first), deck_.positions)});
    }
  }

  void add_pairs(std::size_t a, std::size_t b) {
    const double distance = facing_reach * std::min(boxes_[a].diagonal().norm(), boxes_[b].diagonal().norm());
    std::vector<std::size_t> near;
    std::vector<mesh::SurfacePatch> patches;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const std::size_t body = pieces_[i].body;
      if (body != a && body != b) continue;
      if (pieces_[i].patch.box.exteriorDistance(boxes_[body == a ? b : a]) > distance) continue;
      near.push_back(i);
      patches.push_back(pieces_[i].patch);
    }
    for (const mesh::FacingPatches& facing : mesh::facing_patches(patches, deck_.positions, distance)) {
      Pair pair{near[facing.first], near[facing.second], facing, {}};
      const auto included = inclusion_of(pair);
      if (!included || is_excluded(pair) || is_joined(pair)) continue;
      pair.place = *included;
      pairs_.push_back(std::move(pair));
    }
  }

  /// Whether a line of two names, of which an empty one is all outer faces, holds for a pair.
  bool holds_for(const std::vector<std::string>& line, const Pair& pair) const {
    const auto is_in = [&](std::size_t i, std::size_t piece) {
      const std::string own = name(line, i);
      return own.empty() || pieces_[piece].surfaces.contains(own);
    };
    return (is_in(0, pair.first) && is_in(1, pair.second)) || (is_in(1, pair.first) && is_in(0, pair.second));
  }

  /// "S1," is the surface with itself.
  static std::vector<std::string> with_itself(std::vector<std::string> line) {
    if (!name(line, 0).empty() && name(line, 1).empty()) line = {line[0], line[0]};
    return line;
  }

  std::optional<Place> inclusion_of(const Pair& pair) const {
    for (const RawCard& raw : deck_.cards) {
      if (raw.card.name != "CONTACT INCLUSIONS") continue;
      if (raw.card.has("ALLEXTERIOR")) return raw.card.place;
      for (const std::vector<std::string>& line : raw.data)
        if (!names_two_surfaces(line) && holds_for(with_itself(line), pair)) return raw.card.place;
    }
    return std::nullopt;
  }

  bool is_excluded(const Pair& pair) const {
    return std::ranges::any_of(deck_.cards, [&](const RawCard& raw) {
      return raw.card.name == "CONTACT EXCLUSIONS" &&
             std::ranges::any_of(raw.data, [&](const std::vector<std::string>& line) {
               return !line.empty() && holds_for(with_itself(line), pair);
             });
    });
  }

  bool is_joined(const Pair& pair) const {
    const auto meets = [&](const std::vector<ElementFace>& joined, std::size_t piece) {
      return std::ranges::any_of(pieces_[piece].faces,
                                 [&](const ElementFace& face) { return std::ranges::binary_search(joined, face); });
    };
    return std::ranges::any_of(*joined_, [&](const JoinedFaces& one) {
      return (meets(one[0], pair.first) && meets(one[1], pair.second)) ||
             (meets(one[1], pair.first) && meets(one[0], pair.second));
    });
  }

  /// A piece does not touch what is beyond another body that it faces with as much of its area.
  void drop_hidden() {
    constexpr double most = 0.9;
    const std::vector<Pair> all = pairs_;
    const auto is_hidden = [&](const Pair& pair, std::size_t piece) {
      return std::ranges::any_of(all, [&](const Pair& other) {
        if (other.first != piece && other.second != piece) return false;
        return other.facing.mean < pair.facing.mean && other.facing.largest <= pair.facing.least &&
               other.facing.area >= most * pair.facing.area;
      });
    };
    std::erase_if(pairs_, [&](const Pair& pair) {
      return pair.facing.least > 0 && (is_hidden(pair, pair.first) || is_hidden(pair, pair.second));
    });
  }

  /// The last assignment counts.
  std::string interaction_of(const Pair& pair) const {
    std::string found;
    for (const RawCard& raw : deck_.cards)
      if (raw.card.name == "CONTACT PROPERTY ASSIGNMENT")
        for (const std::vector<std::string>& line : raw.data)
          if (holds_for(line, pair)) found = line.size() > 2 ? line[2] : "";
    return found;
  }

  /// The smaller piece is the slave, or the one with more faces.
  FacingSurfaces surfaces_of(const Pair& pair) const {
    const Piece *slave = &pieces_[pair.first], *master = &pieces_[pair.second];
    const double excess = slave->patch.area / master->patch.area - 1;
    if (excess > same_area || (excess > -same_area && slave->faces.size() < master->faces.size()))
      std::swap(slave, master);
    FacingSurfaces made;
    made.faces = {slave->faces, master->faces};
    for (std::vector<ElementFace>& faces : made.faces) std::ranges::sort(faces);
    made.bodies = {bodies_.bodies[slave->body].name, bodies_.bodies[master->body].name};
    constexpr double rounding = 1e-6;  // of the size of the slave, for decks of few digits
    const double least = rounding * slave->patch.box.diagonal().norm();
    made.least = std::abs(pair.facing.least) < least ? 0 : pair.facing.least;
    made.largest = std::abs(pair.facing.largest) < least ? 0 : pair.facing.largest;
    made.is_even = pair.facing.is_exact && made.largest - made.least < least;
    if (made.is_even) made.largest = made.least;
    made.interaction = interaction_of(pair);
    made.place = pair.place;
    return made;
  }

  const Deck& deck_;
  const Bodies& bodies_;
  std::vector<Note>& impossible_;
  std::map<std::string, std::set<ElementFace>> surfaces_;  // by name in upper case
  std::set<ElementFace> tied_;
  const std::vector<JoinedFaces>* joined_ = nullptr;
  std::map<Numbers, ElementFace> outer_;  // by corners; element 0: between two elements
  mesh::Mesh mesh_;                       // with the cells of the body at hand
  std::vector<Piece> pieces_;
  std::vector<Eigen::AlignedBox3d> boxes_;  // of bodies
  std::vector<Pair> pairs_;
};

}  // namespace

bool names_two_surfaces(const std::vector<std::string>& line) {
  return line.size() > 1 && !line[0].empty() && !line[1].empty() && upper_case(line[0]) != upper_case(line[1]);
}

std::vector<FacingSurfaces> find_general_contacts(const Deck& deck, const Bodies& bodies, settings::Analysis analysis,
                                                  const std::vector<ElementFace>& tied,
                                                  const std::vector<JoinedFaces>& joined,
                                                  std::vector<Note>& impossible) {
  return GeneralContact(deck, bodies, analysis, impossible).find(tied, joined);
}

}  // namespace creepcontact::deck
