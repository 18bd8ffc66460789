#pragma once
/// Scalar functions given by the user: a number, an expression in x, y, z, t, T, q, eps, U, p, gap (muParser), or a
/// table in t, T, p or gap.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace creepcontact {

/// The point at which a function is evaluated. Variables that a function does not use are ignored.
struct Arguments {
  double x = 0, y = 0, z = 0;  ///< position
  double t = 0;                ///< time
  double T = 0;                ///< temperature
  double q = 0;                ///< equivalent stress (creep rate expressions)
  double eps = 0;              ///< accumulated equivalent creep strain (creep rate expressions)
  double U = 1;                ///< strength of the material (of a law that has one)
  double p = 0, gap = 0;       ///< pressure and opening of a contact
};

/// A closed interval.
struct Interval {
  double low = 0, high = 0;
};

/// A function that is evaluated at many points at once. May be called by several threads.
class BatchedFunction {
 public:
  virtual ~BatchedFunction() = default;
  /// @param at  arguments @param values  as many
  virtual void evaluate(std::span<const Arguments> at, std::span<double> values) const = 0;
  /// Sets the derivatives by q and eps instead, if it knows them. @returns false if it does not
  virtual bool differentiate(std::span<const Arguments> /*at*/, std::span<double> /*by_stress*/,
                             std::span<double> /*by_strain*/) const {
    return false;
  }
};

/// A scalar function. Value semantics; copies share the immutable definition. Any number of threads may evaluate it
/// concurrently.
class Function {
 public:
  /// The constant 0.
  Function() : Function(0.0) {}
  Function(double constant);  // NOLINT(google-explicit-constructor): a number is a function value

  /// @param allowed  variables that the expression may use, a subset of "x y z t T q eps U p gap": "xyzt" is
  /// {"x","y","z","t"}
  /// @throws std::invalid_argument with the message of the parser and the position in the expression
  static Function expression(const std::string& text, const std::vector<std::string>& allowed);

  /// Table, linear between the points and constant outside.
  /// @param variable  "t", "T", "p" or "gap"; abscissae increase. An abscissa given twice in t is a jump: the function
  /// has the second value there, and the first one as the limit from the left.
  /// @param period  only in t: the value at t is that at t modulo the period. The points lie in [0, period], the first
  /// at 0. If the values at both ends differ, there is a jump at each period.
  /// @throws std::invalid_argument if sizes differ or are zero, or abscissae do not increase or do not fit the period
  static Function table(const std::string& variable, std::vector<double> abscissae, std::vector<double> values,
                        std::optional<double> period = {});

  /// A function of the values of other functions; it depends on the variables that they depend on.
  /// @param text  identifies it: functions with equal texts must be equal
  static Function composed(const std::string& text, std::vector<Function> parts,
                           std::function<double(const std::vector<double>&)> value);

  /// A function that code of the caller evaluates, at many points at once where it can (batch()).
  /// @param text  identifies it: functions with equal texts must be equal @param variables  that it depends on
  static Function batched(const std::string& text, const std::vector<std::string>& variables,
                          std::shared_ptr<const BatchedFunction> evaluation);

  /// Index of the first abscissa that is not allowed after its predecessor in a table in this variable; the number of
  /// abscissae if all are allowed.
  static std::size_t misplaced_point(const std::string& variable, const std::vector<double>& abscissae);

  /// Why a table with these points (at least one) cannot have this period; empty if it can.
  static std::string period_error(const std::string& variable, const std::vector<double>& abscissae, double period);

  /// Value at a point; NaN and infinity are possible. Cost: a parsed expression, a search in a table, or none.
  double operator()(const Arguments& at) const;

  /// How to evaluate it at many points at once; null: only point by point.
  const BatchedFunction* batch() const;

  bool is_constant() const;
  bool is_zero() const;
  bool depends_on_position() const;     ///< x, y or z
  bool depends_on_time() const;         ///< t
  bool depends_on_temperature() const;  ///< T
  bool depends_on_strain() const;       ///< eps
  bool depends_on_contact() const;      ///< p or gap
  /// Times of the points of a table in t (jumps and changes of slope), increasing; for a periodic table those of the
  /// first period. Empty for other functions.
  std::vector<double> breakpoints() const;
  /// Likewise, with all repetitions of a periodic table up to `end`.
  std::vector<double> breakpoints(double end) const;
  /// The period of a periodic table in t; nullopt for other functions.
  std::optional<double> period() const;
  /// First and last abscissa of a table in this variable; nullopt for other functions.
  std::optional<Interval> table_range(const std::string& variable) const;
  /// The text given by the user. Functions with equal texts are equal.
  const std::string& text() const;

  struct Definition;

 private:
  explicit Function(std::shared_ptr<const Definition> definition) : definition_(std::move(definition)) {}
  std::shared_ptr<const Definition> definition_;
};

/// Their texts, separated by commas; equal for equal functions.
std::string texts(const std::vector<Function>& functions);

}  // namespace creepcontact
