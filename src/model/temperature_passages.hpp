#pragma once
/// When the temperature passes the points of tables in T.

#include <vector>

#include "function_courses.hpp"

namespace creepcontact::model {

struct TemperaturePassages {
  std::vector<double> times;
  double missing = 0;  ///< largest relative change of the function without a point that is left out; 0: all are here
};

/// Times at which the temperature of a place passes a point of the function's table in T, or a kink or jump of its
/// expression in T. Where the field is uniform all of them, but for points so weak that leaving them out changes the
/// value by less than 2 %, if there are more than 300. In a field with gradients the places pass a point one after the
/// other, and the kink of the whole is smeared: the first and the last one and up to three between. If there are more
/// than 1e5 passages, those of the weakest points are left out.
/// @param pieces  0, the end of the run, and times between at which the temperature may turn or jump; increasing
TemperaturePassages temperature_passages(const FunctionCourses& function, const Places& places,
                                         const std::vector<double>& pieces);

}  // namespace creepcontact::model
