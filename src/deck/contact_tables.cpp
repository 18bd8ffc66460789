/// [[contacts]]: contact pairs, ties, and bolts that are locked

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "contact_adjustment.hpp"
#include "contact_changes.hpp"
#include "draft.hpp"
#include "element_faces.hpp"
#include "gasket_tables.hpp"
#include "general_contact.hpp"
#include "interactions.hpp"
#include "node_to_face_ties.hpp"

namespace creepcontact::deck {
namespace {

class ContactMaker {
 public:
  explicit ContactMaker(Draft& draft) : draft_(draft) {}

  void make() {
    interactions_ = read_interactions(draft_);
    removals_ = removals_of_pairs(draft_);
    for (const RawCard* raw : draft_.cards("CONTACT PAIR")) contact_pair(*raw);
    general_contact();
    for (const RawCard* raw : draft_.cards("TIE")) tie(*raw);
    for (const GasketLayer& layer : draft_.gaskets) gasket(layer);
    for (const PretensionSection& section : draft_.sections) bolt(section);
  }

 private:
  /// Heat does not cross a contact of which nothing is said.
  void set_conductance(const std::optional<Function>& given, config::Contact& made) const {
    using Kind = config::Conductance::Kind;
    if (!draft_.deck.conducts()) return;
    made.conductance.kind = given ? Kind::function : Kind::insulated;
    if (given) made.conductance.value = *given;
  }

  /// Returns the faces of a surface, or of a set of nodes; none if that cannot be.
  std::vector<ElementFace> faces(const RawCard& raw, const std::string& name) {
    const Deck& deck = draft_.deck;
    const std::string upper = upper_case(name);
    Surface made;
    if (const auto found = deck.surfaces.find(upper); found != deck.surfaces.end()) {
      made = found->second;
    } else if (const auto set = deck.node_sets.find(upper); set != deck.node_sets.end()) {
      made = {set->second.name, true, {{upper, 0, raw.card.place}}};
    } else {
      draft_.refuse(raw, fmt::format("there is no surface '{}'", name));
      return {};
    }
    const std::size_t n_reasons = draft_.impossible.size();
    std::vector<ElementFace> found = faces_of(deck, made, draft_.impossible);
    if (found.empty() && draft_.impossible.size() == n_reasons)
      draft_.refuse(
          raw, fmt::format("the surface '{}' has no faces: no face of an element has all its corners in it", name));
    return found;
  }

  /// Name of the group of a surface, which is made if it is new; empty if it cannot be.
  std::string surface(const RawCard& raw, const std::string& name) {
    const std::string upper = upper_case(name);
    if (const auto known = surfaces_.find(upper); known != surfaces_.end()) return known->second;
    const std::vector<ElementFace> found = faces(raw, name);
    if (found.empty()) return "";
    const auto surface = draft_.deck.surfaces.find(upper);
    return surfaces_[upper] =
               draft_.mesh.add_faces(surface != draft_.deck.surfaces.end() ? surface->second.name : name, found);
  }

  config::Contact contact(const std::string& slave, const std::string& master) {
    config::Contact made;
    made.name = fmt::format("contact_{}", draft_.config.contacts.size() + 1);
    made.between = {{{slave}, {master}}};
    made.slave = 0;
    return made;
  }

  void tied(const Place& place, const std::string& card, const std::string& slave, const std::string& master,
            std::optional<config::Preload> preload = {}) {
    config::Contact made = contact(slave, master);
    made.type = config::ContactType::tied;
    made.preload = preload;
    add(std::move(made), place, card);
  }

  std::string add(config::Contact made, const Place& place, const std::string& card) {
    return draft_.add(draft_.config.contacts, std::move(made), "contacts", fmt::format("{}: *{}", place.text(), card));
  }

