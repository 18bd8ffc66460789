#include "heat_tables.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "element_faces.hpp"
#include "material_tables.hpp"

namespace creepcontact::deck {
namespace {

bool is_transient(const Deck& deck) {
  return std::ranges::any_of(deck.steps, &Step::is_transient);
}

/// Degree of freedom 11, in CalculiX also 0.
bool is_of_temperature(const std::string& freedom) {
  return freedom == "11" || freedom == "0";
}

/// Groups what has the same text, in the order of the texts.
template <class Key, class Value>
class Alike {
 public:
  void add(const std::string& text, const Value& value, const Key& member) {
    auto& [first, members] = all_[text];
    if (members.empty()) first = value;
    members.push_back(member);
  }
  const std::map<std::string, std::pair<Value, std::vector<Key>>>& all() const { return all_; }

 private:
  std::map<std::string, std::pair<Value, std::vector<Key>>> all_;
};

/// A density that depends on the temperature is part of the capacity.
void make_capacity(Draft& draft, const Material& material, config::Material& made) {
  constexpr int steps = 20;  // between two rows
  const Table &heat = *material.specific_heat, &density = *material.density;
  if (!is_in_order(draft, "SPECIFIC HEAT", heat, 1) || !is_in_order(draft, "DENSITY", density, 1)) return;
  if (std::ranges::all_of(density.rows, [&](const auto& row) { return row[0] == density.rows.front()[0]; })) {
    made.heat_capacity = function_of_temperature(heat, 0, 1);
    made.density = rounded(density.rows.front()[0]);
    return;
  }
  std::set<double> rows;
  for (const Table* table : {&heat, &density})
    for (const auto& row : table->rows) rows.insert(row.size() > 1 ? row[1] : 0.0);
  const Function of_heat = function_of_temperature(heat, 0, 1), of_density = function_of_temperature(density, 0, 1);
  std::vector<std::pair<double, double>> points;
  const auto add = [&](double T) { points.emplace_back(T, of_heat({.T = T}) * of_density({.T = T})); };
  add(*rows.begin());
  for (auto row = std::next(rows.begin()); row != rows.end(); ++row)
    for (int k = 1; k <= steps; ++k) add(*std::prev(row) + (*row - *std::prev(row)) * k / steps);
  made.heat_capacity = function_of_temperature(points);
  made.density = 1;
  draft.comment("materials." + made.name + ".heat_capacity", "times the density, which depends on the temperature");
}

class HeatMaker {
 public:
  explicit HeatMaker(Draft& draft) : draft_(draft), from_(draft.loading.heat) {}

  void make() {
    draft_.comment("heat", "steps of *HEAT TRANSFER and of temperatures with displacements");
    set_start();
    if (is_transient(draft_.deck) || draft_.couples) heat_.time_unit = 1;
    if (!draft_.deck.deforms()) heat_.alone = true;
    for (const auto& [node, course] : from_.temperatures) temperatures_.add(text(course), course, node);
    for (const auto& [node, course] : from_.point_flows) point_flows_.add(text(course), course, node);
    for (const auto& [face, course] : from_.fluxes) fluxes_.add(text(course), course, face);
    make_nodes();
    make_faces();
    make_sources();
    draft_.config.heat = std::move(heat_);
  }

 private:
  static std::string text(const Course& course) { return course.function().text(); }

  void refuse(const char* card, const std::string& why) {
    draft_.impossible.push_back({draft_.first(card), card, why});
  }

  void set_start() {
    const auto& steps = draft_.deck.steps;
    if (std::ranges::find_if(steps, &Step::conducts)->is_steady) return;
    const auto& initial = draft_.loading.initial_temperatures;
    if (initial.empty()) {
      heat_.start = Function(rounded(draft_.loading.initial_temperature));
      return;
    }
    for (int axis = 0; axis < 3 && !heat_.start; ++axis) heat_.start = start_along(axis);
    if (!heat_.start)
      refuse("INITIAL CONDITIONS",
             "initial temperatures of a transient that depend on more than one of x, y and z; a steady state before it "
             "may give them");
  }

  /// The initial temperature as a function of one coordinate, linear between those of the nodes.
  std::optional<Function> start_along(int axis) const {
    constexpr std::size_t most = 200;
    constexpr double same = 1e-9;  // of the size
    std::vector<std::pair<double, double>> points;
    for (const std::int64_t node : draft_.used) {
      const auto found = draft_.loading.initial_temperatures.find(node);
      points.emplace_back(draft_.position(node)[axis],
                          found == draft_.loading.initial_temperatures.end() ? 0 : found->second);
    }
    std::ranges::sort(points);
    const double size = points.back().first - points.front().first;
    std::vector<std::pair<double, double>> kept;
    for (const auto& point : points) {
      const bool is_same_place = !kept.empty() && point.first - kept.back().first <= same * size;
      if (is_same_place && point.second != kept.back().second) return std::nullopt;
      if (!is_same_place) kept.push_back(point);
    }
    if (kept.size() > most) return std::nullopt;
    const char name = "xyz"[axis];
    std::string text = fmt::format("{:.15g}", kept.back().second);
    for (std::size_t i = kept.size(); i-- > 1;) {
      const auto [x0, T0] = kept[i - 1];
      const auto [x1, T1] = kept[i];
      text = fmt::format("({} < {:.15g} ? {:.15g} + {:.15g}*({} - {:.15g}) : {})", name, x1, T0, (T1 - T0) / (x1 - x0),
                         name, x0, text);
    }
    return Function::expression(text, {"x", "y", "z"});
  }

