#include "creepcontact/deck/import.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "contact_adjustment.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/toml_string.hpp"
#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/io/msh/msh_writer.hpp"
#include "draft.hpp"
#include "heat_tables.hpp"
#include "matching_ties.hpp"
#include "note_lines.hpp"

namespace creepcontact::deck {
namespace {

void sort(std::vector<Note>& notes) {
  std::ranges::stable_sort(notes, {}, [](const Note& note) { return std::pair(note.place.file, note.place.line); });
}

void raise(Draft& draft) {
  if (draft.impossible.empty()) return;
  sort(draft.impossible);
  throw ConfigError(fmt::format("{}", fmt::join(lines_of_notes(draft.impossible), "\n")));
}

void refuse_what_changes_the_model(Draft& draft) {
  for (const Step& step : draft.deck.steps)
    for (const RawCard& raw : step.cards)
      if (raw.card.name == "EQUATION" || raw.card.name == "MPC" || raw.card.name == "TRANSFORM")
        draft.refuse(raw, "constraints that change from step to step are not known");
  refuse_steps_of_heat(draft);
  if (draft.deck.steps.empty()) draft.impossible.push_back({Place(), "STEP", "the deck has no steps"});
  std::set<settings::Analysis> analyses;
  for (const ElementBlock& block : draft.deck.elements) analyses.insert(block.type.analysis);
  if (analyses.size() > 1)
    draft.impossible.push_back(
        {Place(), "ELEMENT", "solids and sections, or sections of different kinds, in one model"});
  if (!analyses.empty()) draft.analysis = *analyses.begin();
}

/// Loads over the time of the run, and what joins nodes.
void understand(Draft& draft) {
  std::set<std::int64_t> references;
  for (const PretensionSection& section : draft.sections) references.insert(section.reference);
  draft.loading = join_steps(draft.deck, references, draft.impossible, draft.left_out);
  for (const PretensionSection& section : draft.sections)
    for (const auto& [own, opposite] : section.nodes)
      if (const auto found = draft.loading.temperatures.find(opposite); found != draft.loading.temperatures.end())
        draft.loading.temperatures[own] = found->second;
  draft.frames.turn_forces(draft.loading, draft.impossible);
  draft.rigid = find_rigid_groups(draft.deck, draft.resolver, draft.impossible);
  std::set<std::int64_t> of_rigid;
  for (const RigidGroup& group : draft.rigid)
    for (const std::int64_t node : {group.reference, group.rotation.value_or(group.reference)})
      if (!draft.is_used(node)) of_rigid.insert(node);
  draft.equations = read_equations(draft.deck, draft.resolver, draft.frames, draft.impossible);
  for (const DeckEquation& equation : draft.equations)
    for (const auto& [unknown, coefficient] : equation.terms)
      if (of_rigid.contains(unknown.first))
        draft.impossible.push_back(
            {equation.place, equation.card, "an equation with the reference node of a rigid body"});
  for (const PretensionSection& section : draft.sections)
    if (!draft.loading.locked.contains(section.reference))
      append_equations(section, draft.is_section() ? 2 : 3, draft.equations);
}

void make_head(Draft& draft) {
  config::Config& config = draft.config;
  config.file = draft.name + ".toml";
  config.title = draft.name;
  config.analysis = draft.analysis;
  if (std::ranges::any_of(draft.deck.steps, &Step::nonlinear_geometry))
    config.remarks = {"NLGEOM of the deck is left out: displacements, strains and rotations are taken as small"};
  config.mesh.file = draft.name + ".msh";
  config.mesh.allow_locking = std::ranges::any_of(
      draft.deck.elements, [](const ElementBlock& block) { return fem::reference_element(block.type.cell).locks(); });
  if (config.mesh.allow_locking)
    draft.comment("mesh.allow_locking", "of linear triangles, tetrahedra or wedges, as in the deck");
  const bool is_reduced = std::ranges::any_of(draft.deck.elements, [](const ElementBlock& block) {
    const bool is_plane =
        block.type.cell == mesh::CellType::quad8 && block.type.analysis != settings::Analysis::axisymmetric;
    return (is_plane || block.type.cell == mesh::CellType::hex20) && block.type.variant.find('R') != std::string::npos;
  });
  config.mesh.project_distorted = !is_reduced;
  if (is_reduced) draft.comment("mesh.project_distorted", "plain reduced integration, as in the deck");
  const std::vector<DeckBody>& bodies = draft.bodies.bodies;
  if (draft.bodies.share_nodes) {
    config.mesh.share_nodes = config::SharedNodes::tie;
    draft.comment("mesh.share_nodes", "bodies of different materials, axes or sources of heat that share nodes");
  }
  if (!draft.is_section() || draft.analysis == settings::Analysis::axisymmetric || bodies.empty()) return;
  const double thickness = bodies.front().thickness;
  config.mesh.thickness = rounded(thickness);
  if (std::ranges::any_of(bodies, [&](const DeckBody& body) { return body.thickness != thickness; }))
    draft.impossible.push_back({Place(), "SOLID SECTION", "sections of different thickness"});
}

/// Makes the configuration, without the mesh.
Import make(Draft& draft) {
  refuse_what_changes_the_model(draft);
  draft.bodies = find_bodies(draft.deck, draft.impossible);
  raise(draft);  // without bodies the rest has no meaning
  understand(draft);
  make_head(draft);
  make_bodies_and_materials(draft);
  make_contacts(draft);  // while the loads of bolts are known
  for (const auto& [key, windows] : draft.loading.windows)
    if (!draft.is_used(key.first))
      draft.impossible.push_back({draft.deck.steps.back().place, "BOUNDARY",
                                  fmt::format("the reference node {} is held in some steps only", key.first)});
  eliminate_reference_nodes(draft.equations, draft.used, draft.loading);
  make_links(draft);
  make_springs(draft);
  make_supports(draft);
  make_loads(draft);
  if (draft.deck.conducts())
    make_heat(draft);
  else
    make_temperature(draft);
  make_initial_stress(draft);
  make_time(draft);
  make_probes(draft);
  raise(draft);
  sort(draft.left_out);
  Import result{std::move(draft.config), std::move(draft.comments), "", std::move(draft.tables), {}, {}};
  std::string& heading = result.comments.above[""];
  heading = fmt::format("Made of {} by creepcontact import. The units are those of the deck.",
                        toml_string(draft.name + ".inp"));
  for (const Note& note : draft.found)
    result.found.push_back(fmt::format("{}*{}: {}", prefix(note.place), note.card, note.consequence));
  for (const Note& note : draft.left_out) {
    result.left_out.push_back(fmt::format("{}*{}: {}", prefix(note.place), note.card, note.consequence));
    heading += "\nLeft out: " + result.left_out.back();
  }
  return result;
}

}  // namespace

Import import_deck(Deck deck, const std::string& name) {
  if (deck.is_only_mesh())
    throw ConfigError(fmt::format(
        "'{}.inp': this deck is only a mesh, without materials, sections and steps: name it in mesh.file of a "
        "configuration, which says the rest (creepcontact new makes one)",
        name));
  std::vector<Note> impossible;
  leave_out_mechanics(deck);
  std::vector<GasketLayer> gaskets = take_gaskets(deck, impossible);
  merge_equal_temperatures(deck);
  merge_matching_ties(deck);
  adjust_contacts(deck);
  std::vector<PretensionSection> sections = cut_sections(deck, impossible);
  Import result;
  io::MshContent mesh;
  {
    Draft draft(deck, name, std::move(impossible));
    draft.sections = std::move(sections);
    draft.gaskets = std::move(gaskets);
    result = make(draft);
    mesh = draft.mesh.take();
  }
  deck = {};  // large decks: before their text is made
  result.msh = io::write_msh(mesh);
  return result;
}

}  // namespace creepcontact::deck
