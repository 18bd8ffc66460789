#pragma once
/// Guards time steps against what happens within them unseen. The error estimates of the integrators see the loads and
/// the constants of the laws at the ends of a step and at few times within, so a pulse in between leaves no trace. The
/// guard evaluates the functions themselves (no solves) at more times, and ends the step where a polynomial, which an
/// integrator of high order would follow, no longer represents them.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/mesh/mesh.hpp"
#include "creepcontact/model/model.hpp"

namespace creepcontact::model {

/// A function of the configuration as time passes, at the places where it acts and at stresses, strains and
/// temperatures that it meets there.
struct CoursesInTime {
  std::string key;                                         ///< full: "loads[0].pressure"
  std::vector<std::function<double(double t)>> at_places;  ///< one at least
};

/// The courses of all functions of the configuration that depend on time, or on a temperature that does.
std::vector<CoursesInTime> courses_in_time(const config::Config& config, const Model& model);

/// Those of the functions that act by the temperature alone. @param places  where they are looked at @param T  at which
std::vector<CoursesInTime> heat_courses(const config::Config& config, const std::vector<Vector3>& places, double T);

/// Immutable: what it answers depends on the arguments alone.
class StepGuard {
 public:
  /// @param courses  those that depend on time
  /// @param end  of the run @param tolerance  relative, of the functions: larger deviations from a polynomial count
  StepGuard(std::vector<CoursesInTime> courses, double end, double tolerance);

  bool is_needed() const { return !courses_.empty(); }
  const std::vector<CoursesInTime>& courses() const { return courses_; }

  /// The times at which the loads of a segment are evaluated: jumps at its ends count from within.
  struct Segment {
    double begin = 0, end = 0;  ///< exclusive
  };
  struct Finding {
    std::size_t course = 0;  ///< index
    double time = 0;         ///< up to which a step represents the course
    double at = 0;           ///< where it deviates most
    double deviation = 0;    ///< there, from the polynomial
    double relative = 0;     ///< the same, over the size of the course
    double share = 0;        ///< of the step, in which it deviates
    /// The course jumps at `time`: the double at which the value changes, or its neighbour if that is rounder.
    bool is_jump = false;
  };
  /// What a step from `from` to `to` does not see of a course; nullopt: nothing that was found.
  /// @param index  of the course
  /// Cost: a dozen evaluations per place, at three places that change from step to step; hundreds if something is
  /// found.
  std::optional<Finding> examine(std::size_t index, double from, double to, const Segment& segment) const;

 private:
  std::vector<CoursesInTime> courses_;
  std::vector<double> sizes_;  // largest values at some times, per course
  double tolerance_;
};

}  // namespace creepcontact::model
