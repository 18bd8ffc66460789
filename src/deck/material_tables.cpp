/// [bodies.<name>] and [materials.<name>]

#include <algorithm>
#include <array>
#include <cmath>

#include "anisotropy_tables.hpp"

namespace creepcontact::deck {
namespace {

bool has_creep_steps(const Draft& draft) {
  return std::ranges::any_of(draft.deck.steps, &Step::is_creep);
}

/// Temperatures of a table must increase. @returns whether they do
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

/// Of the *STATIC steps before the first *VISCO step, which take no time here.
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
std::string expansion_coefficient(const Draft& draft, const Material& material, std::size_t column,
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

void write_expansion(Draft& draft, const Material& material) {
  if (!material.expansion || material.expansion->rows.empty() || draft.loading.temperatures.empty()) return;
  std::string alpha;
  if (material.expands_along_axes) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      alpha += (axis == 0 ? "" : ", ") + expansion_coefficient(draft, material, axis, 3);
    alpha = "[" + alpha + "]";
  } else {
    alpha = expansion_coefficient(draft, material, 0, 1);
  }
  draft.add(fmt::format("thermal_expansion = {}\nreference_temperature = {:.15g}\n", alpha,
                        draft.loading.initial_temperature));
}

/// A column of the creep table, multiplied row by row.
std::string scaled_column(const Table& table, std::size_t column, std::size_t of_temperature,
                          const std::vector<double>& factors) {
  Table scaled = table;
  for (std::size_t i = 0; i < factors.size(); ++i) scaled.rows[i][column] *= factors[i];
  return function_of_temperature(scaled, column, of_temperature);
}

class CreepWriter {
 public:
  CreepWriter(Draft& draft, const Material& material) : draft_(draft), material_(material), table_(*material.creep) {}

  void write() {
    const std::string& law = material_.creep_law;
    const bool is_norton = law == "NORTON", is_time = law == "TIME", is_strain = law == "STRAIN";
    const bool is_sinh = law == "HYPERB" || law == "HYPERBOLIC";
    if (!is_norton && !is_time && !is_strain && !is_sinh)
      return refuse(fmt::format("LAW={} is not known; NORTON, TIME, STRAIN and HYPERB are", law));
    const std::size_t least = is_sinh ? 3 : 2;
    if (table_.rows.empty() || std::ranges::any_of(table_.rows, [&](const auto& row) { return row.size() < least; }))
      return refuse(is_sinh ? "A, B and n are missing" : "A, n and m are missing");
    draft_.varies = draft_.varies || table_.rows.size() > 1;
    draft_.add(fmt::format("\n[[materials.{}.creep]]    # {}\n", toml_key(material_.name), table_.place.text()));
    if (is_sinh) return sinh_law();
    if (std::ranges::any_of(table_.rows, [](const auto& row) { return row.size() > 4; }))
      return refuse("more values than A, n, m and the temperature");
    for (auto& row : table_.rows) row.resize(std::max<std::size_t>(row.size(), 3));
    const auto exponent = [](const std::vector<double>& row) { return row[2]; };
    if (std::ranges::all_of(table_.rows, [&](const auto& row) { return exponent(row) == 0; }))
      return draft_.add(fmt::format("law = \"norton\"\nA = {}\nn = {}\n", function_of_temperature(table_, 0, 3),
                                    function_of_temperature(table_, 1, 3)));
    if (std::ranges::any_of(table_.rows, [&](const auto& row) { return !(exponent(row) > -1); }))
      return refuse("m must be greater than -1");
    std::vector<double> inverse;
    for (const auto& row : table_.rows) inverse.push_back(1 / (1 + exponent(row)));
    if (is_strain) return strain_law(inverse);
    const double before = material_.creep_time_only ? 0 : time_before_creep(draft_);
    if (before > 0) return shifted_time_law(before);
    Table exponents = table_;
    for (auto& row : exponents.rows) row[2] += 1;
    draft_.add(
        fmt::format("law = \"time_hardening\"      # A q^n t^m as its integral: A/(m + 1) q^n t^(m + 1)\nA = {}\nn = "
                    "{}\nm = {}\n",
                    scaled_column(table_, 0, 3, inverse), function_of_temperature(table_, 1, 3),
                    function_of_temperature(exponents, 2, 3)));
  }

 private:
  void refuse(const std::string& why) { draft_.impossible.push_back({table_.place, "CREEP", why}); }

