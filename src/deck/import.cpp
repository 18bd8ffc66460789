#include "creepcontact/deck/import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "bodies.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/settings/enum_names.hpp"
#include "loading.hpp"
#include "mesh_output.hpp"

namespace creepcontact::deck {
namespace {

std::string toml_string(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

/// Key of a table: bare where TOML allows it.
std::string key(const std::string& text) {
  const bool bare = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
  return bare ? text : toml_string(text);
}

std::string place(const Place& at) {
  return at.file.empty() ? "" : at.text() + ": ";
}

/// A function of T by its points: a number if there is one alone.
std::string function(const std::vector<std::pair<double, double>>& points) {
  std::string temperatures, values;
  for (const auto& [temperature, value] : points) {
    temperatures += fmt::format("{}{:.15g}", temperatures.empty() ? "" : ", ", temperature);
    values += fmt::format("{}{:.15g}", values.empty() ? "" : ", ", value);
  }
  if (points.size() == 1) return values;
  return fmt::format("{{ T = [{}], values = [{}] }}", temperatures, values);
}

/// A column of a table over the temperature, which is the column `of_temperature`.
std::string function(const Table& table, std::size_t column, std::size_t of_temperature) {
  const auto value = [&](const std::vector<double>& row, std::size_t i) { return i < row.size() ? row[i] : 0.0; };
  std::vector<std::pair<double, double>> points;
  points.reserve(table.rows.size());
  for (const std::vector<double>& row : table.rows) points.emplace_back(value(row, of_temperature), value(row, column));
  return function(points);
}

class Importer {
 public:
  Importer(const Deck& deck, std::string name) : deck_(deck), name_(std::move(name)), resolver_(deck), mesh_(deck) {
    impossible_ = deck.impossible;
    left_out_ = deck.left_out;
  }

  Import make() {
    if (deck_.steps.empty()) impossible_.push_back({Place(), "STEP", "the deck has no steps"});
    refuse_what_changes_the_model();
    raise();
    bodies_ = find_bodies(deck_, impossible_);
    loading_ = join_steps(deck_, impossible_, left_out_);
    head();
    for (const DeckBody& body : bodies_.bodies) write(body);
    std::set<std::string> materials;
    for (const DeckBody& body : bodies_.bodies)
      if (materials.insert(body.material).second && deck_.materials.contains(body.material))
        write(deck_.materials.at(body.material));
    write_supports();
    write_loads();
    write_contacts();
    write_temperature();
    write_time();
    write_probes();
    raise();
    Import result{text_, mesh_.msh(), temperatures_, {}};
    for (const Note& note : left_out_)
      result.left_out.push_back(fmt::format("{}*{}: {}", place(note.place), note.card, note.consequence));
    return result;
  }

 private:
  void raise() {
    if (impossible_.empty()) return;
    std::ranges::stable_sort(impossible_, {},
                             [](const Note& note) { return std::pair(note.place.file, note.place.line); });
    std::string all;
    std::set<std::string> said;
    for (const Note& note : impossible_)
      if (said.insert(note.card + note.consequence).second)
        all += fmt::format("{}{}*{}: {}", all.empty() ? "" : "\n", place(note.place), note.card, note.consequence);
    throw ConfigError(all);
  }

  void refuse(const RawCard& raw, const std::string& why) {
    impossible_.push_back({raw.card.place, raw.card.name, why});
  }

  void refuse_what_changes_the_model() {
    const std::map<std::string, std::string> refused{
        {"DSLOAD", "loads on surfaces are not known; *DLOAD on elements is"},
        {"CLEARANCE", "clearances are not known"},
        {"CYCLIC SYMMETRY MODEL", "cyclic symmetry is not known in decks"},
        {"EQUATION", "linear constraints are not known"},
        {"MPC", "constraints between nodes are not known"},
        {"TRANSFORM", "turned directions of nodes are not known"},
        {"PRE-TENSION SECTION", "pre-tension sections are not known"},
        {"RIGID BODY", "rigid bodies are not known in decks"},
        {"MODEL CHANGE", "contacts and elements that come and go are not known"},
        {"CHANGE FRICTION", "friction that changes from step to step is not known"},
        {"CHANGE SURFACE BEHAVIOR", "contact that changes from step to step is not known"}};
    const auto look = [&](const RawCard& raw) {
      if (const auto found = refused.find(raw.card.name); found != refused.end()) refuse(raw, found->second);
    };
    for (const RawCard& raw : deck_.cards) look(raw);
    for (const Step& step : deck_.steps)
      for (const RawCard& raw : step.cards) look(raw);
    std::set<settings::Analysis> analyses;
    for (const ElementBlock& block : deck_.elements) analyses.insert(block.type.analysis);
    if (analyses.size() > 1)
      impossible_.push_back({Place(), "ELEMENT", "solids and sections, or sections of different kinds, in one model"});
    if (!analyses.empty()) analysis_ = *analyses.begin();
  }

  void add(const std::string& text) { text_ += text; }

  void head() {
    add(fmt::format("# Made of {} by creepcontact import. The units are those of the deck.\n",
                    toml_string(name_ + ".inp")));
    for (const Note& note : left_out_)
      add(fmt::format("# Left out: {}*{}: {}\n", place(note.place), note.card, note.consequence));
    add(fmt::format("title = {}\n", toml_string(name_)));
    if (analysis_ != settings::Analysis::solid) add(fmt::format("analysis = \"{}\"\n", settings::name_of(analysis_)));
    add(fmt::format("\n[mesh]\nfile = {}\nallow_locking = true      # the elements are those of the deck\n",
                    toml_string(name_ + ".msh")));
    if (bodies_.share_nodes) add("share_nodes = \"tie\"       # sections of different materials that share nodes\n");
    if (analysis_ != settings::Analysis::solid && analysis_ != settings::Analysis::axisymmetric) {
      const double thickness = bodies_.bodies.empty() ? 1 : bodies_.bodies.front().thickness;
      add(fmt::format("thickness = {:.15g}\n", thickness));
      for (const DeckBody& body : bodies_.bodies)
        if (body.thickness != thickness)
          impossible_.push_back({Place(), "SOLID SECTION", "sections of different thickness"});
    }
  }

  void write(const DeckBody& body) {
    const std::string region = mesh_.add_body(body);
    const auto material = deck_.materials.find(body.material);
    add(fmt::format("\n[bodies.{}]\nregion = {}\nmaterial = {}\n", key(body.name), toml_string(region),
                    toml_string(material == deck_.materials.end() ? body.material : material->second.name)));
  }

  void write(const Material& material) {
    add(fmt::format("\n[materials.{}]            # {}\n", key(material.name), material.place.text()));
    if (!material.elastic || material.elastic->rows.empty()) {
      impossible_.push_back({material.place, "MATERIAL", fmt::format("'{}' has no *ELASTIC", material.name)});
      return;
    }
    add(fmt::format("young_modulus = {}\npoisson_ratio = {}\n", function(*material.elastic, 0, 2),
                    function(*material.elastic, 1, 2)));
    varies_ = varies_ || material.elastic->rows.size() > 1;
    write_expansion(material);
    if (!material.creep) return;
    if (material.creep_law != "NORTON") {
      impossible_.push_back(
          {material.creep->place, "CREEP", fmt::format("LAW={} is not known; NORTON is", material.creep_law)});
      return;
    }
    if (material.creep->rows.empty() || material.creep->rows.front().size() < 2) {
      impossible_.push_back({material.creep->place, "CREEP", "A, n and m are missing"});
      return;
    }
    varies_ = varies_ || material.creep->rows.size() > 1;
    const bool hardens =
        std::ranges::any_of(material.creep->rows, [](const auto& row) { return row.size() > 2 && row[2] != 0; });
    add(fmt::format("[[materials.{}.creep]]    # {}\n", key(material.name), material.creep->place.text()));
    if (!hardens) {
      add(fmt::format("law = \"norton\"\nA = {}\nn = {}\n", function(*material.creep, 0, 3),
                      function(*material.creep, 1, 3)));
      return;
    }
    if (material.creep->rows.size() > 1) {
      impossible_.push_back(
          {material.creep->place, "CREEP", "a law with time (m other than 0) that depends on the temperature"});
      return;
    }
    const std::vector<double>& row = material.creep->rows.front();
    add(
        fmt::format("law = \"expression\"          # the time of CalculiX, in which *STATIC steps last too\nrate = "
                    "\"{:.15g}*q^{:.15g}*(t + "
                    "{:.15g})^{:.15g}\"\n",
                    row[0], row[1], time_before_creep(), row[2]));
  }

  /// Of the *STATIC steps before the first *VISCO step, which take no time here.
  double time_before_creep() {
    double time = 0;
    bool creeps = false;
    for (const Step& step : deck_.steps) {
      if (step.is_creep) creeps = true;
      if (!step.is_creep && creeps)
        impossible_.push_back(
            {step.place, "STEP", "a *STATIC step after a *VISCO step, with a creep law that depends on the time"});
      if (!creeps) time += step.period;
    }
    return time;
  }

  /// The name of a set with these members alone, or a general one.
  std::string name_for(const Numbers& nodes, const std::string& general) const {
    for (const auto& [name, set] : deck_.node_sets)
      if (set.members.size() >= nodes.size() && resolver_.nodes(name) == nodes) return set.name;
    return general;
  }

  void write_supports() {
    std::map<std::string, Numbers> nodes_of;  // by what is prescribed
    for (const auto& [node, directions] : loading_.supports) {
      if (!is_used(node)) continue;
      std::string components;
      for (const auto& [direction, course] : directions)
        if (!is_section() || direction < 3)
          components += fmt::format("{}{} = {}", components.empty() ? "" : ", ", "xyz"[direction - 1], course.toml());
      if (!components.empty()) nodes_of[components].push_back(node);
    }
    int number = 0;
    for (const auto& [components, nodes] : nodes_of) {
      const std::string name = mesh_.add_nodes(name_for(nodes, fmt::format("support_{}", ++number)), nodes);
      add(fmt::format("\n[[supports]]                 # *BOUNDARY\non = {}\ndisplacement = {{ {} }}\n",
                      toml_string(name), components));
    }
  }

  bool is_section() const { return analysis_ != settings::Analysis::solid; }

  /// Nodes that elements have.
  const std::set<std::int64_t>& used() {
    if (used_.empty())
      for (const ElementBlock& block : deck_.elements) used_.insert(block.nodes.begin(), block.nodes.end());
    return used_;
  }
  bool is_used(std::int64_t node) { return used().contains(node); }

  void write_loads() {
    for (const auto& [node, directions] : loading_.forces) {
      if (!is_used(node)) {
        impossible_.push_back({Place(), "CLOAD", fmt::format("a force at node {}, which no element has", node)});
        continue;
      }
      std::array<std::string, 3> force{"0", "0", "0"};
      for (const auto& [direction, course] : directions) force[static_cast<std::size_t>(direction) - 1] = course.toml();
      const Vector3& x = deck_.positions[deck_.node_of_number.at(node)];
      add(fmt::format(
          "\n[[loads]]                    # *CLOAD, node {}\nat = [{:.15g}, {:.15g}, {:.15g}]\nforce = [{}, {}, {}]\n",
          node, x[0], x[1], x[2], force[0], force[1], force[2]));
    }
    std::map<std::string, std::vector<ElementFace>> pressures;  // by the pressure
    for (const auto& [face, course] : loading_.pressures) {
      const Deck::ElementPlace at = deck_.element_of_number.at(face.element);
      if (deck::face(deck_.elements[at.block].type.cell, face.face) == nullptr) {
        impossible_.push_back({Place(), "DLOAD", fmt::format("element {} has no face P{}", face.element, face.face)});
        return;
      }
      pressures[course.toml()].push_back(face);
    }
    int number = 0;
    for (const auto& [pressure, faces] : pressures)
      add(fmt::format("\n[[loads]]                    # *DLOAD\non = {}\npressure = {}\n",
                      toml_string(mesh_.add_faces(fmt::format("pressure_{}", ++number), faces)), pressure));
    for (const Loading::Body& load : loading_.bodies) write(load);
  }

  void write(const Loading::Body& load) {
    for (const DeckBody& body : bodies_.bodies) {
      Numbers common;
      std::ranges::set_intersection(load.elements, body.elements, std::back_inserter(common));
      if (common.empty()) continue;
      if (common.size() != body.elements.size()) {
        impossible_.push_back({Place(), "DLOAD", fmt::format("a body force on a part of body '{}' only", body.name)});
        continue;
      }
      const Material& material = deck_.materials.at(body.material);
      if (!material.density || material.density->rows.empty()) {
        impossible_.push_back({material.place, "MATERIAL", fmt::format("'{}' needs a *DENSITY", material.name)});
        continue;
      }
      const double density = material.density->rows.front().front();
      const std::vector<double>& g = load.load.geometry;
      if (load.load.kind == BodyLoad::Kind::centrifugal) {
        add(
            fmt::format("\n[[loads]]                    # *DLOAD, CENTRIF\nbody = {}\nrotation = {{ axis = [{:.15g}, "
                        "{:.15g}, {:.15g}], "
                        "origin = [{:.15g}, {:.15g}, {:.15g}], angular_velocity = {}, density = {:.15g} }}\n",
                        toml_string(body.name), g[3], g[4], g[5], g[0], g[1], g[2], load.course.toml("sqrt"), density));
        continue;
      }
      const double length = std::hypot(g[0], g[1], g[2]);
      std::array<std::string, 3> force;
      for (std::size_t k = 0; k < 3; ++k)
        force[k] = load.course.scaled(length > 0 ? density * g[k] / length : 0).toml();
      add(fmt::format("\n[[loads]]                    # *DLOAD, GRAV\nbody = {}\nbody_force = [{}, {}, {}]\n",
                      toml_string(body.name), force[0], force[1], force[2]));
    }
  }

  struct Interaction {
    std::string friction;
    bool tied = false;
  };

  std::map<std::string, Interaction> interactions() {
    std::map<std::string, Interaction> all;
    Interaction* own = nullptr;
    for (const RawCard& raw : deck_.cards) {
      if (raw.card.name == "SURFACE INTERACTION") own = &all[upper_case(raw.card.value("NAME"))];
      if (raw.card.name == "SURFACE BEHAVIOR" && own != nullptr) {
        const std::string kind = upper_case(raw.card.value("PRESSURE-OVERCLOSURE"));
        own->tied = kind == "TIED";
        if (kind != "HARD" && kind != "TIED")
          left_out_.push_back({raw.card.place, raw.card.name,
                               fmt::format("{}: contact is hard here, without penetration",
                                           kind.empty() ? "pressure over overclosure" : kind)});
      }
      if (raw.card.name == "FRICTION" && own != nullptr && !raw.data.empty() && !raw.data[0].empty()) {
        own->friction = raw.data[0][0];
        if (!number(own->friction)) refuse(raw, fmt::format("'{}' is not a number", own->friction));
      }
    }
    return all;
  }

  std::string surface(const RawCard& raw, const std::string& name) {
    const std::string upper = upper_case(name);
    if (const auto known = surfaces_.find(upper); known != surfaces_.end()) return known->second;
    const auto found = deck_.surfaces.find(upper);
    Surface made;
    if (found != deck_.surfaces.end()) {
      made = found->second;
    } else if (deck_.node_sets.contains(upper)) {
      made = {deck_.node_sets.at(upper).name, true, {{upper, 0, raw.card.place}}};
    } else {
      refuse(raw, fmt::format("there is no surface '{}'", name));
      return "";
    }
    const std::vector<ElementFace> faces = faces_of(deck_, made, impossible_);
    if (faces.empty()) {
      refuse(raw, fmt::format("the surface '{}' has no faces", name));
      return "";
    }
    return surfaces_[upper] = mesh_.add_faces(made.name, faces);
  }

  void write_contacts() {
    const std::map<std::string, Interaction> known = interactions();
    int count = 0;
    for (const RawCard& raw : deck_.cards) {
      const bool is_tie = raw.card.name == "TIE";
      if (!is_tie && raw.card.name != "CONTACT PAIR") continue;
      if (is_tie && (raw.card.has("CYCLICSYMMETRY") || raw.card.has("FLUIDPERIODIC") || raw.card.has("MULTISTAGE")))
        refuse(raw, "only ties of surfaces are known");
      Interaction interaction;
      if (!is_tie) {
        const auto found = known.find(upper_case(raw.card.value("INTERACTION")));
        if (found == known.end())
          refuse(raw, fmt::format("there is no *SURFACE INTERACTION '{}'", raw.card.value("INTERACTION")));
        else
          interaction = found->second;
      }
      for (std::size_t line = 0; line < raw.data.size(); ++line) {
        if (raw.data[line].size() < 2) {
          refuse(raw, "expected the slave and the master surface");
          continue;
        }
        const std::string slave = surface(raw, raw.data[line][0]), master = surface(raw, raw.data[line][1]);
        const bool tied = is_tie || interaction.tied;
        add(fmt::format(
            "\n[[contacts]]                 # {}: *{}\nname = \"contact_{}\"\nbetween = [{}, {}]\nslave = {}\n",
            raw.card.place.text(), raw.card.name, ++count, toml_string(slave), toml_string(master),
            toml_string(slave)));
        if (tied) {
          add("type = \"tied\"\n");
          continue;
        }
        const bool adjusted = raw.card.has("ADJUST");
        add(adjusted ? "gap = 0                      # ADJUST: the surfaces touch\n"
                     : "gap = \"geometric\"            # that of the mesh\n");
        if (!interaction.friction.empty())
          add(fmt::format("friction = {:.15g}\n", number(interaction.friction).value_or(0)));
      }
    }
  }

  const Course& temperature_of(std::int64_t node) const {
    const auto found = loading_.temperatures.find(node);
    return found == loading_.temperatures.end() ? at_rest_ : found->second;
  }

  void write_temperature() {
    if (loading_.temperatures.empty() && !varies_) return;
    at_rest_.add(0, loading_.initial_temperature);
    const std::set<std::int64_t>& nodes = used();
    std::vector<std::pair<double, double>> jumps;
    const std::string first = temperature_of(*nodes.begin()).toml();
    bool same = true;
    std::set<double> times;
    for (const std::int64_t node : nodes) {
      const Course& own = temperature_of(node);
      same = same && own.toml() == first;
      double before = -1;
      for (const auto& [time, value] : own.points()) {
        times.insert(time);
        if (time == before) jumps.emplace_back(time, value);
        before = time;
      }
    }
    add("\n[temperature]                # *INITIAL CONDITIONS, *TEMPERATURE\n");
    if (same) {
      add(fmt::format("value = {}\n", first));
      return;
    }
    if (!jumps.empty())
      impossible_.push_back(
          {Place(), "TEMPERATURE",
           fmt::format("temperatures that differ from node to node and jump at t = {:g}", jumps.front().first)});
    std::map<std::array<double, 3>, std::string> at;  // of several nodes at one place
    for (const std::int64_t node : nodes) {
      const Vector3& x = deck_.positions[deck_.node_of_number.at(node)];
      const std::string own = temperature_of(node).toml();
      if (at.try_emplace({x[0], x[1], x[2]}, own).first->second == own) continue;
      impossible_.push_back(
          {Place(), "TEMPERATURE", fmt::format("node {} has another temperature than one at the same place", node)});
      break;
    }
    add(fmt::format("file = {}\n", toml_string(name_ + "_temperature.csv")));
    temperatures_ = "t,x,y,z,T\n";
    for (const double time : times)
      for (const std::int64_t node : nodes) {
        const Vector3& x = deck_.positions[deck_.node_of_number.at(node)];
        temperatures_ += fmt::format("{:.15g},{:.15g},{:.15g},{:.15g},{:.15g}\n", time, x[0], x[1], x[2],
                                     temperature_of(node).at(time));
      }
  }

  /// The thermal strain of CalculiX is alpha(T)(T - ZERO) - alpha(T0)(T0 - ZERO), here it is alpha(T)(T - T0).
  void write_expansion(const Material& material) {
    if (!material.expansion || material.expansion->rows.empty() || loading_.temperatures.empty()) return;
    constexpr int steps = 40;  // between two rows
    const double initial = loading_.initial_temperature, zero = material.expansion_zero;
    const auto& rows = material.expansion->rows;
    std::string alpha = function(*material.expansion, 0, 1);
    if (rows.size() > 1 && zero != initial) {
      const auto temperature = [&](std::size_t i) { return rows[i].size() > 1 ? rows[i][1] : 0.0; };
      const auto strain = [&](double T) {
        std::size_t i = 1;
        while (i + 1 < rows.size() && temperature(i) < T) ++i;
        const double part = std::clamp((T - temperature(i - 1)) / (temperature(i) - temperature(i - 1)), 0.0, 1.0);
        return (rows[i - 1][0] + part * (rows[i][0] - rows[i - 1][0])) * (T - zero);
      };
      std::vector<std::pair<double, double>> points;
      for (std::size_t i = 1; i < rows.size(); ++i)
        for (int k = i == 1 ? 0 : 1; k <= steps; ++k) {
          const double T = temperature(i - 1) + (temperature(i) - temperature(i - 1)) * k / steps;
          const double small = 1e-4 * (temperature(i) - temperature(i - 1));
          const double secant = std::abs(T - initial) > small ? (strain(T) - strain(initial)) / (T - initial)
                                                              : (strain(T + small) - strain(T - small)) / (2 * small);
          points.emplace_back(T, secant);
        }
      alpha = function(points);
    }
    add(fmt::format("thermal_expansion = {}\nreference_temperature = {:.15g}\n", alpha, initial));
  }

  void write_time() {
    std::string times;
    for (const double time : loading_.step_ends)
      if (time > 0 && (times.empty() || time != last_)) {
        times += fmt::format("{}{:.15g}", times.empty() ? "" : ", ", time);
        last_ = time;
      }
    if (!(loading_.end > 0)) impossible_.push_back({Place(), "STEP", "the steps take no time"});
    add(fmt::format("\n[time]\nend = {:.15g}\noutput = [{}]             # the ends of the steps\n", loading_.end,
                    times));
    add(fmt::format("\n[output]\ndirectory = {}\n", toml_string("results/" + name_)));
  }

  void write_probes() {
    constexpr std::size_t most = 20;
    std::set<std::int64_t> nodes;
    for (const Step& step : deck_.steps)
      for (const RawCard& raw : step.cards)
        if (raw.card.name == "NODE PRINT")
          for (const std::vector<std::string>& line : raw.data)
            if (std::ranges::any_of(line, [](const std::string& what) { return upper_case(what) == "U"; }))
              for (const std::int64_t node : resolver_.nodes(raw.card.value("NSET")))
                if (is_used(node)) nodes.insert(node);
    std::size_t written = 0;
    for (const std::int64_t node : nodes) {
      if (++written > most) break;
      const Vector3& x = deck_.positions[deck_.node_of_number.at(node)];
      const std::string body = toml_string(body_at(node));
      for (int k = 0; k < (is_section() ? 2 : 3); ++k)
        add(
            fmt::format("\n[[probes]]\nname = \"u{0}_node_{1}\"\nquantity = \"displacement_{0}\"\nat = [{2:.15g}, "
                        "{3:.15g}, {4:.15g}]\nbody = {5}\n",
                        "xyz"[k], node, x[0], x[1], x[2], body));
    }
  }

  std::string body_at(std::int64_t node) const {
    for (const DeckBody& body : bodies_.bodies)
      for (const std::int64_t number : body.elements) {
        const Deck::ElementPlace at = deck_.element_of_number.at(number);
        const ElementBlock& block = deck_.elements[at.block];
        const auto n = static_cast<std::size_t>(mesh::n_nodes(block.type.cell));
        for (std::size_t i = 0; i < n; ++i)
          if (block.nodes[at.element * n + i] == node) return body.name;
      }
    return "";
  }

  const Deck& deck_;
  std::string name_, text_;
  Resolver resolver_;
  MeshOutput mesh_;
  std::vector<Note> impossible_, left_out_;
  Bodies bodies_;
  Loading loading_;
  settings::Analysis analysis_ = settings::Analysis::solid;
  std::set<std::int64_t> used_;
  std::map<std::string, std::string> surfaces_;  // written, by name in upper case: name of the group
  bool varies_ = false;                          // something depends on the temperature
  double last_ = 0;
  Course at_rest_;  // temperature of nodes that no step gives one
  std::string temperatures_;
};

}  // namespace

Import import_deck(const Deck& deck, const std::string& name) {
  return Importer(deck, name).make();
}

}  // namespace creepcontact::deck