  /// Whether a pair is new. One that repeats another, or turns it round, says nothing more.
  bool is_new_pair(const RawCard& raw, const std::string& slave, const std::string& master, const std::string& kind) {
    const auto known = pairs_.try_emplace(surface_pair(slave, master), kind);
    if (known.second) return true;
    if (known.first->second == kind)
      draft_.left_out.push_back(
          {raw.card.place, raw.card.name, fmt::format("the pair of '{}' and '{}' is there already", slave, master)});
    else
      draft_.refuse(raw,
                    fmt::format("the pair of '{}' and '{}' is there already, with another contact", slave, master));
    return false;
  }

  void pair(const RawCard& raw, const std::string& slave, const std::string& master, const Interaction& interaction,
            const std::string& kind) {
    if (!is_new_pair(raw, slave, master, kind)) return;
    const std::string other = surface(raw, master), own = surface(raw, slave);
    const auto removed = removals_.find(surface_pair(slave, master));
    if (interaction.tied || raw.card.has("TIED")) {
      if (removed != removals_.end()) draft_.refuse(raw, "a tied pair that *MODEL CHANGE removes or adds is not known");
      require_near(raw, slave, master);
      return tied(raw.card.place, raw.card.name, own, other);
    }
    config::Contact made = contact(own, other);
    std::string why = set_gap(raw, slave, master, made);
    if (removed != removals_.end()) why += remove_for_a_time(raw, slave, master, removed->second, made);
    if (!interaction.gasket.empty()) made.gasket = {interaction.gasket};
    if (!interaction.friction.is_zero()) made.friction = interaction.friction.function();
    set_conductance(interaction.conductance, made);
    draft_.comment(add(std::move(made), raw.card.place, raw.card.name) + ".gap", why);
  }

  /// A pair that is removed is far apart. @returns what to say of it
  std::string remove_for_a_time(const RawCard& raw, const std::string& slave, const std::string& master,
                                const Course& removed, config::Contact& made) {
    double present = made.gap(Arguments{});
    if (made.geometric_gap) {
      const std::vector<ElementFace> own = faces(raw, slave), other = faces(raw, master);
      if (own.empty() || other.empty()) return "";
      const auto even = even_distance(draft_.deck, own, other);
      if (!even)
        draft_.refuse(raw,
                      "*MODEL CHANGE removes or adds the pair, whose distance in the mesh is not the same everywhere; "
                      "give it ADJUST or *CLEARANCE");
      present = rounded(even.value_or(0));
      made.geometric_gap = false;
    }
    const double far = rounded(distance_of_removed(draft_.deck));
    Course gap;
    gap.add(0, present);
    for (const auto& [time, is_removed] : removed.points()) gap.add(time, is_removed > 0 ? far : present);
    gap.add(draft_.loading.end, gap.last());
    made.gap = gap.function();
    if (draft_.deck.conducts())
      draft_.left_out.push_back({raw.card.place, raw.card.name, "heat crosses the pair also while it is removed"});
    return fmt::format("; {:g}, the size of the model, while *MODEL CHANGE has removed the pair", far);
  }

  void contact_pair(const RawCard& raw) {
    const std::string& name = raw.card.value("INTERACTION");
    const auto found = interactions_.find(upper_case(name));
    if (found == interactions_.end()) draft_.refuse(raw, fmt::format("there is no *SURFACE INTERACTION '{}'", name));
    for (const std::vector<std::string>& line : raw.data) {
      if (line.size() < 2)
        draft_.refuse(raw, "expected the slave and the master surface");
      else if (found != interactions_.end())
        pair(raw, line[0], line[1], found->second, upper_case(name) + (raw.card.has("TIED") ? ", TIED" : ""));
    }
  }

  /// General *CONTACT: pairs of surfaces that it names, and what faces each other.
  void general_contact() {
    const auto inclusions = draft_.cards("CONTACT INCLUSIONS");
    if (inclusions.empty())
      for (const RawCard* raw : draft_.cards("CONTACT"))
        draft_.refuse(*raw,
                      "it says which surfaces may touch by *CONTACT INCLUSIONS: ALL EXTERIOR for all surfaces, or "
                      "the names of two in a line");
    for (const RawCard* raw : inclusions)
      for (const std::vector<std::string>& line : raw->data)
        if (names_two_surfaces(line)) named_pair(*raw, line[0], line[1]);
    if (!inclusions.empty()) facing_pieces(*inclusions.front());
  }

