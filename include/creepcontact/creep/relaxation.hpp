#pragma once
/// How fast the stress of one state makes a body creep, compared with its elastic strain.

#include <limits>

#include "creepcontact/base/team.hpp"
#include "creepcontact/creep/material_points.hpp"

namespace creepcontact::creep {

/// Creep strain that grows from t = 0 to `end` at constant stress over the elastic strain of that stress, both weighted
/// with the stress over the body. NaN if there is no stress. Collective.
/// @param at  without creep so far Cost: one pass over the points.
double creep_over_elastic_strain(const Team& team, const MaterialPoints& points, const PointsState& at, double end);

/// Times in which the creep strain at constant stress comes up to the elastic strain; for steady creep this is the
/// elastic strain over the creep rate. Infinite if it never does, NaN without stress.
struct RelaxationTime {
  double whole = std::numeric_limits<double>::infinity();    ///< of the body, weighted with the stress
  double fastest = std::numeric_limits<double>::infinity();  ///< at the point that creeps most within `whole`
  Vector3 place = Vector3::Zero();                           ///< of this point
};

/// @param points  of a body that creeps @param at  without creep so far @param near  a time to start the search from, >
/// 0 Collective. Cost: some ten passes over the points.
RelaxationTime relaxation_time(const Team& team, const MaterialPoints& points, const PointsState& at, double near);

}  // namespace creepcontact::creep
