#pragma once
/// The stress that the loads of a run give without creep: what its integration is measured by, before its first step.

#include <vector>

#include "creepcontact/creep/equilibrium_solver.hpp"

namespace creepcontact::creep {

/// Times that are beyond a jump at t, which counts as one time although its places may differ by rounding.
double just_before(double t);
double just_after(double t);

struct ElasticSurvey {
  std::vector<double> stress;   ///< largest typical stress of every body (ErrorScale::typical); empty: nothing creeps
  bool singular_start = false;  ///< some law's rate starts infinite under such a stress
};

/// Solves for the elastic stress at the start, the end and on both sides of the breakpoints; if all of it is zero, at
/// the output times.
/// @param output_times  ascending, the last is the end of the run
/// @throws ModelError if nothing gives any stress at any of these times, or if a body relaxes in 1e-12 of the run,
/// which
///         units that do not fit together make
ElasticSurvey survey_elastic_stress(EquilibriumSolver& solver, const std::vector<double>& output_times,
                                    const std::vector<double>& breakpoints);

}  // namespace creepcontact::creep
