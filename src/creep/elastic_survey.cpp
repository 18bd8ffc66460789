#include "creepcontact/creep/elastic_survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "creepcontact/base/error.hpp"
#include "creepcontact/creep/error_scale.hpp"
#include "creepcontact/creep/material_points.hpp"
#include "creepcontact/creep/relaxation.hpp"
#include "gasket_creep.hpp"

namespace creepcontact::creep {
namespace {

// Jumps that differ by rounding alone count as one breakpoint: these times lie beyond all of them.
constexpr double one_sided_shift = 16 * std::numeric_limits<double>::epsilon();
constexpr double usual_thermal_stress = 0.1;  // of what the range of temperatures would cause in a body that is held
constexpr double max_creep = 1e12;  // of the elastic strain, over the run: no machine part lives through so much

constexpr const char* not_loaded =
    "the bodies are not loaded: no load, support, temperature, initial stress or gap causes stress at any output time";

/// Start, end, and both sides of each breakpoint between them.
std::vector<double> telling_times(double end, const std::vector<double>& breakpoints) {
  std::vector<double> times{0.0};
  for (const double t : breakpoints)
    if (t > 0 && t < end) times.insert(times.end(), {just_before(t), just_after(t)});
  times.push_back(end);
  return times;
}

bool acts(const contact::Pair& pair, double t) {
  if (pair.preload) return true;
  if (pair.gasket && pair.ties_nodes() && pair.gasket->kind().law.curve(0, 0).pressure(0) != 0) return true;
  const contact::MortarCoupling& coupling = pair.coupling;
  const Eigen::VectorXd gap = pair.initial_gap(t);
  // Whatever is not a plain opening may load the bodies, also what is not a number.
  if (coupling.type == contact::ContactType::tied) return !gap.isZero(0);
  const Eigen::VectorXd normal = coupling.first_rows(gap);
  return normal.size() > 0 && !(normal.minCoeff() >= 0);
}

bool acts(const mechanics::BodyConditions& at) {
  const auto any = [](const std::vector<double>& values) {
    return std::ranges::any_of(values, [](double value) { return value != 0; });
  };
  return any(at.external) || any(at.prescribed) || any(at.thermal_strain) || any(at.thermal_tensors);
}

/// Whether temperatures of the state may load the bodies.
bool assembly_expands(const Assembly& assembly) {
  return assembly.heat() != nullptr && std::ranges::any_of(assembly.bodies(), [](const mechanics::Body& body) {
           return !body.material().thermal_expansion.is_zero();
         });
}

class Survey {
 public:
  Survey(EquilibriumSolver& solver, double end)
      : solver_(solver), end_(end), no_creep_(solver.assembly().bodies().size()) {
    for (const mechanics::Body& body : solver.assembly().bodies()) points_.emplace_back(body);
  }

  ElasticSurvey at(const std::vector<double>& times) {
    ElasticSurvey result{.stress = std::vector<double>(points_.size(), 0.0)};
    const bool has_preloads = std::ranges::any_of(solver_.assembly().pairs(),
                                                  [](const contact::Pair& pair) { return pair.preload.has_value(); });
    history_ = has_preloads ? solver_.initial_elastic_history() : solver_.new_history();
    for (const double t : times) {
      try {
        if (solver_.has_preload_due(t, history_)) solver_.apply_preloads(t, t, no_creep_, history_);
        solver_.solve(t, no_creep_, history_, equilibrium_);
      } catch (const ModelError&) {
        if (t == times.front()) throw;
        continue;  // a load that lifts a body off later: the run goes on up to there
      } catch (const SolverError&) {
        // With friction all of a load in one step may be too much; the run takes shorter ones.
        if (history_.friction.slip.size() == 0) throw;
        if (t != times.front()) continue;
        history_ = solver_.initial_elastic_history();
        solver_.solve(t, no_creep_, history_, equilibrium_);
      }
      const std::vector<double> stress = ErrorScale::typical(solver_.assembly(), equilibrium_);
      look_at_laws(stress, result);
      for (std::size_t b = 0; b < points_.size(); ++b) result.stress[b] = std::max(result.stress[b], stress[b]);
      look_at_gaskets(result);
    }
    return result;
  }

