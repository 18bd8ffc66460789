#pragma once
/// Where a vibration turns back.

#include <vector>

#include "discontinuities.hpp"

namespace creepcontact::model {

/// Times of the maxima and minima between which 16 samples per turn lie; increasing. Cost: some 50 evaluations each.
/// @param n_turns  known roughly @returns nothing if there are more than 100 000
std::vector<double> turns_of_vibration(const Course& course, Interval over, double n_turns);

}  // namespace creepcontact::model
