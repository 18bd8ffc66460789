#pragma once
/// Measured steady rates: straight lines in ln f over ln q between the tests of one temperature. Beyond the first and
/// last test their lines go on, below the first one with an exponent of at least 1. Between two temperatures
///   ln f = (1 - w) ln f_j + w ln f_j+1,   w = (1/T_j - 1/T)/(1/T_j - 1/T_j+1), temperatures absolute,
/// which is thermal activation (Arrhenius) with an energy that depends on the stress. Outside of the temperatures of
/// the tests the curve of the nearest one holds.

#include "flow_law.hpp"
#include "law_table.hpp"

namespace creepcontact::material {

class RateTable final : public FlowLaw {
 public:
  /// One entry per test, in any order.
  enum Constant {
    stress,  ///< [stress], > 0
    rate,    ///< [1/time], > 0
    T,       ///< temperature; empty: all tests at one, and the rate does not depend on it
    absolute_zero,
    n_constants
  };
  /// @throws ParameterError if the lists differ in length; if a temperature has less than two tests, two at the same
  /// stress, or rates that do not increase with the stress; if a temperature is not above absolute zero
  explicit RateTable(const ParameterValues& values);
  std::string name() const override { return "rate_table"; }
  EquivalentRate equivalent_rate(double q, const PointState& at) const override;

 private:
  /// The tests of one temperature. Values are logarithms.
  struct Curve {
    double temperature = 0;  ///< absolute
    std::vector<double> stress, rate;
    /// @returns ln f and d ln f/d ln q
    std::pair<double, double> at(double log_stress) const;
  };
  struct Test {
    double stress, rate, temperature;
  };
  enum PointConstant { place };  ///< number of the curve, linear in T between the curves

  explicit RateTable(const ParameterValues& values, std::vector<Test> tests);
  static std::vector<Test> sorted_tests(const ParameterValues& values);
  static ParameterValues at_points(const std::vector<Test>& tests);

  std::vector<Curve> curves_;  // by temperature
  double absolute_zero_;
};

LawInfo rate_table_info();

}  // namespace creepcontact::material
