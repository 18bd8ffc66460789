#include "creepcontact/creep/elastic_survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "creepcontact/base/error.hpp"
#include "creepcontact/creep/error_scale.hpp"
#include "creepcontact/creep/material_points.hpp"
#include "creepcontact/numerics/point_sums.hpp"

namespace creepcontact::creep {
namespace {

// Jumps that differ by rounding alone count as one breakpoint: these times lie beyond all of them.
constexpr double beside = 16 * std::numeric_limits<double>::epsilon();
constexpr double max_creep = 1e12;  // of the elastic strain, over the run: no machine part lives through so much

/// sigma : C sigma
double elastic_work(const Tensor6& stress, const material::Moduli& moduli) {
  const double trace = tensor::trace(stress);
  return tensor::deviator(stress).squaredNorm() / (2 * moduli.mu) +
         trace * trace / (3 * (3 * moduli.lambda + 2 * moduli.mu));
}

/// Creep until `end` at constant stress over the elastic strain.
double creep_over_elastic_strain(const Team& team, const MaterialPoints& points, const PointsState& at, double end) {
  std::vector<double> change(points.size() * points.stride(), 0.0);
  points.add_increment(0, end, at, change);
  const std::span<const double> weights = points.body().discretization().weights();
  const mechanics::CreepStrainView grown{change, points.stride()};
  const double stored = numerics::sum_over_points(points.size(), [&](std::size_t p) {
    return weights[p] * elastic_work(tensor::view(at.stress, p), at.elastic.at(p));
  });
  const double spent = numerics::sum_over_points(
      points.size(), [&](std::size_t p) { return weights[p] * tensor::view(at.stress, p).dot(grown.at(p)); });
  return team.sum(spent) / team.sum(stored);
}

class Survey {
 public:
  Survey(EquilibriumSolver& solver, double end)
      : solver_(solver), end_(end), no_creep_(solver.assembly().bodies().size()) {
    for (const mechanics::Body& body : solver.assembly().bodies()) points_.emplace_back(body);
  }

  ElasticSurvey at(const std::vector<double>& times) {
    ElasticSurvey result{std::vector<double>(points_.size(), 0.0), false};
    const bool has_preloads = std::ranges::any_of(solver_.assembly().pairs(),
                                                  [](const contact::Pair& pair) { return pair.preload.has_value(); });
    history_ = has_preloads ? solver_.initial_history() : solver_.new_history();
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
        history_ = solver_.initial_history();
        solver_.solve(t, no_creep_, history_, equilibrium_);
      }
      const std::vector<double> stress = ErrorScale::typical(solver_.assembly(), equilibrium_);
      look_at_laws(stress, result);
      for (std::size_t b = 0; b < points_.size(); ++b) result.stress[b] = std::max(result.stress[b], stress[b]);
    }
    return result;
  }

 private:
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
      if (!(strains > max_creep) || !std::isfinite(strains)) continue;
      const mechanics::Body& body = points.body();
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
  return t * (1 - beside);
}
double just_after(double t) {
  return t * (1 + beside);
}

ElasticSurvey survey_elastic_stress(EquilibriumSolver& solver, const std::vector<double>& output_times,
                                    const std::vector<double>& breakpoints) {
  if (!solver.assembly().creeps()) return {};
  const double end = output_times.back();
  std::vector<double> times{0.0};
  for (const double t : breakpoints)
    if (t > 0 && t < end) times.insert(times.end(), {just_before(t), just_after(t)});
  times.push_back(end);
  Survey survey(solver, end);
  ElasticSurvey result = survey.at(times);
  const auto is_zero = [](const ElasticSurvey& of) { return !(*std::ranges::max_element(of.stress) > 0); };
  // Loads that vanish at all these times may still act in between.
  if (is_zero(result)) result = survey.at(output_times);
  if (is_zero(result))
    throw ModelError(
        "the bodies are not loaded: no load, support, temperature or gap causes stress at any output time");
  return result;
}

}  // namespace creepcontact::creep
