/// What a CreepSystem does with temperatures that are part of its state.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/ode/anderson_iteration.hpp"
#include "gasket_creep.hpp"
#include "heat_coupling.hpp"
#include "vector_views.hpp"

namespace creepcontact::creep {
namespace {

constexpr double law_difference = 0.1;  // degrees, for rates of laws in central differences
constexpr int anderson_depth = 5, most_iterations = 200, power_iterations = 30;
constexpr double steady_tolerance = 1e-9;  // of the range of temperatures
constexpr double same_gain = 1e-3, gain_rounding = 1e-12;

double largest_of(std::span<const double> values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

/// @param strains  n_points x 6 per body; must outlive the result
std::vector<mechanics::CreepStrainView> views_of(const std::vector<std::vector<double>>& strains) {
  std::vector<mechanics::CreepStrainView> result;
  result.reserve(strains.size());
  for (const std::vector<double>& of_body : strains) result.push_back({.data = of_body, .stride = 6});
  return result;
}

}  // namespace

void CreepSystem::heat_products(const Evaluation& at, std::span<const double> y, std::span<const double> v,
                                std::span<double> product) {
  const StateLayout& layout = laws_.layout();
  std::vector<double> free(layout.temperatures(v).begin(), layout.temperatures(v).end());
  for (std::size_t u = 0; u < free.size(); ++u)
    if (heat_->rates().problem().is_given(u)) free[u] = 0;
  const std::vector<std::vector<double>> T_change = heat_->interpolated(free);
  std::vector<std::vector<double>> strain = heat_->strain_change(at.equilibrium, T_change);
  laws_.layout().views(v, views_);
  for (std::size_t b = 0; b < strain.size(); ++b)
    if (!views_[b].empty())
      for (std::size_t p = 0; p < T_change[b].size(); ++p) tensor::writable(strain[b], p) += views_[b].at(p);
  const std::vector<mechanics::CreepStrainView> all = views_of(strain);
  gaskets_->closures(v, closures_);
  Eigen::VectorXd gap;
  const Eigen::VectorXd multiplier = solver_.linearized(at.equilibrium, {all, closures_}, stress_change_, &gap);
  const auto lap = watch_.lap(Part::material);
  laws_.for_each_creeping([&](std::size_t b, const MaterialPoints& points) {
    const PointsState state = laws_.state(b, at, y);
    const std::span<double> own = layout.part(b, product);
    points.derivative(state, {stress_change_[b], layout.part(b, v)}, own);
    const double most = largest_of(T_change[b]);
    if (most == 0) return;
    const double factor = law_difference / most;
    std::vector<double> rate(own.size());
    for (const double sign : {1.0, -1.0}) {
      mechanics::BodyConditions conditions;
      conditions.time = at.equilibrium.conditions[b].time;
      conditions.temperature = at.equilibrium.conditions[b].temperature;
      for (std::size_t p = 0; p < T_change[b].size(); ++p) conditions.temperature[p] += sign * factor * T_change[b][p];
      LawParameters laws;
      points.update(conditions, laws);
      points.rate({laws, state.elastic, state.stress, state.state}, rate);
      vector(own) += sign / (2 * factor) * vector(rate);
    }
  });
  gaskets_->derivative(at.equilibrium, y, multiplier, v, product);
  heat_->rates().derivative(at.time, layout.temperatures(y), joint_values(assembly(), at.equilibrium), free,
                            joint_change(assembly(), at.equilibrium, multiplier, gap), layout.temperatures(product));
}

std::vector<double> CreepSystem::initial_state() {
  std::vector<double> y(size(), 0.0);
  const HeatModel* heat = assembly().heat();
  if (heat == nullptr) return y;
  const std::span<double> T = laws_.layout().temperatures(std::span(y));
  std::ranges::copy(heat->start, T.begin());
  if (!heat->start_is_steady) return y;
  const double t = load_time(0);
  std::vector<double> state = y;
  int iterations = 0;
  bool has_converged = false;
  ode::AndersonIteration iteration(T.size(), anderson_depth);
  iteration.run(T, [&](std::span<const double> from, std::span<double> image) {
    std::ranges::copy(from, laws_.layout().temperatures(std::span(state)).begin());
    const Evaluation& at = evaluate_output(t, state);
    std::ranges::copy(from, image.begin());
    heat_->rates().steady(t, joint_values(assembly(), at.equilibrium), image);
    double change = 0;
    for (std::size_t u = 0; u < from.size(); ++u) change = std::max(change, std::abs(image[u] - from[u]));
    has_converged = change <= steady_tolerance * heat->range;
    return has_converged || ++iterations >= most_iterations;
  });
  forget_evaluations();
  if (!has_converged)
    throw SolverError(fmt::format(
        "heat: no steady temperatures found at t = 0 in {} iterations between heat and contact: what contact and heat "
        "do to each other may have no steady state, or an unstable one; start from a given temperature instead",
        most_iterations));
  return y;
}

std::optional<double> CreepSystem::loop_gain(double t, std::span<const double> y) {
  if (!heat_) return std::nullopt;
  const Evaluation& at = evaluate_output(t, y);
  const std::span<const double> T = laws_.layout().temperatures(y);
  const JointValues joint = joint_values(assembly(), at.equilibrium);
  std::vector<double> direction(T.begin(), T.end());
  // A start that has a part along any eigenvector: temperatures that are not those of the state.
  for (std::size_t u = 0; u < direction.size(); ++u) direction[u] = 1 + 0.37 * static_cast<double>(u % 7);
  for (std::size_t u = 0; u < direction.size(); ++u)
    if (heat_->rates().problem().is_given(u)) direction[u] = 0;
  double gain = 0;
  std::vector<std::vector<double>> stress;
  for (int k = 0; k < power_iterations; ++k) {
    const double length = vector(direction).norm();
    if (!(length > 0)) return 0;
    vector(direction) /= length;
    const std::vector<std::vector<double>> strain =
        heat_->strain_change(at.equilibrium, heat_->interpolated(direction));
    const std::vector<mechanics::CreepStrainView> views = views_of(strain);
    Eigen::VectorXd gap;
    const Eigen::VectorXd multiplier = solver_.linearized(at.equilibrium, views, stress, &gap);
    const std::optional<std::vector<double>> image =
        heat_->rates().steady_change(at.time, T, joint, joint_change(assembly(), at.equilibrium, multiplier, gap));
    if (!image) return std::nullopt;
    const double before = gain;
    gain = vector(*image).dot(vector(direction));
    direction = *image;
    if (k > 0 && std::abs(gain - before) <= same_gain * std::abs(gain)) break;
  }
  return std::abs(gain) > gain_rounding ? gain : 0;
}

}  // namespace creepcontact::creep
