#pragma once
/// The stress that the loads of a run cause without creep. It sets the error scale of the integration before the first
/// step, and shows whether a creep law starts with an infinite rate.

#include <vector>

#include "creepcontact/creep/equilibrium_solver.hpp"

namespace creepcontact::creep {

/// Times just before and after a jump at t: t (1 -+ 16 eps). Jumps that differ only by round-off thus count as one.
double just_before(double t);
double just_after(double t);

/// Result of survey_elastic_stress().
struct ElasticSurvey {
  std::vector<double> stress;  ///< per body, the largest typical stress (ErrorScale::typical); empty: no body creeps
  std::vector<double> gasket_strain = {};  ///< per pair, the largest of typical_gasket_strains()
  bool singular_start = false;             ///< true if the rate of some law is infinite at first under such a stress
};

/// Solves for the elastic stress at the start, at the end and on both sides of each breakpoint. If it is zero at all
/// these times, the output times are tried as well.
/// @param output_times  ascending; the last one is the end of the run
/// @throws ModelError if no load causes stress at any of these times. Also if a body would relax within 1e-12 of the
/// run, which points to inconsistent units
ElasticSurvey survey_elastic_stress(EquilibriumSolver& solver, const std::vector<double>& output_times,
                                    const std::vector<double>& breakpoints);

/// Without a solve: refuses a creeping model on which nothing acts at any of these times, neither a force, a prescribed
/// displacement, a thermal strain nor an overlap of a contact. Some models that survey_elastic_stress() refuses pass,
/// such as free bodies that only get warmer.
/// @throws ModelError as survey_elastic_stress(), and as Body::at()
void require_loaded(const Assembly& assembly, const std::vector<double>& output_times,
                    const std::vector<double>& breakpoints);

}  // namespace creepcontact::creep
