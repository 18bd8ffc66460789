#pragma once
/// The model that is being made of a deck: what is known of it, and its configuration so far. Each part of the
/// configuration is made by a function of its own.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "bodies.hpp"
#include "creepcontact/config/writer.hpp"
#include "gasket_layers.hpp"
#include "linear_equations.hpp"
#include "mesh_output.hpp"
#include "node_frames.hpp"
#include "pretension.hpp"
#include "rigid_groups.hpp"
#include "values.hpp"

namespace creepcontact::deck {

struct Draft {
  /// @param deck  with its sections cut
  Draft(const Deck& deck, std::string name, std::vector<Note> impossible);

  const Deck& deck;
  std::string name;
  std::vector<Note> impossible, left_out;
  std::vector<Note> found;  ///< what the deck does not say: what was made of which card
  Resolver resolver;
  NodeFrames frames;
  MeshOutput mesh;
  Bodies bodies;
  Loading loading;
  std::vector<PretensionSection> sections;
  /// Groups of the faces of a section, of its own elements and of the others, by its reference node.
  std::map<std::int64_t, std::array<std::string, 2>> section_groups;
  std::vector<GasketLayer> gaskets;
  std::vector<RigidGroup> rigid;
  std::vector<DeckEquation> equations;
  settings::Analysis analysis = settings::Analysis::solid;
  Numbers used;              ///< nodes that elements have, ascending
  bool varies = false;       ///< a material depends on the temperature
  bool couples = false;      ///< the flow of heat depends on the contact pressure
  std::set<double> changes;  ///< times at which contacts come or go
  config::Config config;
  config::Comments comments;
  std::vector<std::pair<std::string, std::string>> tables;  ///< names and content of files next to the configuration

  /// Says what a key is made of. @param key  full
  void comment(const std::string& key, const std::string& text) { comments.beside[key] = text; }
  /// Adds an entry to a list of the configuration. @param from  what it is made of @returns its key: "loads[0]"
  template <class T>
  std::string add(std::vector<T>& list, T entry, const std::string& of_list, const std::string& from) {
    list.push_back(std::move(entry));
    std::string key = fmt::format("{}[{}]", of_list, list.size() - 1);
    if (!from.empty()) comment(key, from);
    return key;
  }
  void refuse(const RawCard& raw, const std::string& why) {
    impossible.push_back({raw.card.place, raw.card.name, why});
  }
  bool is_section() const { return analysis != settings::Analysis::solid; }
  /// Returns the groups of a section, which are made if they are new.
  const std::array<std::string, 2>& groups_of(const PretensionSection& section);
  bool is_used(std::int64_t node) const { return std::ranges::binary_search(used, node); }
  const Vector3& position(std::int64_t node) const { return deck.positions[deck.node_of_number.at(node)]; }
  /// Returns the place of the first card with a name; empty if there is none.
  Place first(const std::string& card) const;
  /// Returns the names of the bodies that have a node.
  const std::vector<std::string>& bodies_at(std::int64_t node);
  /// Returns the name of a set with these members alone, or a general one.
  std::string name_for(const Numbers& nodes, const std::string& general) const;
  /// Returns the cards with this name before and within the steps.
  std::vector<const RawCard*> cards(const std::string& card) const;

 private:
  std::unordered_map<std::int64_t, std::vector<std::string>> bodies_at_;  // made when it is first asked for
};

void make_bodies_and_materials(Draft& draft);
void make_supports(Draft& draft);
void make_loads(Draft& draft);
void make_contacts(Draft& draft);
void make_links(Draft& draft);
void make_springs(Draft& draft);
void make_temperature(Draft& draft);
void make_initial_stress(Draft& draft);
void make_time(Draft& draft);
void make_probes(Draft& draft);
/// Probes of reference nodes, which no element has; a line for those of which nothing is known.
void make_reference_probes(Draft& draft);

}  // namespace creepcontact::deck
