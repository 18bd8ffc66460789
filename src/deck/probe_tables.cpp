/// [[probes]] of *NODE PRINT and *EL PRINT

#include <algorithm>

#include "draft.hpp"
#include "element_faces.hpp"

namespace creepcontact::deck {
namespace {

constexpr std::size_t most = 20;

bool asks_for(const RawCard& raw, const std::string& what) {
  return std::ranges::any_of(raw.data, [&](const std::vector<std::string>& line) {
    return std::ranges::any_of(line, [&](const std::string& field) { return upper_case(field) == what; });
  });
}

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

void make_displacements(Draft& draft) {
  std::set<std::int64_t> nodes;
  for (const RawCard* raw : draft.cards("NODE PRINT"))
    if (asks_for(*raw, "U"))
      for (const std::int64_t node : draft.resolver.nodes(raw->card.value("NSET")))
        if (draft.is_used(node)) nodes.insert(node);
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

void make_stresses(Draft& draft) {
  struct Kind {
    const char *letter, *quantity;
    bool is_tensor;
  };
  constexpr std::array kinds{Kind{"S", "stress", true}, Kind{"E", "strain", true},
                             Kind{"PEEQ", "creep_strain_equivalent", false},
                             Kind{"CEEQ", "creep_strain_equivalent", false}};
  std::set<std::string> names;
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
      const config::Probe where = at_point(centre, owner->name);
      std::vector<std::string> components{"_xx", "_yy", "_zz", "_xy"};
      if (!draft.is_section()) components.insert(components.end(), {"_yz", "_zx"});
      if (!kind.is_tensor) components = {""};
      for (const std::string& component : components) {
        const std::string name = fmt::format("{}{}_element_{}", kind.quantity, component, element);
        if (names.insert(name).second) add_probe(draft, name, kind.quantity + component, where);
      }
    }
    note_rest(draft, first, elements.size(), "elements");
  }
}

}  // namespace

void make_probes(Draft& draft) {
  make_displacements(draft);
  make_reactions(draft);
  make_stresses(draft);
  if (draft.config.probes.empty())
    draft.left_out.push_back({draft.deck.steps.back().place, "STEP",
                              "no *NODE PRINT of U or RF and no *EL PRINT of S, E or PEEQ: there are no probes; add "
                              "[[probes]] for columns of history.csv"});
}

}  // namespace creepcontact::deck
