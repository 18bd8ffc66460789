#include "creepcontact/material/creep_curve.hpp"

#include <cmath>

#include "creepcontact/material/bar.hpp"

namespace creepcontact::material {
namespace {

constexpr int points_per_decade = 40;
constexpr double largest_shown_strain = 1;

}  // namespace

CreepCurve creep_curve(const Material& material, const CreepTest& test, double decades) {
  CreepCurve curve;
  if (!material.creeps() || !(test.end > 0)) return curve;
  const int n = static_cast<int>(std::ceil(decades * points_per_decade));
  for (int i = 0; i <= n; ++i)
    curve.time.push_back(test.end * std::pow(10, decades * (static_cast<double>(i) / n - 1)));
  const BarHistory history =
      bar_history(material.creep, {.stress = test.stress, .temperature = test.temperature}, curve.time);
  for (const BarState& state : history.states) {
    if (std::abs(state.creep_strain) > largest_shown_strain) break;
    curve.strain.push_back(state.creep_strain);
  }
  curve.time.resize(curve.strain.size());
  return curve;
}

}  // namespace creepcontact::material
