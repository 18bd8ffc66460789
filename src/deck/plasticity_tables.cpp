#include "plasticity_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace creepcontact::deck {
namespace {

constexpr std::size_t stress_column = 0, strain_column = 1, temperature_column = 2;

/// The rows of one temperature, in their order.
std::map<double, std::vector<const std::vector<double>*>> by_temperature(const Table& table) {
  std::map<double, std::vector<const std::vector<double>*>> result;
  for (const std::vector<double>& row : table.rows)
    result[row.size() > temperature_column ? row[temperature_column] : 0.0].push_back(&row);
  return result;
}

class PlasticityMaker {
 public:
  PlasticityMaker(Draft& draft, const Material& material)
      : draft_(draft), material_(material), table_(*material.plastic) {}

  void make(config::Material& made) {
    if (table_.rows.empty()) return refuse("it has no data");
    if (!yields(material_)) {
      if (!material_.creep)
        return refuse("the yield stress is zero, and the material has no *CREEP: it would flow under any load");
      draft_.left_out.push_back({table_.place, "PLASTIC",
                                 "a yield stress of zero, as in CalculiX: without an elastic range all inelastic "
                                 "strain is creep, by *CREEP"});
      draft_.comment("materials." + made.name, "yield stress zero: all inelastic strain is creep");
      return;
    }
    if (std::ranges::any_of(table_.rows, [](const auto& row) { return !(row[stress_column] > 0); }))
      return refuse(
          "a curve that begins at a yield stress of zero flows at any stress; begin it where the first plastic strain "
          "is seen, or write zero throughout, next to *CREEP, for creep alone");
    if (material_.elasticity != Elasticity::isotropic) return refuse("with elasticity along axes");
    if (material_.potential) return refuse("next to *POTENTIAL: yielding by Hill's stress is not known, only creep is");
    if (material_.creep && std::ranges::any_of(draft_.deck.steps, &Step::is_creep))
      draft_.left_out.push_back(
          {table_.place, "PLASTIC",
           "next to *CREEP as in Abaqus: creep goes on at any stress, and plastic strain above the yield stress adds "
           "to it; CalculiX takes both for one law, A (q - yield stress)^n above the yield stress and nothing below "
           "it"});
    config::Plasticity plasticity;
    if (material_.hardening == "ISOTROPIC")
      isotropic(plasticity);
    else if (material_.by_table)
      linear_kinematic(plasticity);
    else
      combined(plasticity);
    if (material_.hardening == "COMBINED") add_cyclic_hardening(plasticity);
    made.plasticity = std::move(plasticity);
    draft_.comment(fmt::format("materials.{}.plasticity", made.name), table_.place.text());
  }

 private:
  void refuse(const std::string& why) { draft_.impossible.push_back({table_.place, "PLASTIC", why}); }

  /// The rows of one temperature.
  void check_curve(const std::vector<const std::vector<double>*>& rows) {
    if ((*rows.front())[strain_column] != 0) refuse("the first plastic strain must be 0");
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (!((*rows[i])[strain_column] > (*rows[i - 1])[strain_column]))
        refuse("the plastic strains of one temperature must increase from line to line");
      if ((*rows[i])[stress_column] < (*rows[i - 1])[stress_column])
        refuse("stresses that fall with the strain: the result would depend on the mesh");
    }
  }

  void isotropic(config::Plasticity& made) {
    set_curves(table_, made);
    if (made.curve.size() == 1 && made.curve.front().stress.size() == 1) {
      made.yield_stress = made.curve.front().stress.front();
      made.curve.clear();
    }
  }

  void set_curves(const Table& table, config::Plasticity& made) {
    const auto curves = by_temperature(table);
    for (const auto& [temperature, rows] : curves) {
      config::PlasticCurve curve;
      if (curves.size() > 1) curve.T = temperature;
      for (const std::vector<double>* row : rows) {
        curve.plastic_strain.push_back((*row)[strain_column]);
        curve.stress.push_back((*row)[stress_column]);
      }
      check_curve(rows);
      made.curve.push_back(std::move(curve));
    }
  }

