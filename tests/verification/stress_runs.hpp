#pragma once
/// Runs of one model with different integrators and tolerances, compared by the stress at all integration points.

#include <string>
#include <vector>

#include "creepcontact/config/reader.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "creepcontact/run/vocabulary.hpp"

namespace creepcontact::test {

/// Stress of all bodies at the output times after t = 0, and what it cost.
struct StressHistory {
  std::vector<std::vector<double>> stress;  ///< an output time: all points x 6
  std::int64_t elastic_solves = 0;          ///< of the integration alone, without those for the output times
  ode::Integrator::Counters steps;
};

/// Largest over the output times.
struct StressError {
  double norm = 0;     ///< root mean square over the volume, relative to that of the reference
  double maximum = 0;  ///< at any point, relative to the largest stress of the reference
};

/// The model is meshed and factored once for all runs.
class StressRuns {
 public:
  explicit StressRuns(const config::Config& config);
  static StressRuns of_file(const std::string& name, const std::vector<std::string>& overrides = {});

  StressHistory run(double tolerance, const std::string& integrator_name);

  StressError error(const StressHistory& history, const StressHistory& reference) const;

 private:
  static std::vector<double> all_stress(const creep::Equilibrium& at);

  config::Time time_;
  Stopwatch watch_;
  model::Model model_;
  creep::EquilibriumSolver solver_;
  std::vector<double> volume_;
};

}  // namespace creepcontact::test