 private:
  void look_at_gaskets(ElasticSurvey& result) const {
    const std::vector<double> strain = typical_gasket_strains(solver_.assembly(), equilibrium_);
    result.gasket_strain.resize(strain.size());
    std::ranges::transform(strain, result.gasket_strain, result.gasket_strain.begin(),
                           [](double a, double b) { return std::max(a, b); });
    const GasketCreep gaskets(solver_.assembly(),
                              std::vector<double>(strain.size(), material::PointState{}.min_strain));
    const std::vector<double> no_state(StateLayout(solver_.assembly()).size());
    const Team& team = solver_.assembly().team();
    result.singular_start = result.singular_start || team.min(gaskets.start_exponent(0, equilibrium_, no_state)) < 1;
  }

  void look_at_laws(const std::vector<double>& stress, ElasticSurvey& result) const {
    const Team& team = solver_.assembly().team();
    std::string mistakes;
    for (std::size_t b = 0; b < points_.size(); ++b) {
      const MaterialPoints& points = points_[b];
      if (points.empty()) continue;
      LawParameters laws;
      points.update(equilibrium_.conditions[b], laws);
      const std::vector<double> no_state(points.size() * points.stride(), 0.0);
      const PointsState at{laws, equilibrium_.conditions[b].elastic(), equilibrium_.bodies[b].stress, no_state};
      result.singular_start = result.singular_start || team.min(points.start_exponent(0, at)) < 1;
      const double strains = creep_over_elastic_strain(team, points, at, end_);
      const mechanics::Body& body = points.body();
      // Yielding relieves at once what no such material carries.
      const bool yields = body.material().plasticity != nullptr ||
                          std::ranges::any_of(body.material().creep, [](const auto& law) { return law->yields(); });
      if (!(strains > max_creep) || !std::isfinite(strains) || yields) continue;
      mistakes += fmt::format(
          "{}body '{}' would relax within {:.1g} of the run time: under its typical stress of {:.3g} at t = {:.6g}, "
          "material '{}' creeps by {:.1g} times its elastic strain until time.end; check that young_modulus, the loads "
          "and the creep constants are in the same units",
          mistakes.empty() ? "" : "\n", body.name(), 1 / strains, stress[b], equilibrium_.time, body.material().name,
          strains);
    }
    if (!mistakes.empty()) throw ModelError(mistakes);
  }

  EquilibriumSolver& solver_;
  double end_;
  std::vector<mechanics::CreepStrainView> no_creep_;
  History history_;
  std::vector<MaterialPoints> points_;
  Equilibrium equilibrium_;
};

}  // namespace

double just_before(double t) {
  return t * (1 - one_sided_shift);
}
double just_after(double t) {
  return t * (1 + one_sided_shift);
}

ElasticSurvey survey_elastic_stress(EquilibriumSolver& solver, const std::vector<double>& output_times,
                                    const std::vector<double>& breakpoints) {
  if (!solver.assembly().creeps()) return {};
  const double end = output_times.back();
  Survey survey(solver, end);
  ElasticSurvey result = survey.at(telling_times(end, breakpoints));
  const auto is_zero = [](const ElasticSurvey& of) { return !(*std::ranges::max_element(of.stress) > 0); };
  // Loads that vanish at all these times may still act in between.
  if (is_zero(result)) result = survey.at(output_times);
  if (is_zero(result) && assembly_expands(solver.assembly())) {
    // Only heat loads the bodies, later: its stress is at most that of the range of its temperatures.
    for (std::size_t b = 0; b < result.stress.size(); ++b) {
      const material::Material& material = solver.assembly().bodies()[b].material();
      const double T = material.reference_temperature;
      result.stress[b] = usual_thermal_stress * solver.assembly().heat()->range * material.young_modulus({.T = T}) *
                         material.thermal_expansion.strains(T + 1, T).cwiseAbs().maxCoeff();
    }
  }
  if (is_zero(result)) throw ModelError(not_loaded);
  return result;
}

void require_loaded(const Assembly& assembly, const std::vector<double>& output_times,
                    const std::vector<double>& breakpoints) {
  if (!assembly.creeps()) return;
  std::vector<double> times = telling_times(output_times.back(), breakpoints);
  times.insert(times.end(), output_times.begin(), output_times.end());
  std::vector<mechanics::BodyConditions> conditions;
  bool loaded = false;
  if (assembly_expands(assembly)) return;
  for (const double t : times) {
    assembly.update(t, conditions);
    for (const mechanics::BodyConditions& at : conditions) loaded = loaded || acts(at);
    for (const contact::Pair& pair : assembly.pairs()) loaded = loaded || acts(pair, t);
    if (assembly.team().any(loaded)) return;
  }
  throw ModelError(not_loaded);
}

}  // namespace creepcontact::creep