  void named_pair(const RawCard& raw, const std::string& slave, const std::string& master) {
    if (is_excluded(raw, slave, master)) {
      draft_.left_out.push_back(
          {raw.card.place, raw.card.name,
           fmt::format("the pair of '{}' and '{}', which *CONTACT EXCLUSIONS takes out", slave, master)});
      return;
    }
    const std::string property = property_of(slave, master);
    const auto found = interactions_.find(upper_case(property));
    if (!property.empty() && found == interactions_.end())
      draft_.refuse(raw, fmt::format("there is no *SURFACE INTERACTION '{}'", property));
    else
      pair(raw, slave, master, property.empty() ? Interaction{} : found->second, upper_case(property));
  }

  /// Whether *CONTACT EXCLUSIONS takes out a pair as a whole; a part of it is refused.
  bool is_excluded(const RawCard& raw, const std::string& slave, const std::string& master) {
    const std::vector<ElementFace> own = faces(raw, slave), other = faces(raw, master);
    // How many of some faces are in a surface; all of them if it has no name.
    const auto n_in = [&](const std::vector<ElementFace>& some, const RawCard& exclusions, const std::string& name) {
      if (name.empty()) return some.size();
      const std::vector<ElementFace> all = faces(exclusions, name);
      return static_cast<std::size_t>(
          std::ranges::count_if(some, [&](const ElementFace& face) { return std::ranges::binary_search(all, face); }));
    };
    for (const RawCard* exclusions : draft_.cards("CONTACT EXCLUSIONS"))
      for (const std::vector<std::string>& line : exclusions->data) {
        const std::string first = line.empty() ? "" : line[0];
        const std::string second = line.size() < 2 || line[1].empty() ? (line.size() < 2 ? first : "") : line[1];
        for (const auto& [a, b] : {std::pair(first, second), std::pair(second, first)}) {
          const std::size_t n_own = n_in(own, *exclusions, a), n_other = n_in(other, *exclusions, b);
          if (n_own == own.size() && n_other == other.size()) return true;
          if (n_own > 0 && n_other > 0)
            draft_.refuse(*exclusions, fmt::format("it takes out a part of the pair of '{}' and '{}'; name surfaces "
                                                   "that may touch as a whole",
                                                   slave, master));
        }
      }
    return false;
  }

  /// What *CONTACT INCLUSIONS does not name in pairs.
  void facing_pieces(const RawCard& first) {
    const std::vector<FacingSurfaces> found = find_general_contacts(draft_.deck, draft_.bodies, draft_.analysis,
                                                                    tied_faces(), joined_faces(), draft_.impossible);
    const bool is_asked_for = std::ranges::any_of(draft_.cards("CONTACT INCLUSIONS"), [](const RawCard* raw) {
      return raw->card.has("ALLEXTERIOR") || !std::ranges::all_of(raw->data, names_two_surfaces);
    });
    if (!is_asked_for) return;
    draft_.left_out.push_back({first.card.place, first.card.name, "contact of a body with itself"});
    if (found.empty())
      draft_.left_out.push_back({first.card.place, first.card.name,
                                 "no outer faces of two bodies face each other within a fiftieth of the size of the "
                                 "smaller body: there is no contact; *CONTACT PAIR names surfaces farther apart"});
    for (const FacingSurfaces& one : found) facing(one);
  }