  void make_nodes() {
    int number = 0;
    for (const auto& [text, one] : temperatures_.all()) {
      const std::string on = group_of(one.second, fmt::format("temperature_{}", ++number));
      if (!on.empty()) heat_.temperatures.push_back({{on}, {}, one.first.function()});
    }
    number = 0;
    for (const auto& [text, one] : point_flows_.all()) {
      const std::string on = group_of(one.second, fmt::format("flow_{}", ++number));
      if (!on.empty()) heat_.point_flows.push_back({{on}, {}, one.first.function()});
    }
  }

  /// Nodes without elements do not belong to the model.
  std::string group_of(Numbers nodes, const std::string& general) {
    std::erase_if(nodes, [&](std::int64_t node) { return !draft_.is_used(node); });
    return nodes.empty() ? "" : draft_.mesh.add_nodes(draft_.name_for(nodes, general), nodes);
  }

  /// Adds a group for each pair of functions. @param add  of its name, the factor and what is beyond
  template <class Add>
  void make_exchanges(const std::map<ElementFace, Exchange>& exchanges, const std::string& name, const Add& add) {
    Alike<ElementFace, Exchange> alike;
    for (const auto& [face, exchange] : exchanges)
      alike.add(text(exchange.factor) + "\n" + text(exchange.beyond), exchange, face);
    int number = 0;
    for (const auto& [text, one] : alike.all())
      add(draft_.mesh.add_faces(fmt::format("{}_{}", name, ++number), one.second), one.first.factor.function(),
          one.first.beyond.function());
  }

  void make_faces() {
    make_exchanges(from_.films, "film", [&](const std::string& on, const Function& factor, const Function& beyond) {
      heat_.films.push_back({{on}, {}, factor, beyond});
    });
    make_exchanges(from_.radiation, "radiation",
                   [&](const std::string& on, const Function& factor, const Function& beyond) {
                     heat_.radiation.push_back({{on}, {}, factor, beyond});
                   });
    if (!heat_.radiation.empty()) {
      heat_.stefan_boltzmann = draft_.deck.stefan_boltzmann;
      heat_.absolute_zero = rounded(draft_.deck.absolute_zero);
      if (!draft_.deck.stefan_boltzmann)
        draft_.impossible.push_back(
            {place_of_radiation(), "RADIATE", "it needs *PHYSICAL CONSTANTS with STEFAN BOLTZMANN and ABSOLUTE ZERO"});
    }
    int number = 0;
    for (const auto& [text, one] : fluxes_.all())
      heat_.fluxes.push_back(
          {{draft_.mesh.add_faces(fmt::format("flux_{}", ++number), one.second)}, {}, one.first.function()});
  }

  Place place_of_radiation() const {
    return draft_.cards("RADIATE").empty() ? draft_.first("SRADIATE") : draft_.first("RADIATE");
  }

  void make_sources() {
    for (const HeatLoading::Source& source : from_.sources) {
      if (source.course.is_zero()) continue;
      for (const DeckBody& body : draft_.bodies.bodies)
        if (std::ranges::binary_search(source.elements, body.elements.front()))
          heat_.sources.push_back({{body.name}, source.course.function()});
    }
  }

