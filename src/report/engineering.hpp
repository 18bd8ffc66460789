#pragma once
/// Numbers as engineers write them: three significant figures, thousands in groups, a prefix of the unit for a whole
/// column.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::report {

/// What the numbers of one column, or of one table, have in common.
class Scale {
 public:
  /// @param unit  as in the results: "N", "MPa"; empty: none @param values  those that the column shows; what is below
  ///   1e-9 of the largest is round-off
  Scale(const std::string& unit, std::span<const double> values);

  /// Unit of the numbers shown: "kN".
  const std::string& unit() const { return unit_; }
  /// "160"; "0" for round-off, "-" for what is not finite.
  std::string text(double value) const;
  /// From numbers of the results to those shown.
  double factor() const { return factor_; }
  /// "160 kN"
  std::string with_unit(double value) const;

 private:
  std::string unit_;
  double factor_ = 1, smallest_ = 0;
};

/// A number with at most so many significant figures: "100 000", "0.0123", "1.6·10⁻⁷". Groups are divided by narrow
/// no-break spaces.
std::string engineering(double value, int figures = 3);

/// A number and its unit, with a prefix that fits: "160 kN".
std::string quantity(double value, const std::string& unit);

/// Times have five figures: they are often round numbers that somebody has asked for. "100 000 h"
std::string time_text(double value, const std::string& unit);

/// "98 %", "0.42 %"; never "-0 %".
std::string percent(double share);

/// "normal force [kN]"
std::string labelled(const std::string& name, const std::string& unit);

/// "(12.5, 0, 100) mm"
std::string place_text(std::span<const double, 3> position, const std::string& unit);

/// A cell of text whose number is written as computers do, "1.6e+05 N", with the figures it has; other text as it is.
std::string readable(const std::string& cell);

/// Whether a cell is a number as the functions above write it, maybe with a unit of one word.
bool is_number_text(std::string_view cell);

}  // namespace creepcontact::report
