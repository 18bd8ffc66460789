/// [[contacts]]: contact pairs, ties, and bolts that are locked

#include <algorithm>
#include <iterator>

#include "draft.hpp"
#include "element_faces.hpp"
#include "node_to_face_ties.hpp"

namespace creepcontact::deck {
namespace {

struct Interaction {
  Course friction;
  bool tied = false;
};

class ContactWriter {
 public:
  explicit ContactWriter(Draft& draft) : draft_(draft) {}

  void write() {
    read_interactions();
    for (const RawCard* raw : draft_.cards("CONTACT PAIR")) contact_pair(*raw);
    for (const RawCard* raw : draft_.cards("TIE")) tie(*raw);
    for (const PretensionSection& section : draft_.sections) bolt(section);
  }

 private:
  void read_interactions() {
    Interaction* own = nullptr;
    const auto read = [&](const RawCard& raw, double time) {
      if (raw.card.name == "SURFACE INTERACTION") own = &interactions_[upper_case(raw.card.value("NAME"))];
      if (raw.card.name == "CHANGE FRICTION") own = &interactions_[upper_case(raw.card.value("INTERACTION"))];
      if (own == nullptr) return;
      if (raw.card.name == "SURFACE BEHAVIOR") {
        const std::string kind = upper_case(raw.card.value("PRESSURE-OVERCLOSURE"));
        own->tied = kind == "TIED";
        if (kind != "HARD" && kind != "TIED")
          draft_.left_out.push_back({raw.card.place, raw.card.name,
                                     fmt::format("{}: contact is hard here, without penetration",
                                                 kind.empty() ? "pressure over overclosure" : kind)});
      }
      if (raw.card.name != "FRICTION" || raw.data.empty() || raw.data[0].empty()) return;
      const auto coefficient = number(raw.data[0][0]);
      if (!coefficient) return draft_.refuse(raw, fmt::format("'{}' is not a number", raw.data[0][0]));
      if (time > 0) own->friction.add(time, own->friction.last());  // a jump
      own->friction.add(time, *coefficient);
    };
    for (const RawCard& raw : draft_.deck.cards) read(raw, 0);
    for (std::size_t s = 0; s < draft_.deck.steps.size(); ++s)
      for (const RawCard& raw : draft_.deck.steps[s].cards) read(raw, s == 0 ? 0 : draft_.loading.step_ends[s - 1]);
  }

  /// Of a surface, or of a set of nodes; empty if it cannot be.
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
    std::vector<ElementFace> found = faces_of(deck, made, draft_.impossible);
    if (found.empty())
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

  void head(const Place& place, const std::string& card, const std::string& slave, const std::string& master) {
    draft_.add(
        fmt::format("\n[[contacts]]                 # {}: *{}\nname = \"contact_{}\"\nbetween = [{}, {}]\nslave = {}\n",
                    place.text(), card, ++count_, toml_string(slave), toml_string(master), toml_string(slave)));
  }

  void contact_pair(const RawCard& raw) {
    Interaction interaction;
    const auto found = interactions_.find(upper_case(raw.card.value("INTERACTION")));
    if (found == interactions_.end())
      draft_.refuse(raw, fmt::format("there is no *SURFACE INTERACTION '{}'", raw.card.value("INTERACTION")));
    else
      interaction = found->second;
    for (const std::vector<std::string>& line : raw.data) {
      if (line.size() < 2) {
        draft_.refuse(raw, "expected the slave and the master surface");
        continue;
      }
      head(raw.card.place, raw.card.name, surface(raw, line[0]), surface(raw, line[1]));
      if (interaction.tied) {
        draft_.add("type = \"tied\"\n");
        continue;
      }
      draft_.add(gap(raw, line[0], line[1]));
      if (!interaction.friction.is_zero()) draft_.add(fmt::format("friction = {}\n", interaction.friction.toml()));
    }
  }