  void facing(const FacingSurfaces& one) {
    const auto refuse = [&](const std::string& why) {
      draft_.impossible.push_back({one.place, "CONTACT INCLUSIONS", why});
    };
    const auto interaction = interactions_.find(upper_case(one.interaction));
    if (!one.interaction.empty() && interaction == interactions_.end())
      return refuse(fmt::format("there is no *SURFACE INTERACTION '{}'", one.interaction));
    const Interaction law = one.interaction.empty() ? Interaction{} : interaction->second;
    std::array<std::string, 2> groups;
    for (std::size_t i = 0; i < 2; ++i) {
      std::string& known = pieces_[one.faces[i]];
      if (known.empty()) known = draft_.mesh.add_faces(one.bodies[i] + "_face", one.faces[i]);
      groups[i] = known;
    }
    config::Contact made = contact(groups[0], groups[1]);
    made.name = fmt::format("{}-{}", groups[0], groups[1]);
    // Abaqus moves surfaces that overlap a little, as facets of curved ones do, until they touch.
    made.geometric_gap = !one.is_even && (one.least >= 0 || one.largest > -one.least);
    if (one.is_even) made.gap = std::max(std::stod(fmt::format("{:.9g}", one.least)), 0.0);
    if (law.tied) {
      made.type = config::ContactType::tied;
      made.geometric_gap = false;
      made.gap = 0.0;
    } else {
      if (!law.gasket.empty()) made.gasket = {law.gasket};
      if (!law.friction.is_zero()) made.friction = law.friction.function();
      set_conductance(law.conductance, made);
    }
    const std::string distance =
        one.is_even ? fmt::format("{:.4g}", one.least) : fmt::format("{:.4g} to {:.4g}", one.least, one.largest);
    draft_.found.push_back(
        {one.place, "CONTACT INCLUSIONS",
         fmt::format("contact '{}' of {} with {} faces; distance in the mesh {}{}", made.name, one.faces[0].size(),
                     one.faces[1].size(), distance,
                     one.least < 0 && !law.tied
                         ? (made.geometric_gap ? ", an interference where it is negative" : ", taken as touching")
                         : "")});
    const bool is_tied = law.tied;
    const std::string key = add(std::move(made), one.place, "CONTACT INCLUSIONS");
    if (!is_tied) draft_.comment(key + ".gap", "distance in the mesh: " + distance);
  }

  /// Faces that touch nothing else: of slave surfaces of ties, and of cuts through bolts.
  std::vector<ElementFace> tied_faces() {
    std::vector<ElementFace> all;
    const auto add = [&](const std::vector<ElementFace>& some) { all.insert(all.end(), some.begin(), some.end()); };
    for (const RawCard* raw : draft_.cards("TIE"))
      for (const std::vector<std::string>& line : raw->data)
        if (!line.empty()) add(faces(*raw, line[0]));
    for (const PretensionSection& section : draft_.sections) {
      add(section.faces);
      add(section.opposite);
    }
    return all;
  }

  std::vector<JoinedFaces> joined_faces() {
    std::vector<JoinedFaces> all;
    for (const char* card : {"CONTACT PAIR", "CONTACT INCLUSIONS"})
      for (const RawCard* raw : draft_.cards(card))
        for (const std::vector<std::string>& line : raw->data)
          if (names_two_surfaces(line)) all.push_back({faces(*raw, line[0]), faces(*raw, line[1])});
    for (const GasketLayer& layer : draft_.gaskets) {
      all.push_back({layer.faces[0], layer.faces[1]});
      for (std::vector<ElementFace>& faces : all.back()) std::ranges::sort(faces);
    }
    return all;
  }

  /// The last assignment to a pair, or to all; empty: none.
  std::string property_of(const std::string& a, const std::string& b) const {
    std::string property;
    for (const RawCard* raw : draft_.cards("CONTACT PROPERTY ASSIGNMENT"))
      for (const std::vector<std::string>& line : raw->data) {
        const auto name = [&](std::size_t i) { return i < line.size() ? upper_case(line[i]) : std::string(); };
        const auto is_one = [&](const std::string& given, const std::string& own) {
          return given.empty() || given == upper_case(own);
        };
        if ((is_one(name(0), a) && is_one(name(1), b)) || (is_one(name(0), b) && is_one(name(1), a)))
          property = line.size() > 2 ? line[2] : "";
      }
    return property;
  }

