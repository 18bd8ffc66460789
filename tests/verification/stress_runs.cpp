#include "verification/stress_runs.hpp"

#include <algorithm>
#include <cmath>

namespace creepcontact::test {

StressRuns::StressRuns(const config::Config& config)
    : time_(config.time), model_(model::build_model(config)), solver_(model_.assembly, model_.solver, watch_) {
  for (const mechanics::Body& body : model_.bodies()) {
    const auto weights = body.discretization().weights();
    volume_.insert(volume_.end(), weights.begin(), weights.end());
  }
}

StressRuns StressRuns::of_file(const std::string& name, const std::vector<std::string>& overrides) {
  return StressRuns(config::read(std::string(CREEPCONTACT_CONFIGS "/") + name, run::vocabulary(), overrides));
}

StressHistory StressRuns::run(double tolerance, const std::string& integrator_name) {
  creep::CreepSystem system(solver_, creep::survey_elastic_stress(solver_, time_.output, model_.breakpoints), tolerance,
                            watch_);
  ode::IntegratorOptions options{.tolerance = tolerance};
  options.end_time = time_.end;
  const auto integrator = ode::make_integrator(integrator_name, system, options);
  std::vector<double> state(system.size(), 0.0);
  integrator->initialize(0, state);
  StressHistory history;
  const std::int64_t before = system.run_counters().elastic_solves;
  std::int64_t for_output = 0;
  for (auto next = time_.output.begin() + 1; next != time_.output.end();) {
    integrator->step(time_.end);
    for (; next != time_.output.end() && *next <= integrator->time(); ++next) {
      const std::int64_t solves = system.run_counters().elastic_solves;
      integrator->interpolate(*next, state);
      const creep::Evaluation& at = system.evaluate_output(*next, state);
      for_output += system.run_counters().elastic_solves - solves;
      history.stress.push_back(all_stress(at.equilibrium));
    }
  }
  history.elastic_solves = system.run_counters().elastic_solves - before - for_output;
  history.steps = integrator->counters();
  return history;
}

StressError StressRuns::error(const StressHistory& history, const StressHistory& reference) const {
  StressError error;
  for (std::size_t k = 0; k < reference.stress.size(); ++k) {
    double difference = 0, sum = 0, largest_difference = 0, largest = 0;
    for (std::size_t p = 0; p < volume_.size(); ++p) {
      const Eigen::Map<const Tensor6> a(&history.stress[k][6 * p]), b(&reference.stress[k][6 * p]);
      difference += volume_[p] * (a - b).squaredNorm();
      sum += volume_[p] * b.squaredNorm();
      largest_difference = std::max(largest_difference, (a - b).norm());
      largest = std::max(largest, b.norm());
    }
    error.norm = std::max(error.norm, std::sqrt(difference / sum));
    error.maximum = std::max(error.maximum, largest_difference / largest);
  }
  return error;
}

std::vector<double> StressRuns::all_stress(const creep::Equilibrium& at) {
  std::vector<double> all;
  for (const creep::BodyState& state : at.bodies) all.insert(all.end(), state.stress.begin(), state.stress.end());
  return all;
}

}  // namespace creepcontact::test