  std::string gap(const RawCard& raw, const std::string& slave, const std::string& master) {
    for (const RawCard* clearance : draft_.cards("CLEARANCE")) {
      if (upper_case(clearance->card.value("SLAVE")) != upper_case(slave) ||
          upper_case(clearance->card.value("MASTER")) != upper_case(master))
        continue;
      const auto value = number(clearance->card.value("VALUE"));
      if (!value) draft_.refuse(*clearance, "VALUE is missing: one clearance of the whole surface");
      return fmt::format("gap = {:.15g}                # {}: *CLEARANCE\n", value.value_or(0),
                         clearance->card.place.text());
    }
    return raw.card.has("ADJUST") ? "gap = 0                      # ADJUST: the surfaces touch\n"
                                  : "gap = \"geometric\"            # that of the mesh\n";
  }

  void tie(const RawCard& raw) {
    if (raw.card.has("CYCLICSYMMETRY")) {  // a link
      if (draft_.cards("CYCLIC SYMMETRY MODEL").empty())
        draft_.refuse(raw, "CYCLIC SYMMETRY without a *CYCLIC SYMMETRY MODEL, which gives the number of sectors");
      return;
    }
    if (raw.card.has("FLUIDPERIODIC") || raw.card.has("MULTISTAGE"))
      draft_.refuse(raw, "only ties of surfaces and cyclic symmetry are known");
    for (const std::vector<std::string>& line : raw.data) {
      if (line.size() < 2) {
        draft_.refuse(raw, "expected the slave and the master surface");
        continue;
      }
      const std::vector<ElementFace> slave = faces(raw, line[0]), master = faces(raw, line[1]);
      if (slave.empty() || master.empty()) continue;
      if (face_alike(draft_.deck, slave, master)) {
        auto equations = tie_nodes_to_faces(draft_.deck, slave, master, number(raw.card.value("POSITIONTOLERANCE")),
                                            draft_.is_section() ? 2 : 3, raw.card.place);
        std::ranges::move(equations, std::back_inserter(draft_.equations));
        continue;
      }
      head(raw.card.place, raw.card.name, surface(raw, line[0]), surface(raw, line[1]));
      draft_.add("type = \"tied\"\n");
    }
  }

  /// A bolt whose length is held from some time on keeps the force of that time: a preload.
  void bolt(const PretensionSection& section) {
    const auto locked = draft_.loading.locked.find(section.reference);
    if (locked == draft_.loading.locked.end()) return;
    const auto refuse = [&](const std::string& why) {
      draft_.impossible.push_back({section.place, "PRE-TENSION SECTION", why});
    };
    const auto forces = draft_.loading.forces.find(section.reference);
    const Course* force = nullptr;
    if (forces != draft_.loading.forces.end())
      if (const auto found = forces->second.find(1); found != forces->second.end()) force = &found->second;
    const double value = force != nullptr ? force->before(locked->second) : 0;
    if (locked->second == 0 && force != nullptr && force->at(0) > 0)
      write_preload(section, force->at(0), 0);
    else if (value > 0)
      write_preload(section, value, locked->second);
    else
      return refuse("a bolt that is held before a tension is applied");
    draft_.loading.forces.erase(section.reference);
  }

  void write_preload(const PretensionSection& section, double force, double time) {
    const std::string own = draft_.mesh.add_faces("bolt_section", section.faces);
    const std::string other = draft_.mesh.add_faces("bolt_section_opposite", section.opposite);
    head(section.place, "PRE-TENSION SECTION", own, other);
    draft_.add(fmt::format("type = \"tied\"\npreload = {{ force = {:.15g}, at = {:.15g} }}\n", force, time));
  }

  Draft& draft_;
  std::map<std::string, Interaction> interactions_;
  std::map<std::string, std::string> surfaces_;  // written, by name in upper case: name of the group
  int count_ = 0;
};

}  // namespace

void write_contacts(Draft& draft) {
  ContactWriter(draft).write();
}

}  // namespace creepcontact::deck
