#pragma once
/// Samples of a function at all its places, which tell where else to look closely.

#include <optional>
#include <vector>

#include "function_courses.hpp"

namespace creepcontact::model {

/// Values at all places, or evenly chosen ones, and at 64 or more times that differ from place to place: together they
/// see what is short or small.
class Screening {
 public:
  /// @param evaluations  of the function, in all
  Screening(const FunctionCourses& function, const Places& places, double end, double evaluations);

  /// The place with the largest change that no known time explains; nullopt: there is none. Each place once.
  /// @param known  times of jumps, kinks and turns that have been found, increasing
  std::optional<std::size_t> next(const std::vector<double>& known);

 private:
  double time(std::size_t row, std::size_t i) const;

  double end_, range_ = 0;
  std::size_t n_times_ = 0;
  std::vector<std::size_t> places_;
  std::vector<double> values_;  // [place][time]
  std::vector<bool> taken_;
};

}  // namespace creepcontact::model