  /// @returns what the gap is made of
  std::string set_gap(const RawCard& raw, const std::string& slave, const std::string& master, config::Contact& made) {
    for (const RawCard* clearance : draft_.cards("CLEARANCE")) {
      if (upper_case(clearance->card.value("SLAVE")) != upper_case(slave) ||
          upper_case(clearance->card.value("MASTER")) != upper_case(master))
        continue;
      const auto value = number(clearance->card.value("VALUE"));
      if (!value) draft_.refuse(*clearance, "VALUE is missing: one clearance of the whole surface");
      made.gap = rounded(value.value_or(0));
      return clearance->card.place.text() + ": *CLEARANCE";
    }
    made.geometric_gap = true;
    const auto adjusted = raw.card.has("ADJUST") ? reach(raw, slave, master) : std::nullopt;
    if (!adjusted) return "that of the mesh";
    made.geometric_gap = !adjusted->all_near();
    return made.geometric_gap ? fmt::format("ADJUST has moved {} of {} nodes onto the surface", adjusted->near.size(),
                                            adjusted->n_nodes)
                              : "ADJUST: the surfaces touch";
  }

  std::optional<Reach> reach(const RawCard& raw, const std::string& slave, const std::string& master) {
    std::string problem;
    auto found = adjust_reach(draft_.deck, raw.card.value("ADJUST"), faces(raw, slave), faces(raw, master), problem);
    if (!problem.empty()) draft_.refuse(raw, problem);
    return found;
  }

  /// TIED with ADJUST holds what is within its distance.
  void require_near(const RawCard& raw, const std::string& slave, const std::string& master) {
    if (!raw.card.has("ADJUST")) return;
    if (const auto adjusted = reach(raw, slave, master); adjusted && adjusted->near.empty())
      draft_.refuse(
          raw, fmt::format("no node of '{}' is within ADJUST={} of '{}'", slave, raw.card.value("ADJUST"), master));
  }

  bool are_apart(const std::vector<ElementFace>& slave, const std::vector<ElementFace>& master,
                 double tolerance) const {
    const auto all = nearest_points(draft_.deck, slave, master);
    return std::ranges::none_of(all, [&](const auto& one) { return one.second.distance <= tolerance; });
  }

  void tie(const RawCard& raw) {
    if (raw.card.has("CYCLICSYMMETRY")) {  // a link
      if (draft_.cards("CYCLIC SYMMETRY MODEL").empty())
        draft_.refuse(raw, "CYCLIC SYMMETRY without a *CYCLIC SYMMETRY MODEL, which gives the number of sectors");
      return;
    }
    for (const std::vector<std::string>& line : raw.data) {
      if (line.size() < 2) {
        draft_.refuse(raw, "expected the slave and the master surface");
        continue;
      }
      const std::vector<ElementFace> slave = faces(raw, line[0]), master = faces(raw, line[1]);
      if (slave.empty() || master.empty()) continue;
      if (const auto tolerance = number(raw.card.value("POSITIONTOLERANCE"));
          tolerance && are_apart(slave, master, *tolerance)) {
        draft_.refuse(raw, fmt::format("no node of '{}' is within POSITION TOLERANCE={} of '{}'", line[0],
                                       raw.card.value("POSITIONTOLERANCE"), line[1]));
        continue;
      }
      if (!draft_.deck.conducts() && face_alike(draft_.deck, slave, master)) {
        auto equations = tie_nodes_to_faces(draft_.deck, slave, master, number(raw.card.value("POSITIONTOLERANCE")),
                                            draft_.is_section() ? 2 : 3, raw.card.place);
        std::ranges::move(equations, std::back_inserter(draft_.equations));
        continue;
      }
      if (!is_new_pair(raw, line[0], line[1], "TIE")) continue;
      const std::string other = surface(raw, line[1]), own = surface(raw, line[0]);
      tied(raw.card.place, raw.card.name, own, other);
    }
  }

