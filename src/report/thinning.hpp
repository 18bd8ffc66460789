#pragma once
/// Curves with no more points than a picture can show.

#include "creepcontact/plot/figure.hpp"

namespace creepcontact::report {

/// Divides the axis into columns and keeps the first, the lowest, the highest and the last point of each, so that every
/// peak remains. At most some 2000 points; shorter curves stay as they are. @param logarithmic  the axis of x
plot::Series thinned(const plot::Series& series, bool logarithmic);

/// True if much of what the curve does happens in the first hundredth of its axis, where a linear one hides it.
bool begins_fast(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace creepcontact::report
