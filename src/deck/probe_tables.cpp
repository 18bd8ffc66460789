/// [[probes]] of *NODE PRINT and *EL PRINT

#include <algorithm>

#include "draft.hpp"
#include "element_faces.hpp"
#include "plasticity_tables.hpp"
#include "print_cards.hpp"

namespace creepcontact::deck {
namespace {

constexpr std::size_t most = 20;

/// Adds a probe. @param where  with its place
std::string add_probe(Draft& draft, const std::string& name, const std::string& quantity, config::Probe where) {
  where.name = name;
  where.quantity = quantity;
  return draft.add(draft.config.probes, std::move(where), "probes", "");
}

/// @param first  number of the probes before
void note_rest(Draft& draft, std::size_t first, std::size_t n, const char* what) {
  if (n > most && first < draft.config.probes.size())
    draft.comments.above[fmt::format("probes[{}]", first)] =
        fmt::format("Probes of the first {} of {} {}; all values are in the field files.", most, n, what);
}

config::Probe at_point(const Vector3& position, const std::string& body) {
  config::Probe probe;
  probe.at = rounded(position);
  probe.body.name = body;
  return probe;
}

/// Nodes for which a variable is printed.
std::set<std::int64_t> printed_nodes(const Draft& draft, const std::string& variable) {
  std::set<std::int64_t> nodes;
  for (const RawCard* raw : draft.cards("NODE PRINT"))
    if (asks_for(*raw, variable))
      for (const std::int64_t node : draft.resolver.nodes(raw->card.value("NSET")))
        if (draft.is_used(node)) nodes.insert(node);
  return nodes;
}

void make_temperatures(Draft& draft) {
  const std::set<std::int64_t> nodes = printed_nodes(draft, "NT");
  const std::size_t first = draft.config.probes.size();
  std::size_t written = 0;
  for (const std::int64_t node : nodes) {
    if (++written > most) break;
    add_probe(draft, fmt::format("nt_node_{}", node), "temperature",
              at_point(draft.position(node), draft.bodies_at(node).front()));
  }
  note_rest(draft, first, nodes.size(), "nodes");
}

void make_displacements(Draft& draft) {
  const std::set<std::int64_t> nodes = printed_nodes(draft, "U");
  const std::size_t first = draft.config.probes.size();
  std::size_t written = 0;
  for (const std::int64_t node : nodes) {
    if (++written > most) break;
    const config::Probe where = at_point(draft.position(node), draft.bodies_at(node).front());
    for (int k = 0; k < (draft.is_section() ? 2 : 3); ++k)
      add_probe(draft, fmt::format("u{}_node_{}", "xyz"[k], node), fmt::format("displacement_{}", "xyz"[k]), where);
  }
  note_rest(draft, first, nodes.size(), "nodes");
}

/// The sum over the set.
void make_reactions(Draft& draft) {
  std::set<std::string> written;
  for (const RawCard* raw : draft.cards("NODE PRINT")) {
    if (!asks_for(*raw, "RF") || !written.insert(upper_case(raw->card.value("NSET"))).second) continue;
    Numbers nodes = draft.resolver.nodes(raw->card.value("NSET"));
    std::erase_if(nodes,
                  [&](std::int64_t node) { return !draft.is_used(node) || !draft.loading.supports.contains(node); });
    if (nodes.empty()) continue;
    const std::string& set = raw->card.value("NSET");
    config::Probe where;
    where.on.name = draft.mesh.add_nodes(draft.name_for(nodes, "supported_" + set), nodes);
    for (int k = 0; k < (draft.is_section() ? 2 : 3); ++k) {
      const std::string key =
          add_probe(draft, fmt::format("rf{}_{}", "xyz"[k], set), fmt::format("reaction_{}", "xyz"[k]), where);
      draft.comment(key + ".on", "the sum");
    }
  }
}

/// Notes what is printed and becomes no probe.
void note_other_variables(Draft& draft, const std::string& card, const std::vector<std::string>& known) {
  for (const RawCard* raw : draft.cards(card)) {
    std::vector<std::string> others;
    for (const std::vector<std::string>& line : raw->data)
      for (const std::string& field : line)
        if (!field.empty() && std::ranges::find(known, upper_case(field)) == known.end()) others.push_back(field);
    if (!others.empty())
      draft.left_out.push_back(
          {raw->card.place, card,
           fmt::format("{}: no probes; {} become some", fmt::join(others, ", "), fmt::join(known, ", "))});
  }
}

/// PEEQ of what creeps without yielding is creep strain, as in CalculiX. Returns an empty text if a body has none.
std::string quantity_at(Draft& draft, const std::string& quantity, const DeckBody& body) {
  const auto material = draft.deck.materials.find(body.material);
  if (!quantity.starts_with("plastic") || (material != draft.deck.materials.end() && yields(material->second)))
    return quantity;
  if (quantity == "plastic_strain_equivalent") return "creep_strain_equivalent";
  const std::string line = fmt::format("PE of body '{}': no probes, for its material does not yield", body.name);
  if (std::ranges::none_of(draft.left_out, [&](const Note& note) { return note.consequence == line; }))
    draft.left_out.push_back({draft.first("EL PRINT"), "EL PRINT", line});
  return "";
}

void make_stresses(Draft& draft) {
  struct Kind {
    const char *letter, *quantity;
    bool is_tensor;
  };
  constexpr std::array kinds{Kind{"S", "stress", true},
                             Kind{"E", "strain", true},
                             Kind{"PE", "plastic_strain", true},
                             Kind{"CE", "creep_strain", true},
                             Kind{"PEEQ", "plastic_strain_equivalent", false},
                             Kind{"CEEQ", "creep_strain_equivalent", false}};
  std::set<std::string> names;
  std::vector<std::string> letters;
  letters.reserve(kinds.size());
  for (const Kind& kind : kinds) letters.emplace_back(kind.letter);
  note_other_variables(draft, "EL PRINT", letters);
  for (const Kind& kind : kinds) {
    std::set<std::int64_t> elements;
    for (const RawCard* raw : draft.cards("EL PRINT"))
      if (asks_for(*raw, kind.letter))
        for (const std::int64_t element : draft.resolver.elements(raw->card.value("ELSET"))) elements.insert(element);
    const std::size_t first = draft.config.probes.size();
    std::size_t written = 0;
    for (const std::int64_t element : elements) {
      if (++written > most) break;
      const auto nodes = element_nodes(draft.deck, element);
      Vector3 centre = Vector3::Zero();
      const auto n = static_cast<std::size_t>(mesh::n_corners(element_cell(draft.deck, element)));
      for (std::size_t i = 0; i < n; ++i) centre += draft.position(nodes[i]) / static_cast<double>(n);
      const auto owner = std::ranges::find_if(draft.bodies.bodies, [&](const DeckBody& body) {
        return std::ranges::binary_search(body.elements, element);
      });
      if (owner == draft.bodies.bodies.end()) continue;
      const std::string quantity = quantity_at(draft, kind.quantity, *owner);
      if (quantity.empty()) continue;
      const config::Probe where = at_point(centre, owner->name);
      std::vector<std::string> components{"_xx", "_yy", "_zz", "_xy"};
      if (!draft.is_section()) components.insert(components.end(), {"_yz", "_zx"});
      if (!kind.is_tensor) components = {""};
      for (const std::string& component : components) {
        const std::string name = fmt::format("{}{}_element_{}", quantity, component, element);
        if (names.insert(name).second) add_probe(draft, name, quantity + component, where);
      }
    }
    note_rest(draft, first, elements.size(), "elements");
  }
}

}  // namespace

void make_probes(Draft& draft) {
  const bool conducts = draft.deck.conducts(), deforms = draft.deck.deforms();
  std::vector<std::string> of_nodes;
  if (conducts) of_nodes.emplace_back("NT");
  if (deforms) of_nodes.insert(of_nodes.end(), {"U", "RF"});
  note_other_variables(draft, "NODE PRINT", of_nodes);
  if (conducts) make_temperatures(draft);
  if (deforms) {
    make_displacements(draft);
    make_reactions(draft);
    make_reference_probes(draft);
    make_stresses(draft);
  }
  if (draft.config.probes.empty())
    draft.left_out.push_back(
        {draft.deck.steps.back().place, "STEP",
         fmt::format("no *NODE PRINT of {}{}: there are no probes; add [[probes]] for columns of history.csv",
                     fmt::join(of_nodes, " or "), deforms ? " and no *EL PRINT of S, E, PE, CE, PEEQ or CEEQ" : "")});
}

}  // namespace creepcontact::deck
