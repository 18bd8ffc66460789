#pragma once
/// Values of a document in other units: numbers, expressions, tables and lists of them.

#include <toml++/toml.h>

#include <functional>
#include <string>

#include "creepcontact/base/unit_powers.hpp"

namespace creepcontact::config {

class UnitConversion {
 public:
  /// The value of another constant of the same law by its place, in the units from which is converted; a constant with
  /// an exponent does not depend on the units itself. Null: not given.
  using Constants = std::function<const toml::node*(std::size_t)>;

  explicit UnitConversion(const UnitChange& change) : change_(change) {}

  /// Appends the converted value. A number whose exponents vary with the temperature becomes an expression.
  void append(const toml::node& value, const UnitPowers& dimension, const Constants& constants,
              toml::array& into) const;
  /// Replaces the value of a key.
  void replace(toml::table& table, std::string_view key, const UnitPowers& dimension,
               const Constants& constants = {}) const;
  /// An expression in variables of the new units with a value in the old ones.
  std::string expression(const std::string& text) const;

 private:
  struct Factor {
    double number = 1;
    std::string text = {};  ///< "(...)*(...)"; empty: none
    bool is_one() const { return number == 1 && text.empty(); }
  };

  Factor factor(const UnitPowers& dimension, const Constants& constants, std::size_t element) const;
  void append(const toml::node& value, const UnitPowers& dimension, const Constants& constants, std::size_t element,
              toml::array& into) const;
  double number(double value, const UnitPowers& dimension, const Factor& by) const;
  /// Text of a value that may be a number, an expression or a table, in variables of the new units.
  std::string text_of(const toml::node& value) const;

  UnitChange change_;
};

}  // namespace creepcontact::config
