#pragma once
/// A value over the time of the run, linear between its points; two points at one time are a jump.

#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/function.hpp"

namespace creepcontact::deck {

class Course {
 public:
  /// Value at the end of what is known; 0 at first.
  double last() const { return points_.empty() ? 0 : points_.back().second; }
  /// Appends a point; times do not decrease.
  void add(double time, double value);
  bool is_zero() const;
  /// Returns the value at a time: before the first point and after the last one it is theirs, at a jump the value after
  /// it.
  double at(double time) const;
  /// Returns the limit from the left, which differs at a jump.
  double before(double time) const;
  /// Returns the points that count: at most two at one time.
  std::vector<std::pair<double, double>> points() const { return tidied(); }
  bool operator==(const Course&) const = default;
  /// Makes a number, or a table in t.
  Function function() const;
  /// Makes an expression of the value: sqrt(<value>) with wrap = "sqrt". Jumps are conditions on t.
  Function function(const std::string& wrap) const;
  Course scaled(double factor) const;
  /// The sum of both. A course without points is 0.
  Course plus(const Course& other) const;

 private:
  bool is_constant() const;
  std::vector<std::pair<double, double>> tidied() const;

  std::vector<std::pair<double, double>> points_;
};

}  // namespace creepcontact::deck