  /// The elements of a gasket become a law of the contact of what they lie between.
  void gasket(const GasketLayer& layer) {
    const GasketSection& section = layer.section;
    const auto refuse = [&](const std::string& why) {
      draft_.impossible.push_back({section.place, "GASKET SECTION", why});
    };
    const std::string law = make_gasket(draft_, layer);
    if (law.empty()) return;
    const double thickness = draft_.deck.sections.empty() ? 1 : draft_.deck.sections.front().thickness;
    const bool is_plane = draft_.is_section() && draft_.analysis != settings::Analysis::axisymmetric;
    if (is_plane && section.width.value_or(thickness) != thickness)
      return refuse(fmt::format("the width {:.6g} out of the plane is not that of the bodies, {:.6g}",
                                section.width.value_or(thickness), thickness));
    const std::string& name = draft_.deck.element_sets.at(section.elements).name;
    std::array<std::string, 2> groups;
    for (const std::size_t side : {0, 1})
      groups[side] = draft_.mesh.add_faces(name + (side == 0 ? "_lower" : "_upper"), layer.faces[side]);
    config::Contact made = contact(groups[layer.slave], groups[1 - layer.slave]);
    made.gasket = {law};
    made.gap = rounded(section.gap);
    if (const auto found = interactions_.find(upper_case(layer.interaction)); found != interactions_.end()) {
      if (!found->second.gasket.empty() || found->second.tied)
        return refuse("the *CONTACT PAIR that holds it has a law of its own; only friction is known there");
      if (!found->second.friction.is_zero()) made.friction = found->second.friction.function();
    }
    set_conductance(std::nullopt, made);
    if (draft_.deck.conducts())
      draft_.left_out.push_back({section.place, "GASKET SECTION",
                                 "no heat crosses the gasket; give the contact a 'conductance' if it conducts"});
    if (std::ranges::any_of(layer.nodes, [&](std::int64_t node) {
          return !draft_.is_used(node) && draft_.loading.supports.contains(node);
        }))
      draft_.left_out.push_back({section.place, "GASKET SECTION",
                                 "supports of nodes of the gasket, which has none here; only its bodies can be held"});
    const bool slides = made.friction.is_zero();
    draft_.comment(add(std::move(made), section.place, "GASKET SECTION") + ".gap", "of the uncompressed gasket");
    if (layer.shears && slides)
      draft_.left_out.push_back({section.place, "GASKET SECTION",
                                 "the bodies slide along the gasket without resistance; give the contact 'friction' "
                                 "if it holds them"});
  }

  /// A bolt whose length is held from some time on keeps the force of that time: a preload.
  void bolt(const PretensionSection& section) {
    const auto locked = draft_.loading.locked.find(section.reference);
    if (locked == draft_.loading.locked.end()) return;
    const auto refuse = [&](const std::string& why) {
      draft_.impossible.push_back({section.place, "PRE-TENSION SECTION", why});
    };
    if (!(locked->second.force > 0)) return refuse("a bolt that is held before a tension is applied");
    preload(section, locked->second.force, locked->second.time);
    draft_.loading.forces.erase(section.reference);
  }

  void preload(const PretensionSection& section, double force, double time) {
    const auto& [own, other] = draft_.groups_of(section);
    tied(section.place, "PRE-TENSION SECTION", own, other, config::Preload{rounded(force), rounded(time)});
  }

  Draft& draft_;
  Interactions interactions_;
  std::map<std::string, std::string> surfaces_;             // written, by name in upper case: name of the group
  std::map<SurfacePair, std::string> pairs_;                // their contact
  std::map<std::vector<ElementFace>, std::string> pieces_;  // of general contact: names of their groups
  Removals removals_;
};

}  // namespace

void make_contacts(Draft& draft) {
  ContactMaker(draft).make();
}

}  // namespace creepcontact::deck
