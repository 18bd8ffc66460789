/// [bodies.<name>] and [materials.<name>]

#include "material_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "anisotropy_tables.hpp"
#include "heat_tables.hpp"
#include "plasticity_tables.hpp"

namespace creepcontact::deck {
namespace {

bool has_creep_steps(const Draft& draft) {
  return std::ranges::any_of(draft.deck.steps, &Step::is_creep);
}

}  // namespace

bool is_in_order(Draft& draft, const char* card, const Table& table, std::size_t of_temperature) {
  const auto temperature = [&](const std::vector<double>& row) {
    return row.size() > of_temperature ? row[of_temperature] : 0.0;
  };
  for (std::size_t i = 1; i < table.rows.size(); ++i)
    if (!(temperature(table.rows[i]) > temperature(table.rows[i - 1]))) {
      draft.impossible.push_back({table.place, card,
                                  fmt::format("the temperatures must increase from line to line; {:g} follows {:g}",
                                              temperature(table.rows[i]), temperature(table.rows[i - 1]))});
      return false;
    }
  return true;
}

namespace {

/// Returns the time of the *STATIC steps before the first *VISCO step, which take no time here.
double time_before_creep(Draft& draft) {
  double time = 0;
  bool creeps = false;
  for (const Step& step : draft.deck.steps) {
    if (step.is_creep) creeps = true;
    if (!step.is_creep && creeps)
      draft.impossible.push_back(
          {step.place, "STEP", "a *STATIC step after a *VISCO step, with a creep law that depends on the time"});
    if (!creeps) time += step.period;
  }
  return time;
}

/// The thermal strain of CalculiX is alpha(T)(T - ZERO) - alpha(T0)(T0 - ZERO), here it is alpha(T)(T - T0).
/// @param column  of the coefficient @param of_temperature  column of the temperature
Function expansion_coefficient(const Draft& draft, const Material& material, std::size_t column,
                               std::size_t of_temperature) {
  constexpr int steps = 40;  // between two rows
  const double initial = draft.loading.initial_temperature, zero = material.expansion_zero;
  const auto& rows = material.expansion->rows;
  if (rows.size() == 1 || zero == initial) return function_of_temperature(*material.expansion, column, of_temperature);
  const auto temperature = [&](std::size_t i) {
    return rows[i].size() > of_temperature ? rows[i][of_temperature] : 0.0;
  };
  const auto strain = [&](double T) {
    std::size_t i = 1;
    while (i + 1 < rows.size() && temperature(i) < T) ++i;
    const double part = std::clamp((T - temperature(i - 1)) / (temperature(i) - temperature(i - 1)), 0.0, 1.0);
    return (rows[i - 1][column] + part * (rows[i][column] - rows[i - 1][column])) * (T - zero);
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
  return function_of_temperature(points);
}

bool expands(const Draft& draft, const Material& material) {
  return material.expansion && !material.expansion->rows.empty() &&
         (!draft.loading.temperatures.empty() || draft.deck.conducts());
}

void make_expansion(const Draft& draft, const Material& material, config::Material& made) {
  if (!expands(draft, material)) return;
  const std::size_t n = material.expands_along_axes ? 3 : 1;
  made.thermal_expansion.clear();
  for (std::size_t axis = 0; axis < n; ++axis)
    made.thermal_expansion.push_back(expansion_coefficient(draft, material, axis, n));
  made.reference_temperature = rounded(draft.loading.initial_temperature);
}

/// A column of the creep table, multiplied row by row.
Function scaled_column(const Table& table, std::size_t column, std::size_t of_temperature,
                       const std::vector<double>& factors) {
  Table scaled = table;
  for (std::size_t i = 0; i < factors.size(); ++i) scaled.rows[i][column] *= factors[i];
  return function_of_temperature(scaled, column, of_temperature);
}

class CreepMaker {
 public:
  CreepMaker(Draft& draft, const Material& material) : draft_(draft), material_(material), table_(*material.creep) {}

  /// @param key  of the law
  config::CreepMechanism make(const std::string& key) {
    set_law();
    draft_.comment(key, table_.place.text());
    if (!comment_.empty()) draft_.comment(key + ".law", comment_);
    return law_;
  }

 private:
  void set_law() {
    const std::string& law = material_.creep_law;
    const bool is_norton = law == "NORTON", is_time = law == "TIME", is_strain = law == "STRAIN";
    const bool is_sinh = law == "HYPERB" || law == "HYPERBOLIC";
    if (!is_norton && !is_time && !is_strain && !is_sinh)
      return refuse(fmt::format("LAW={} is not known; NORTON, TIME, STRAIN and HYPERB are", law));
    const std::size_t least = is_sinh ? 3 : 2;
    if (table_.rows.empty() || std::ranges::any_of(table_.rows, [&](const auto& row) { return row.size() < least; }))
      return refuse(is_sinh ? "A, B and n are missing" : "A, n and m are missing");
    draft_.varies = draft_.varies || table_.rows.size() > 1;
    if (is_sinh) return sinh_law();
    if (std::ranges::any_of(table_.rows, [](const auto& row) { return row.size() > 4; }))
      return refuse("more values than A, n, m and the temperature");
    for (auto& row : table_.rows) row.resize(std::max<std::size_t>(row.size(), 3));
    const auto exponent = [](const std::vector<double>& row) { return row[2]; };
    if (std::ranges::all_of(table_.rows, [&](const auto& row) { return exponent(row) == 0; }))
      return set("norton",
                 {{"A", function_of_temperature(table_, 0, 3)}, {"n", function_of_temperature(table_, 1, 3)}});
    if (std::ranges::any_of(table_.rows, [&](const auto& row) { return !(exponent(row) > -1); }))
      return refuse("m must be greater than -1");
    std::vector<double> inverse;
    for (const auto& row : table_.rows) inverse.push_back(1 / (1 + exponent(row)));
    if (is_strain) return strain_law(inverse);
    const double before = material_.creep_time_only ? 0 : time_before_creep(draft_);
    if (before > 0) return shifted_time_law(before);
    Table exponents = table_;
    for (auto& row : exponents.rows) row[2] += 1;
    set("time_hardening",
        {{"A", scaled_column(table_, 0, 3, inverse)},
         {"n", function_of_temperature(table_, 1, 3)},
         {"m", function_of_temperature(exponents, 2, 3)}},
        "A q^n t^m as its integral: A/(m + 1) q^n t^(m + 1)");
  }

  void set(const std::string& law, const std::vector<std::pair<std::string, Function>>& constants,
           const std::string& comment = {}) {
    law_.law = law;
    for (const auto& [key, value] : constants)
      law_.parameters.push_back({.key = key, .values = {value}, .location = {}});
    comment_ = comment;
  }

  void refuse(const std::string& why) { draft_.impossible.push_back({table_.place, "CREEP", why}); }

  void sinh_law() {
    const std::vector<double>& row = table_.rows.front();
    if (table_.rows.size() > 1) return refuse("LAW=HYPERB with more than one line");
    set("garofalo", {{"A", rounded(row[0])}, {"alpha", rounded(row[1])}, {"n", rounded(row[2])}});
    if (row.size() > 3 && row[3] != 0)
      set("garofalo", {{"activation_energy", rounded(row[3])},
                       {"gas_constant", rounded(row.size() > 4 ? row[4] : 0.0)},
                       {"absolute_zero", rounded(draft_.deck.absolute_zero)}});
  }

  void strain_law(const std::vector<double>& inverse) {
    const double m = table_.rows.front()[2];
    if (std::ranges::any_of(table_.rows, [&](const auto& row) { return row[2] != m; }))
      return refuse("LAW=STRAIN with m that depends on the temperature");
    if (m > 0) return refuse("LAW=STRAIN with m > 0: creep that grows faster with strain");
    set("strain_hardening",
        {{"A", scaled_column(table_, 0, 3, inverse)},
         {"n", function_of_temperature(table_, 1, 3)},
         {"m", rounded(m + 1)}},
        "at constant stress A/(m + 1) q^n t^(m + 1)");
  }

  void shifted_time_law(double before) {
    const std::vector<double>& row = table_.rows.front();
    if (table_.rows.size() > 1)
      return refuse("a law with time (m other than 0) that depends on the temperature, after *STATIC steps");
    const std::string rate = fmt::format("{:.15g}*q^{:.15g}*(t + {:.15g})^{:.15g}", row[0], row[1], before, row[2]);
    set("expression", {{"rate", Function::expression(rate, {"q", "t"})}},
        "the time of CalculiX, in which *STATIC steps last too");
    law_.parameters.back().variables = {"q", "t"};
  }

  Draft& draft_;
  const Material& material_;
  Table table_;
  config::CreepMechanism law_;
  std::string comment_;
};

bool depends_on_temperature_by_yielding(const config::Material& made) {
  return made.plasticity &&
         (made.plasticity->curve.size() > 1 ||
          (made.plasticity->yield_stress && made.plasticity->yield_stress->depends_on_temperature()) ||
          std::ranges::any_of(made.plasticity->kinematic, [](const config::KinematicHardening& back_stress) {
            return back_stress.C.depends_on_temperature() || back_stress.gamma.depends_on_temperature();
          }));
}

/// Initial temperatures that differ from node to node are taken off those that are given; computed ones stay.
bool follows_initial_temperatures(const Draft& draft, const Material& material, const config::Material& made) {
  if (draft.deck.conducts()) return !expands(draft, material);
  return !depends_on_temperature_by_yielding(made) &&
         std::ranges::none_of(std::array{&material.elastic, &material.expansion, &material.creep},
                              [](const std::optional<Table>* table) { return *table && (*table)->rows.size() > 1; });
}

void make_material(Draft& draft, const Material& material, config::Material& made) {
  made.name = material.name;
  draft.comment("materials." + made.name, material.place.text());
  if (draft.deck.conducts() && !make_conduction(draft, material, made)) return;
  if (!draft.deck.deforms()) return;
  if (!material.elastic || material.elastic->rows.empty()) {
    draft.impossible.push_back({material.place, "MATERIAL", fmt::format("'{}' has no *ELASTIC", material.name)});
    return;
  }
  const bool is_isotropic = material.elasticity == Elasticity::isotropic;
  const std::size_t of_expansion = material.expands_along_axes ? 3 : 1;
  bool in_order = is_in_order(draft, "ELASTIC", *material.elastic, is_isotropic ? 2 : 9);
  if (material.expansion) in_order &= is_in_order(draft, "EXPANSION", *material.expansion, of_expansion);
  if (!in_order) return;
  if (is_isotropic) {
    made.young_modulus = function_of_temperature(*material.elastic, 0, 2);
    made.poisson_ratio = function_of_temperature(*material.elastic, 1, 2);
  } else {
    make_orthotropic(draft, material, made);
  }
  make_plasticity(draft, material, made);
  draft.varies = draft.varies || material.elastic->rows.size() > 1 || depends_on_temperature_by_yielding(made);
  if (!draft.loading.initial_temperatures.empty() && !follows_initial_temperatures(draft, material, made))
    draft.impossible.push_back(
        {material.place, "MATERIAL",
         fmt::format("'{}' {}, and initial temperatures differ from node to node", material.name,
                     draft.deck.conducts() ? "expands from them" : "depends on the temperature")});
  make_expansion(draft, material, made);
  if (material.potential) make_hill(draft, material, made);
  make_creep(draft, material, yields(material) ? "material is elastic and yields" : "material is elastic", made.creep,
             "materials." + made.name);
}

}  // namespace

std::optional<Function> expansion_of(Draft& draft, const Material& material) {
  if (!expands(draft, material) || material.expands_along_axes ||
      !is_in_order(draft, "EXPANSION", *material.expansion, 1))
    return std::nullopt;
  draft.varies = draft.varies || material.expansion->rows.size() > 1;
  return expansion_coefficient(draft, material, 0, 1);
}

void make_creep(Draft& draft, const Material& material, const std::string& what_is_left,
                std::vector<config::CreepMechanism>& creep, const std::string& key) {
  if (!material.creep) return;
  if (material.creep_law != "HYPERB" && !is_in_order(draft, "CREEP", *material.creep, 3)) return;
  if (has_creep_steps(draft))
    creep.push_back(CreepMaker(draft, material).make(key + ".creep[0]"));
  else
    draft.left_out.push_back(
        {material.creep->place, "CREEP",
         fmt::format("creep does not act in *STATIC steps, and the deck has no *VISCO step; the {}", what_is_left)});
}

void make_bodies_and_materials(Draft& draft) {
  const auto& materials = draft.deck.materials;
  for (const DeckBody& body : draft.bodies.bodies) {
    const auto material = materials.find(body.material);
    config::Body& made = draft.config.bodies.emplace_back();
    made.name = body.name;
    made.region = {{draft.mesh.add_body(body)}};
    made.material.name = material == materials.end() ? body.material : material->second.name;
    draft.comment("bodies." + made.name, body.section.text());
    if (!body.orientation.empty()) make_axes(draft, body, made);
  }
  std::set<std::string> written;
  for (const DeckBody& body : draft.bodies.bodies)
    if (written.insert(body.material).second && materials.contains(body.material))
      make_material(draft, materials.at(body.material), draft.config.materials.emplace_back());
}

}  // namespace creepcontact::deck
