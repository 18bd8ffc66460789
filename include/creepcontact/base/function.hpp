#pragma once
/// Scalar functions that a user gives: a number, an expression in x, y, z, t, T, q, eps (muParser), or a table in t or
/// T.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace creepcontact {

/// Where a function is evaluated. Members that a function does not depend on are ignored.
struct Arguments {
  double x = 0, y = 0, z = 0;  ///< place
  double t = 0;                ///< time
  double T = 0;                ///< temperature
  double q = 0;                ///< equivalent stress (creep rate expressions)
  double eps = 0;              ///< accumulated equivalent creep strain (creep rate expressions)
};

struct Interval {
  double low = 0, high = 0;
};

/// Value semantics; copies share the immutable definition. May be evaluated by any threads at a time.
class Function {
 public:
  /// The constant 0.
  Function() : Function(0.0) {}
  Function(double constant);  // NOLINT(google-explicit-constructor): a number is a function value

  /// @param allowed  variables the expression may use, out of "x y z t T q eps", e.g. "xyzt" = {"x","y","z","t"}
  /// @throws std::invalid_argument with the parser's message and the position in the expression
  static Function expression(const std::string& text, const std::vector<std::string>& allowed);

  /// Linear between the points, constant outside. @param variable "t" or "T"; abscissae increasing. One in t that
  /// stands there twice is a jump: the function has the second value there, and the first up to it.
  /// @param period  of one in t: the value at t is that at t modulo the period; the points lie in [0, period], the
  /// first
  ///                at 0. A jump at its end if the values at both ends differ
  /// @throws std::invalid_argument if sizes differ, are zero, abscissae do not increase or do not fit the period
  static Function table(const std::string& variable, std::vector<double> abscissae, std::vector<double> values,
                        std::optional<double> period = {});

  /// A function of the values that other functions have; it depends on what they depend on.
  /// @param text  shows all of them: two functions of the same text are the same
  static Function composed(const std::string& text, std::vector<Function> parts,
                           std::function<double(const std::vector<double>&)> value);

  /// Index of the first abscissa that a table in this variable cannot have after the one before it; else their number.
  static std::size_t misplaced_point(const std::string& variable, const std::vector<double>& abscissae);

  /// Why a table with these points (at least one) cannot have this period; empty if it can.
  static std::string period_mistake(const std::string& variable, const std::vector<double>& abscissae, double period);

  double operator()(const Arguments& at) const;

  bool is_constant() const;
  bool is_zero() const;
  bool depends_on_place() const;        ///< x, y or z
  bool depends_on_time() const;         ///< t
  bool depends_on_temperature() const;  ///< T
  bool depends_on_strain() const;       ///< eps
  /// Times at which a table in t has its points (kinks and jumps), increasing; of a periodic one those of the first
  /// period; empty otherwise.
  std::vector<double> breakpoints() const;
  /// With all repetitions of a periodic one up to `end`.
  std::vector<double> breakpoints(double end) const;
  /// First and last point of a table in this variable.
  std::optional<Interval> table_range(const std::string& variable) const;
  /// As the user wrote it: two functions of the same text are the same.
  const std::string& text() const;

  struct Definition;

 private:
  explicit Function(std::shared_ptr<const Definition> definition) : definition_(std::move(definition)) {}
  std::shared_ptr<const Definition> definition_;
};

}  // namespace creepcontact