  void sinh_law() {
    const std::vector<double>& row = table_.rows.front();
    if (table_.rows.size() > 1) return refuse("LAW=HYPERB with more than one line");
    draft_.add(fmt::format("law = \"garofalo\"\nA = {:.15g}\nalpha = {:.15g}\nn = {:.15g}\n", row[0], row[1], row[2]));
    if (row.size() > 3 && row[3] != 0)
      draft_.add(fmt::format("activation_energy = {:.15g}\ngas_constant = {:.15g}\nabsolute_zero = {:.15g}\n", row[3],
                             row.size() > 4 ? row[4] : 0.0, draft_.deck.absolute_zero));
  }

  void strain_law(const std::vector<double>& inverse) {
    const double m = table_.rows.front()[2];
    if (std::ranges::any_of(table_.rows, [&](const auto& row) { return row[2] != m; }))
      return refuse("LAW=STRAIN with m that depends on the temperature");
    if (m > 0) return refuse("LAW=STRAIN with m > 0: creep that grows faster with strain");
    draft_.add(
        fmt::format("law = \"strain_hardening\"    # at constant stress A/(m + 1) q^n t^(m + 1)\nA = {}\nn = {}\nm = "
                    "{:.15g}\n",
                    scaled_column(table_, 0, 3, inverse), function_of_temperature(table_, 1, 3), m + 1));
  }

  void shifted_time_law(double before) {
    const std::vector<double>& row = table_.rows.front();
    if (table_.rows.size() > 1)
      return refuse("a law with time (m other than 0) that depends on the temperature, after *STATIC steps");
    draft_.add(
        fmt::format("law = \"expression\"          # the time of CalculiX, in which *STATIC steps last too\nrate = "
                    "\"{:.15g}*q^{:.15g}*(t + {:.15g})^{:.15g}\"\n",
                    row[0], row[1], before, row[2]));
  }

  Draft& draft_;
  const Material& material_;
  Table table_;
};

void write(Draft& draft, const Material& material) {
  draft.add(fmt::format("\n[materials.{}]            # {}\n", toml_key(material.name), material.place.text()));
  if (!material.elastic || material.elastic->rows.empty()) {
    draft.impossible.push_back({material.place, "MATERIAL", fmt::format("'{}' has no *ELASTIC", material.name)});
    return;
  }
  const bool is_isotropic = material.elasticity == Elasticity::isotropic;
  const std::size_t of_expansion = material.expands_along_axes ? 3 : 1;
  bool in_order = is_in_order(draft, "ELASTIC", *material.elastic, is_isotropic ? 2 : 9);
  if (material.expansion) in_order &= is_in_order(draft, "EXPANSION", *material.expansion, of_expansion);
  if (material.creep && material.creep_law != "HYPERB") in_order &= is_in_order(draft, "CREEP", *material.creep, 3);
  if (!in_order) return;
  if (is_isotropic)
    draft.add(fmt::format("young_modulus = {}\npoisson_ratio = {}\n", function_of_temperature(*material.elastic, 0, 2),
                          function_of_temperature(*material.elastic, 1, 2)));
  else
    write_orthotropic(draft, material);
  draft.varies = draft.varies || material.elastic->rows.size() > 1;
  const bool depends_on_temperature =
      std::ranges::any_of(std::array{&material.elastic, &material.expansion, &material.creep},
                          [](const std::optional<Table>* table) { return *table && (*table)->rows.size() > 1; });
  if (depends_on_temperature && !draft.loading.initial_temperatures.empty())
    draft.impossible.push_back(
        {material.place, "MATERIAL",
         fmt::format("'{}' depends on the temperature, and initial temperatures differ from node "
                     "to node",
                     material.name)});
  write_expansion(draft, material);
  if (material.potential) write_hill(draft, material);
  if (!material.creep) return;
  if (has_creep_steps(draft))
    CreepWriter(draft, material).write();
  else
    draft.left_out.push_back({material.creep->place, "CREEP",
                              "creep does not act in *STATIC steps, and the deck has no *VISCO step; the material is "
                              "elastic"});
}

}  // namespace

void write_bodies_and_materials(Draft& draft) {
  const auto& materials = draft.deck.materials;
  for (const DeckBody& body : draft.bodies.bodies) {
    const auto material = materials.find(body.material);
    draft.add(fmt::format("\n[bodies.{}]    # {}\nregion = {}\nmaterial = {}\n", toml_key(body.name),
                          body.section.text(), toml_string(draft.mesh.add_body(body)),
                          toml_string(material == materials.end() ? body.material : material->second.name)));
    if (!body.orientation.empty()) write_axes(draft, body);
  }
  std::set<std::string> written;
  for (const DeckBody& body : draft.bodies.bodies)
    if (written.insert(body.material).second && materials.contains(body.material))
      write(draft, materials.at(body.material));
}

}  // namespace creepcontact::deck