  /// Two rows per temperature: a straight line.
  void linear_kinematic(config::Plasticity& made) {
    std::vector<std::pair<double, double>> yield, modulus;
    for (const auto& [temperature, rows] : by_temperature(table_)) {
      if (rows.size() > 2) return refuse("kinematic hardening with more than two points: it is linear");
      check_curve(rows);
      const std::vector<double>&first = *rows.front(), &last = *rows.back();
      const double strain = last[strain_column] - first[strain_column];
      yield.emplace_back(temperature, first[stress_column]);
      modulus.emplace_back(temperature, strain > 0 ? (last[stress_column] - first[stress_column]) / strain : 0);
    }
    made.yield_stress = function_of_temperature(yield);
    made.kinematic.push_back({function_of_temperature(modulus), 0.0});
  }

  /// Yield stress, then C and gamma of each back stress.
  void combined(config::Plasticity& made) {
    const std::size_t of_temperature = 1 + 2 * material_.back_stresses;
    for (std::size_t i = 0; i < material_.back_stresses; ++i)
      if (std::ranges::any_of(table_.rows, [&](const std::vector<double>& row) {
            return row.size() < 3 + 2 * i || (row[1 + 2 * i] == 0 && row[2 + 2 * i] == 0);
          }))
        return refuse(fmt::format("C and gamma of back stress {} are missing or zero", i + 1));
    made.yield_stress = function_of_temperature(table_, 0, of_temperature);
    for (std::size_t i = 0; i < material_.back_stresses; ++i)
      made.kinematic.push_back({function_of_temperature(table_, 1 + 2 * i, of_temperature),
                                function_of_temperature(table_, 2 + 2 * i, of_temperature)});
  }

  /// The yield stress over the plastic strain, next to back stresses.
  void add_cyclic_hardening(config::Plasticity& made) {
    if (!material_.cyclic_hardening) {
      if (material_.by_table)
        refuse(
            "HARDENING=COMBINED without DATA TYPE=PARAMETERS is known next to *CYCLIC HARDENING alone, not by half or "
            "stabilised cycles");
      return;
    }
    const Table& cyclic = *material_.cyclic_hardening;
    if (cyclic.rows.empty()) return refuse("*CYCLIC HARDENING has no data");
    const std::size_t of_temperature = material_.by_table ? temperature_column : 1 + 2 * material_.back_stresses;
    const auto curves = by_temperature(cyclic);
    for (const std::vector<double>& row : table_.rows) {
      if (material_.by_table && row[strain_column] != 0) continue;
      const double temperature = row.size() > of_temperature ? row[of_temperature] : 0.0;
      const auto curve = curves.size() == 1 ? curves.begin() : curves.find(temperature);
      if (curve == curves.end()) continue;
      const double first = curve->second.front()->at(stress_column);
      if (first != row[stress_column])
        return refuse(
            fmt::format("the yield stress is {:g}, and {:g} in *CYCLIC HARDENING", row[stress_column], first));
    }
    made.yield_stress.reset();
    set_curves(cyclic, made);
    if (material_.by_table)
      draft_.left_out.push_back(
          {table_.place, "PLASTIC",
           "HARDENING=COMBINED as in CalculiX: the table is of the back stress, to which *CYCLIC HARDENING adds; in "
           "Abaqus it is a half cycle, which has both"});
  }

  Draft& draft_;
  const Material& material_;
  const Table& table_;
};

}  // namespace

bool yields(const Material& material) {
  return material.plastic &&
         std::ranges::any_of(material.plastic->rows, [](const auto& row) { return row[stress_column] != 0; });
}

void make_plasticity(Draft& draft, const Material& material, config::Material& made) {
  if (material.plastic) PlasticityMaker(draft, material).make(made);
}

}  // namespace creepcontact::deck
