/// Nodes, elements, sets, surfaces and sections.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <unordered_set>
#include <utility>

#include "deck_reader.hpp"

namespace creepcontact::deck {
namespace {

/// Returns a set, made if there is none; its name is that of the first card.
template <class T>
T& named(std::map<std::string, T>& all, const std::string& name) {
  T& found = all[upper_case(name)];
  if (found.name.empty()) found.name = name;
  return found;
}

/// "S3"
bool names_face(std::string_view field) {
  return field.size() == 2 && (field[0] == 'S' || field[0] == 's') && field[1] >= '1' && field[1] <= '6';
}

}  // namespace

void DeckReader::node(const Card& card) {
  Set* set = card.value("NSET").empty() ? nullptr : &named(into_->node_sets, card.value("NSET"));
  on_data_ = [this, set](const DataLine& line) { add_node(line, set); };
}

void DeckReader::add_node(const DataLine& line, Set* set) {
  std::optional<std::int64_t> own = label(line, line.field(0), "a node number");
  // Reference points of an assembly are numbered from 1 again, as the nodes of its instances are.
  if (own && into_ == &deck_ && !deck_.instances.empty()) {
    if (deck_.assembly_offset == 0 && !deck_.node_numbers.empty())
      deck_.assembly_offset = *std::ranges::max_element(deck_.node_numbers);
    own = *own + deck_.assembly_offset;
  }
  if (!own) return;
  if (line.fields.size() > 7)
    return mistake(line.place, fmt::format("{} fields; a node has a number and coordinates", line.fields.size()));
  Vector3 position = Vector3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::optional<double> coordinate = real(line, k + 1);
    if (!coordinate) return;
    position[static_cast<Eigen::Index>(k)] = *coordinate;
  }
  if (into_->node_of_number.insert(*own, static_cast<std::uint32_t>(into_->positions.size()))) {
    into_->node_numbers.push_back(*own);
    into_->positions.push_back(position);
  } else {
    into_->positions[into_->node_of_number.at(*own)] = position;
  }
  if (set != nullptr) set->members.push_back(*own);
}

void DeckReader::element(const Card& card) {
  const std::string name = required(card, "TYPE");
  if (name.empty()) return;
  element_set_ = card.value("ELSET").empty() ? nullptr : &named(into_->element_sets, card.value("ELSET"));
  const std::optional<ElementType> type = element_type(name);
  if (const std::string spring = upper_case(name);
      into_ == &deck_ && (spring == "SPRINGA" || spring == "SPRING1" || spring == "SPRING2")) {
    on_data_ = [this, spring](const DataLine& line) { add_spring(spring, line); };
    return;
  }
  if (into_ == &deck_ && upper_case(name) == "MASS") {
    on_data_ = [this](const DataLine& line) { add_mass(line); };
    return;
  }
  gasket_ = gasket_shape(name);
  reads_skin_ = false;
  if (gasket_) {
    on_data_ = [this](const DataLine& line) { add_to_element(line); };
    return;
  }
  if (const auto n_nodes = type ? std::nullopt : n_nodes_of_skin(name)) {
    reads_skin_ = true;
    into_->skins.push_back({upper_case(name), *n_nodes, {}, {}, card.place});
    on_data_ = [this](const DataLine& line) { add_to_element(line); };
    return;
  }
  if (!type) {
    into_->impossible.push_back(
        {card.place, card.name,
         fmt::format("elements of type {}: only solid elements and sections of solids are known", name)});
    return;
  }
  auto block = std::ranges::find_if(into_->elements, [&](const ElementBlock& one) {
    return one.type.cell == type->cell && one.type.analysis == type->analysis &&
           upper_case(one.type.name) == upper_case(name);
  });
  if (block == into_->elements.end()) block = into_->elements.insert(block, {*type, {}, {}});
  block_ = &*block;
  block_->cards.emplace_back(block_->numbers.size(), card.place);
  on_data_ = [this](const DataLine& line) { add_to_element(line); };
}

