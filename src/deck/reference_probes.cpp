/// [[probes]] of reference nodes: the shortening and the force of bolts.

#include <algorithm>
#include <cmath>

#include "draft.hpp"
#include "print_cards.hpp"

namespace creepcontact::deck {
namespace {

/// The part along the normal of what the components of a quantity are on the faces of a section, as an expression of
/// probes, which are made. @param suffix  of their names
std::string along_normal(Draft& draft, const PretensionSection& section, const std::string& quantity,
                         const std::string& group, const std::string& suffix) {
  constexpr double rounding = 1e-12;
  std::string text;
  for (int k = 0; k < 3; ++k) {
    const double part = rounded(section.normal[k]);
    if (std::abs(part) < rounding) continue;
    config::Probe probe;
    probe.name = fmt::format("{}_{}_{}", quantity, "xyz"[k], suffix);
    probe.quantity = fmt::format("{}_{}", quantity, "xyz"[k]);
    probe.on.name = group;
    text += fmt::format("{}{:.15g}*{}", text.empty() || part < 0 ? "" : "+", part, probe.name);
    draft.add(draft.config.probes, std::move(probe), "probes", "");
  }
  return text;
}

void add_expression(Draft& draft, const std::string& name, const std::string& expression, const std::string& what) {
  config::Probe probe;
  probe.name = name;
  probe.expression.name = expression;
  draft.comment(draft.add(draft.config.probes, std::move(probe), "probes", "") + ".expression", what);
}

void shortening(Draft& draft, const PretensionSection& section) {
  const auto [own, other] = draft.groups_of(section);
  const std::string end = fmt::format("node_{}", section.reference);
  const std::string first = along_normal(draft, section, "displacement", own, "own_side_" + end);
  const std::string second = along_normal(draft, section, "displacement", other, "other_side_" + end);
  add_expression(draft, "u1_" + end, fmt::format("{}-({})", first, second), "shortening of the bolt");
}

void tension(Draft& draft, const PretensionSection& section) {
  const std::string end = fmt::format("node_{}", section.reference);
  add_expression(draft, "rf1_" + end, along_normal(draft, section, "contact_force", draft.groups_of(section)[0], end),
                 "force of the bolt");
}

/// @returns whether the quantity is known
bool make_probe(Draft& draft, std::int64_t node, const std::string& variable) {
  const auto section = std::ranges::find(draft.sections, node, &PretensionSection::reference);
  if (section == draft.sections.end()) return false;
  if (variable == "RF" && !draft.loading.locked.contains(node)) return false;
  if (variable == "U")
    shortening(draft, *section);
  else
    tension(draft, *section);
  return true;
}

}  // namespace

void make_reference_probes(Draft& draft) {
  std::set<std::pair<std::int64_t, std::string>> made;
  for (const RawCard* raw : draft.cards("NODE PRINT"))
    for (const std::string variable : {"U", "RF"}) {
      if (!asks_for(*raw, variable)) continue;
      const std::string& target = raw->card.value("NSET");
      const Numbers nodes = draft.resolver.nodes(target);
      if (nodes.empty())
        draft.left_out.push_back({raw->card.place, "NODE PRINT", fmt::format("there is no node set '{}'", target)});
      Numbers unknown;
      for (const std::int64_t node : nodes)
        if (!draft.is_used(node) && !made.contains({node, variable})) {
          if (make_probe(draft, node, variable))
            made.emplace(node, variable);
          else
            unknown.push_back(node);
        }
      if (unknown.empty()) continue;
      draft.left_out.push_back(
          {raw->card.place, "NODE PRINT",
           fmt::format("{} of node {}{}: no probe, for no element has it", variable, unknown.front(),
                       unknown.size() > 1 ? fmt::format(" and {} others", unknown.size() - 1) : "")});
    }
}

}  // namespace creepcontact::deck