  Draft& draft_;
  const HeatLoading& from_;
  config::Heat heat_;
  Alike<std::int64_t, Course> temperatures_, point_flows_;
  Alike<ElementFace, Course> fluxes_;
};

/// Whether *BOUNDARY holds displacements: 1 to 6, or a name such as ENCASTRE.
bool is_of_displacement(const std::string& freedom) {
  const auto number = whole_number(freedom);
  return !number || (*number >= 1 && *number <= 6);
}

/// Takes the supports of displacements out of *BOUNDARY. @returns whether there were some
bool keep_temperatures(RawCard& raw) {
  const std::size_t before = raw.data.size();
  RawCard kept{raw.card, {}, {}};
  for (std::size_t i = 0; i < raw.data.size(); ++i)
    if (raw.data[i].size() > 1 && !is_of_displacement(raw.data[i][1])) {
      kept.data.push_back(raw.data[i]);
      kept.places.push_back(raw.places[i]);
    }
  raw = std::move(kept);
  return raw.data.size() != before;
}

/// Whether a term of an equation is a temperature.
bool has_temperatures(const RawCard& equation) {
  return std::ranges::any_of(equation.data, [](const std::vector<std::string>& line) {
    for (std::size_t i = 1; i < line.size(); i += 3)
      if (is_of_temperature(line[i])) return true;
    return false;
  });
}

void note_materials_without_heat(Draft& draft) {
  for (const auto& [name, material] : draft.deck.materials)
    for (const auto& [table, card] :
         {std::pair(&material.conductivity, "CONDUCTIVITY"), std::pair(&material.specific_heat, "SPECIFIC HEAT")})
      if (*table)
        draft.left_out.push_back({(*table)->place, card, "it does not act, for no step computes temperatures"});
}

}  // namespace

void leave_out_mechanics(Deck& deck) {
  static const std::set<std::string> mechanical{"CLOAD",    "DLOAD",           "DSLOAD",
                                                "MPC",      "TRANSFORM",       "RIGID BODY",
                                                "FRICTION", "CHANGE FRICTION", "PRE-TENSION SECTION",
                                                "SPRING"};
  if (deck.steps.empty() || !deck.conducts() || deck.deforms()) return;
  std::set<std::string> left_out;
  const auto is_mechanical = [&](RawCard& raw) {
    const bool goes = mechanical.contains(raw.card.name) || (raw.card.name == "EQUATION" && !has_temperatures(raw)) ||
                      (raw.card.name == "BOUNDARY" && keep_temperatures(raw));
    if (goes) left_out.insert("*" + raw.card.name);
    return goes && (raw.card.name != "BOUNDARY" || raw.data.empty());
  };
  std::erase_if(deck.cards, is_mechanical);
  for (Step& step : deck.steps) {
    std::erase_if(step.cards, is_mechanical);
    step.nonlinear_geometry = false;
  }
  if (!std::exchange(deck.springs, {}).empty()) left_out.insert("*ELEMENT of springs");
  for (const auto& [name, material] : deck.materials)
    for (const auto& [table, card] :
         {std::pair(&material.elastic, "*ELASTIC"), std::pair(&material.expansion, "*EXPANSION"),
          std::pair(&material.plastic, "*PLASTIC"), std::pair(&material.creep, "*CREEP")})
      if (*table) left_out.insert(card);
  if (!left_out.empty())
    deck.left_out.push_back({deck.steps.front().place, "STEP",
                             fmt::format("no step computes displacements, so the temperature is computed alone, "
                                         "without {}",
                                         fmt::join(left_out, ", "))});
}

void refuse_steps_of_heat(Draft& draft) {
  const auto& steps = draft.deck.steps;
  if (!draft.deck.conducts()) return note_materials_without_heat(draft);
  const auto refuse = [&](const Step& step, const std::string& why) {
    draft.impossible.push_back({step.place, "STEP", why});
  };
  const bool creeps = std::ranges::any_of(steps, &Step::is_creep);
  for (const Step& step : steps) {
    if (!step.conducts && step.is_creep && is_transient(draft.deck))
      refuse(step,
             "*VISCO next to a transient of the temperature, which would go on changing; *UNCOUPLED "
             "TEMPERATURE-DISPLACEMENT computes both");
    if (step.is_transient() && !step.deforms && creeps)
      refuse(step,
             "materials would creep in this transient too; make it *UNCOUPLED TEMPERATURE-DISPLACEMENT, or "
             "leave *CREEP out");
  }
  if (!draft.deck.deforms()) return;
  const auto heat = std::ranges::find_if(steps, [](const Step& step) { return step.is_transient() && !step.deforms; });
  if (heat != steps.end())
    draft.left_out.push_back({heat->place, "HEAT TRANSFER",
                              "the run computes displacements in this step too, with the loads of the steps before; "
                              "what yields or slides there differs afterwards"});
  for (const ElementBlock& block : draft.deck.elements)
    if (upper_case(block.type.name).starts_with("DC"))
      draft.impossible.push_back({block.place(0), "ELEMENT",
                                  fmt::format("{} has no displacements, which a step computes; elements such as {} do",
                                              block.type.name, "C3D20 and CAX8")});
}

bool make_conduction(Draft& draft, const Material& material, config::Material& made) {
  const auto refuse = [&](const char* what) {
    draft.impossible.push_back({material.place, "MATERIAL", fmt::format("'{}' has no {}", material.name, what)});
    return false;
  };
  const auto is_given = [](const std::optional<Table>& table) { return table && !table->rows.empty(); };
  if (!is_given(material.conductivity)) return refuse("*CONDUCTIVITY, which steps that compute temperatures need");
  const std::size_t n = material.conducts_along_axes ? 3 : 1;
  if (!is_in_order(draft, "CONDUCTIVITY", *material.conductivity, n)) return false;
  for (std::size_t axis = 0; axis < n; ++axis)
    made.conductivity.push_back(function_of_temperature(*material.conductivity, axis, n));
  const bool has_capacity = is_given(material.specific_heat) && is_given(material.density);
  if (has_capacity) make_capacity(draft, material, made);
  return has_capacity || !is_transient(draft.deck) ||
         refuse("*SPECIFIC HEAT and *DENSITY, which transient temperatures need");
}

void make_heat(Draft& draft) {
  for (const PretensionSection& section : draft.sections)
    if (!draft.loading.locked.contains(section.reference))
      draft.impossible.push_back({section.place, "PRE-TENSION SECTION",
                                  "heat does not cross the section of a bolt whose length no step holds with FIXED"});
  HeatMaker(draft).make();
}

}  // namespace creepcontact::deck