void DeckReader::add_spring(const std::string& type, const DataLine& line) {
  SpringElement made{type, 0, {}, line.place};
  const std::size_t n_nodes = type == "SPRING1" ? 1 : 2;
  for (std::size_t i = 0; i <= n_nodes; ++i) {
    const auto own = label(line, line.field(i), "the number of an element or a node");
    if (!own) return;
    if (i == 0)
      made.number = *own;
    else
      made.nodes.push_back(*own);
  }
  if (element_set_ != nullptr) element_set_->members.push_back(made.number);
  deck_.springs.push_back(std::move(made));
}

void DeckReader::add_mass(const DataLine& line) {
  const auto own = label(line, line.field(0), "the number of an element");
  const auto node = label(line, line.field(1), "the number of a node");
  if (!own || !node) return;
  if (element_set_ != nullptr) element_set_->members.push_back(*own);
  deck_.masses.push_back({*own, *node + deck_.assembly_offset, line.place});
}

std::size_t DeckReader::n_element_nodes() const {
  if (reads_skin_) return into_->skins.back().n_nodes;
  return gasket_ ? gasket_->n_nodes : static_cast<std::size_t>(mesh::n_nodes(block_->type.cell));
}

void DeckReader::add_to_element(const DataLine& line) {
  if (pending_.empty()) pending_place_ = line.place;
  const std::size_t n_nodes = n_element_nodes();
  for (const std::string_view field : line.fields) {
    const std::optional<std::int64_t> own = label(line, field, "the number of an element or a node");
    if (!own) {
      pending_.clear();
      return;
    }
    if (pending_.size() > n_nodes) break;
    pending_.push_back(*own);
  }
  if (pending_.size() < n_nodes + 1) return;
  const Numbers own = std::exchange(pending_, {});
  if (reads_skin_) {
    SkinElements& skin = into_->skins.back();
    skin.numbers.push_back(own.front());
    skin.nodes.insert(skin.nodes.end(), own.begin() + 1, own.end());
  } else if (gasket_) {
    add_gasket(*gasket_, own, line.place);
  } else {
    add_solid(own, line.place);
  }
  if (element_set_ != nullptr) element_set_->members.push_back(own.front());
}

void DeckReader::add_solid(const Numbers& own, const Place& place) {
  const Deck::ElementPlace in_block{static_cast<std::uint32_t>(block_ - into_->elements.data()),
                                    static_cast<std::uint32_t>(block_->numbers.size())};
  if (!into_->element_of_number.insert(own.front(), in_block))
    return mistake(place, fmt::format("element {} exists already", own.front()));
  block_->numbers.push_back(own.front());
  block_->nodes.insert(block_->nodes.end(), own.begin() + 1, own.end());
}

void DeckReader::add_gasket(const GasketShape& shape, const Numbers& own, const Place& place) {
  GasketElement made{own.front(), {}, shape.shears, place};
  for (std::size_t side = 0; side < 2; ++side)
    for (const int corner : shape.corners[side]) made.sides[side].push_back(own[1 + static_cast<std::size_t>(corner)]);
  into_->gaskets.push_back(std::move(made));
}

void DeckReader::node_set(const Card& card) {
  if (card.has("ELSET")) return nodes_of_elements(card);
  read_set(card, "NSET", &Deck::node_sets);
}

