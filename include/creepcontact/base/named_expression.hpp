#pragma once
/// Expressions in variables that have the user's names, such as those of probes; numbers and conditions (muParser).

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace creepcontact {

/// A name in an expression that is not a variable.
struct UnknownName : std::invalid_argument {
  UnknownName(const std::string& message, std::string unknown)
      : std::invalid_argument(message), name(std::move(unknown)) {}
  std::string name;
};

/// An expression in the language of Function::expression(). Immutable but for the parser: one thread at a time may
/// evaluate it; copies share the parser.
class NamedExpression {
 public:
  /// @param names  of the variables; those that can_be_variable() refuses cannot be used in the text
  /// @throws UnknownName, or std::invalid_argument with the message of the parser
  NamedExpression(const std::string& text, const std::vector<std::string>& names);

  /// Which of the names the text uses: indices, ascending.
  const std::vector<std::size_t>& used() const;
  /// @param values  one per name; those that are not used() are ignored
  /// @returns the value; of a condition 1 or 0
  double operator()(std::span<const double> values) const;

  /// True for letters, digits and underscores, not beginning with a digit, other than the names of functions and
  /// constants.
  static bool can_be_variable(const std::string& name);

 private:
  struct Parsed;
  std::shared_ptr<Parsed> parsed_;
};

}  // namespace creepcontact
