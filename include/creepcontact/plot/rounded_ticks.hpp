#pragma once
/// Round numbers for axes and legends.

#include <vector>

namespace creepcontact::plot {

/// Ticks at steps of 1, 2 or 5 times a power of ten that cover [low, high]: the first is at most low, the last at least
/// high. A range that is empty, or that differs by rounding alone (1e-9 of the numbers), is widened by a hundredth to
/// both sides. @param about  number of steps, which are at most one third fewer or as many
/// Precondition: low, high and their difference are finite. `roundedTicks` of web/report does the same.
std::vector<double> rounded_ticks(double low, double high, double about = 6);

}  // namespace creepcontact::plot