void DeckReader::nodes_of_elements(const Card& card) {
  const std::string name = required(card, "NSET"), elements = required(card, "ELSET");
  if (name.empty() || elements.empty()) return;
  const auto found = into_->element_sets.find(upper_case(elements));
  if (found == into_->element_sets.end())
    return mistake(card.place, fmt::format("there is no element set '{}' before this line", elements));
  const std::unordered_set<std::int64_t> wanted(found->second.members.begin(), found->second.members.end());
  Set& set = named(into_->node_sets, name);
  std::unordered_set<std::int64_t> known(set.members.begin(), set.members.end());
  const auto add = [&](const Numbers& numbers, const Numbers& nodes, std::size_t n) {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (wanted.contains(numbers[i / n]) && known.insert(nodes[i]).second) set.members.push_back(nodes[i]);
  };
  for (const ElementBlock& block : into_->elements)
    add(block.numbers, block.nodes, static_cast<std::size_t>(mesh::n_nodes(block.type.cell)));
  for (const SkinElements& skin : into_->skins) add(skin.numbers, skin.nodes, skin.n_nodes);
}

void DeckReader::element_set(const Card& card) {
  read_set(card, "ELSET", &Deck::element_sets);
}

void DeckReader::read_set(const Card& card, const std::string& key, std::map<std::string, Set> Deck::*sets) {
  const std::string name = required(card, key);
  if (name.empty()) return;
  Set& set = named(into_->*sets, name);
  if (set.place.line == 0) set.place = card.place;
  const bool generate = card.has("GENERATE");
  std::string scope;
  std::int64_t offset = into_ == &deck_ && sets == &Deck::node_sets ? deck_.assembly_offset : 0;
  if (const std::string instance = upper_case(card.value("INSTANCE")); !instance.empty()) {
    const auto found = deck_.instances.find(instance);
    if (found == deck_.instances.end())
      return mistake(card.place, fmt::format("there is no instance '{}'", card.value("INSTANCE")));
    scope = instance + ".";
    offset = sets == &Deck::node_sets ? found->second.node : found->second.element;
  }
  on_data_ = [this, &set, generate, scope, sets, offset](const DataLine& line) {
    add_members(set, line, generate, scope, sets, offset);
  };
}

void DeckReader::add_members(Set& set, const DataLine& line, bool generate, const std::string& scope,
                             std::map<std::string, Set> Deck::*sets, std::int64_t offset) {
  if (generate) {
    const auto first = whole_number(line.field(0));
    const auto last = line.fields.size() > 1 ? whole_number(line.field(1)) : first;
    const auto step = line.fields.size() > 2 ? whole_number(line.field(2)) : 1;
    if (!first || !last || !step || *first < 1 || *step < 1 || *last < *first)
      return mistake(line.place, "expected the first number, the last one and the step");
    constexpr std::int64_t most = 10'000'000;
    if ((*last - *first) / *step > most) return mistake(line.place, fmt::format("more than {} members", most));
    for (std::int64_t i = *first; i <= *last; i += *step) set.members.push_back(offset + i);
    return;
  }
  for (const std::string_view field : line.fields) {
    if (field.empty()) continue;
    if (whole_number(field)) {
      if (const auto own = label(line, field, "the number of a node or an element"))
        set.members.push_back(offset + *own);
      continue;
    }
    const auto other = (into_->*sets).find(scope + upper_case(field));
    if (other == (into_->*sets).end()) {
      if (const auto own = into_->number_in_instance(std::string(field), sets == &Deck::node_sets)) {
        set.members.push_back(*own);
        continue;
      }
      if (names_face(field)) {
        mistake(line.place, "faces of elements (S1 to S6) belong below *SURFACE; is the line of a *SURFACE missing?");
        continue;
      }
      late_members_.push_back(
          {into_, sets, upper_case(set.name), scope + upper_case(field), current_.name, line.place});
      continue;
    }
    if (&other->second == &set) continue;
    std::unordered_set<std::int64_t> known(set.members.begin(), set.members.end());
    for (const std::int64_t member : other->second.members)
      if (known.insert(member).second) set.members.push_back(member);
  }
}

