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
    if (std::ranges::all_of(table_.rows, [](const auto& row) { return row[stress_column] == 0; })) {
      if (!material_.creep) return refuse("the yield stress is zero, and the material has no *CREEP");
      draft_.comment("materials." + made.name, "yield stress zero: all inelastic strain is creep");
      return;
    }
    if (material_.elasticity != Elasticity::isotropic) return refuse("with elasticity along axes");
    config::Plasticity plasticity;
    if (material_.hardening == "ISOTROPIC")
      isotropic(plasticity);
    else if (material_.hardening == "KINEMATIC")
      linear_kinematic(plasticity);
    else
      combined(plasticity);
    made.plasticity = std::move(plasticity);
    draft_.comment(fmt::format("materials.{}.plasticity", made.name), table_.place.text());
  }

 private:
  void refuse(const std::string& why) { draft_.impossible.push_back({table_.place, "PLASTIC", why}); }

  void isotropic(config::Plasticity& made) {
    const auto curves = by_temperature(table_);
    for (const auto& [temperature, rows] : curves) {
      config::PlasticCurve curve;
      if (curves.size() > 1) curve.T = temperature;
      for (const std::vector<double>* row : rows) {
        curve.plastic_strain.push_back((*row)[strain_column]);
        curve.stress.push_back((*row)[stress_column]);
      }
      if (!std::ranges::is_sorted(curve.stress))
        refuse("stresses that fall with the strain: the result would depend on the mesh");
      if (curve.plastic_strain.front() != 0) refuse("the first plastic strain must be 0");
      made.curve.push_back(std::move(curve));
    }
    if (curves.size() == 1 && made.curve.front().stress.size() == 1) {
      made.yield_stress = made.curve.front().stress.front();
      made.curve.clear();
    }
  }

  /// Two rows per temperature: a straight line.
  void linear_kinematic(config::Plasticity& made) {
    std::vector<std::pair<double, double>> yield, modulus;
    for (const auto& [temperature, rows] : by_temperature(table_)) {
      if (rows.size() > 2) return refuse("HARDENING=KINEMATIC with more than two points: it is linear");
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
    made.yield_stress = function_of_temperature(table_, 0, of_temperature);
    for (std::size_t i = 0; i < material_.back_stresses; ++i)
      made.kinematic.push_back({function_of_temperature(table_, 1 + 2 * i, of_temperature),
                                function_of_temperature(table_, 2 + 2 * i, of_temperature)});
  }

  Draft& draft_;
  const Material& material_;
  const Table& table_;
};

}  // namespace

void make_plasticity(Draft& draft, const Material& material, config::Material& made) {
  if (material.plastic) PlasticityMaker(draft, material).make(made);
}

}  // namespace creepcontact::deck