void DeckReader::add_late_members() {
  using Name = std::pair<bool, std::string>;  // of a set of nodes
  std::vector<LateMembers> own;
  std::set<Name> incomplete;
  std::erase_if(late_members_, [&](LateMembers& late) {
    if (late.of != into_) return false;
    incomplete.emplace(late.sets == &Deck::node_sets, late.into);
    own.push_back(std::move(late));
    return true;
  });
  for (const LateMembers& late : own) {
    std::map<std::string, Set>& sets = into_->*late.sets;
    const auto from = sets.find(late.from);
    const auto refuse = [&](const std::string& why) { mistake(late.place, why, late.card); };
    if (from == sets.end()) {
      refuse(fmt::format("there is no set '{}'", late.from));
    } else if (incomplete.contains({late.sets == &Deck::node_sets, late.from})) {
      refuse(fmt::format("the set '{}' comes later and names such sets itself; put it before this line", late.from));
    } else {
      Set& set = sets.at(late.into);
      std::unordered_set<std::int64_t> known(set.members.begin(), set.members.end());
      for (const std::int64_t member : from->second.members)
        if (known.insert(member).second) set.members.push_back(member);
    }
  }
}

void DeckReader::drop_missing_members(Deck& of) {
  std::unordered_set<std::int64_t> others;  // elements that are not those of bodies
  for (const SkinElements& skin : of.skins) others.insert(skin.numbers.begin(), skin.numbers.end());
  for (const GasketElement& gasket : of.gaskets) others.insert(gasket.number);
  for (const SpringElement& spring : of.springs) others.insert(spring.number);
  for (const MassElement& mass : of.masses) others.insert(mass.number);
  // Of elements that are not known the numbers are not known either.
  const bool knows_elements =
      std::ranges::none_of(deck_.impossible, [](const Note& note) { return note.card == "ELEMENT"; });
  const auto drop = [&](Set& set, const char* card, const char* what, const auto& exists) {
    Numbers missing;
    std::erase_if(set.members, [&](std::int64_t member) {
      if (exists(member)) return false;
      missing.push_back(member);
      return true;
    });
    if (missing.empty()) return;
    constexpr std::size_t most = 3;
    const std::span<const std::int64_t> first = std::span(missing).first(std::min(most, missing.size()));
    deck_.left_out.push_back(
        {set.place, card,
         fmt::format("'{}' names {} {} that {} not exist: {}{}", set.name, missing.size(),
                     missing.size() == 1 ? what : fmt::format("{}s", what), missing.size() == 1 ? "does" : "do",
                     fmt::join(first, ", "), missing.size() > most ? ", ..." : "")});
  };
  for (auto& [name, set] : of.node_sets)
    drop(set, "NSET", "node", [&](std::int64_t node) { return of.node_of_number.contains(node); });
  if (!knows_elements) return;
  for (auto& [name, set] : of.element_sets)
    drop(set, "ELSET", "element",
         [&](std::int64_t element) { return of.element_of_number.contains(element) || others.contains(element); });
}

void DeckReader::set_skins_apart() {
  const auto is_solid = [](const ElementBlock& block) { return block.type.analysis == settings::Analysis::solid; };
  std::unordered_set<std::int64_t> in_section;
  for (const Section& section : deck_.sections)
    if (const auto set = deck_.element_sets.find(section.elements); set != deck_.element_sets.end())
      in_section.insert(set->second.members.begin(), set->second.members.end());
  const auto has_section = [&](const Numbers& numbers) {
    return std::ranges::any_of(numbers, [&](std::int64_t element) { return in_section.contains(element); });
  };
  if (std::ranges::any_of(deck_.elements, is_solid)) {
    const std::size_t n_blocks = deck_.elements.size();
    std::erase_if(deck_.elements, [&](ElementBlock& block) {
      if (is_solid(block) || has_section(block.numbers)) return false;
      deck_.skins.push_back({upper_case(block.type.name), static_cast<std::size_t>(mesh::n_nodes(block.type.cell)),
                             std::move(block.numbers), std::move(block.nodes), block.place(0)});
      return true;
    });
    if (deck_.elements.size() != n_blocks) {
      deck_.element_of_number = {};
      for (std::uint32_t b = 0; b < deck_.elements.size(); ++b)
        for (std::uint32_t e = 0; e < deck_.elements[b].numbers.size(); ++e)
          deck_.element_of_number.insert(deck_.elements[b].numbers[e], {b, e});
    }
  }
  std::set<std::string> left_out;
  std::size_t n = 0;
  for (const SkinElements& skin : deck_.skins) {
    if (deck_.elements.empty() || deck_.sections.empty() || has_section(skin.numbers)) {
      deck_.impossible.push_back(
          {skin.place, "ELEMENT",
           fmt::format("elements of type {}: only solid elements and sections of solids are known", skin.type)});
      continue;
    }
    left_out.insert(skin.type);
    n += skin.numbers.size();
  }
  if (n > 0)
    deck_.left_out.push_back({deck_.skins.front().place, "ELEMENT",
                              fmt::format("{} elements of type {} are lines and faces without a section: they are not "
                                          "bodies, only their sets count",
                                          n, fmt::join(left_out, ", "))});
}

void DeckReader::surface(const Card& card) {
  const std::string name = required(card, "NAME");
  if (name.empty()) return;
  const std::string type = upper_case(card.value("TYPE"));
  Surface& surface = named(into_->surfaces, name);
  const bool of_nodes = type == "NODE";
  if (!surface.entries.empty() && surface.of_nodes != of_nodes) {
    deck_.left_out.push_back(
        {card.place, card.name,
         fmt::format("'{}' is the name of a surface of nodes and of one of faces: the faces are taken", name)});
    if (of_nodes) return;
    surface.entries.clear();
  }
  surface.of_nodes = of_nodes;
  on_data_ = [this, &surface](const DataLine& line) {
    SurfaceEntry entry{std::string(line.field(0)), 0, line.place};
    const std::string label = upper_case(line.field(1));
    if (label == "SPOS" || label == "SNEG") {
      entry.side = label;
    } else if (!surface.of_nodes && !label.empty()) {
      const auto face =
          label.size() > 1 && (label[0] == 'S' || label[0] == 'P') ? whole_number(label.substr(1)) : std::nullopt;
      if (!face || *face < 1 || *face > 6)
        return mistake(line.place, fmt::format("'{}' is not a face of an element: S1 to S6", line.field(1)));
      entry.face = static_cast<int>(*face);
    }
    surface.entries.push_back(std::move(entry));
  };
}

void DeckReader::solid_section(const Card& card) {
  Section section{upper_case(required(card, "ELSET")), upper_case(required(card, "MATERIAL")), 1, card.place,
                  upper_case(card.value("ORIENTATION"))};
  if (section.elements.empty() || section.material.empty()) return;
  into_->sections.push_back(std::move(section));
  on_data_ = [this](const DataLine& line) {
    if (const auto thickness = line.field(0).empty() ? std::nullopt : real(line, 0))
      into_->sections.back().thickness = *thickness;
  };
}

void DeckReader::gasket_section(const Card& card) {
  if (card.has("MATERIAL")) {
    into_->impossible.push_back(
        {card.place, card.name, "MATERIAL: gaskets of a material are not known; BEHAVIOR with *GASKET BEHAVIOR is"});
    return;
  }
  GasketSection section{
      upper_case(required(card, "ELSET")), upper_case(required(card, "BEHAVIOR")), {}, 0, 0, {}, card.place};
  if (section.elements.empty() || section.behavior.empty()) return;
  into_->gasket_sections.push_back(std::move(section));
  on_data_ = [this](const DataLine& line) {
    GasketSection& own = into_->gasket_sections.back();
    const auto given = [&](std::size_t field) { return line.field(field).empty() ? std::nullopt : real(line, field); };
    own.thickness = given(0);
    own.gap = given(1).value_or(0);
    own.space = given(2).value_or(0);
    own.width = given(3);
  };
}

}  // namespace creepcontact::deck
