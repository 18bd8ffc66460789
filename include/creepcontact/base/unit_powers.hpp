#pragma once
/// Dimensions of constants in terms of the units of a model, and what a change of these units does to their numbers.

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>

namespace creepcontact {

enum class BaseUnit {
  stress,
  time,
  length,
  degree,      ///< of temperature differences
  temperature  ///< of temperatures, whose zero may change too; alone and to the power of 1
};

/// An exponent of a unit: a number, or a number times another constant of the same law or its reciprocal. A constant
/// that is a list without values counts as 1.
struct UnitExponent {
  constexpr UnitExponent(double given) : number(given) {}  // NOLINT(google-explicit-constructor): a number is one
  /// @param place  enumerator of the other constant
  template <class Constant>
  requires std::is_enum_v<Constant>
  constexpr UnitExponent(Constant place)  // NOLINT(google-explicit-constructor): a constant is an exponent
      : constant(static_cast<std::size_t>(place)) {}
  constexpr UnitExponent operator-() const {
    UnitExponent result = *this;
    result.number = -number;
    return result;
  }
  /// It counts only while another constant is zero.
  template <class Constant>
  requires std::is_enum_v<Constant>
  constexpr UnitExponent unless(Constant place) const {
    UnitExponent result = *this;
    result.exclusive = static_cast<std::size_t>(place);
    return result;
  }

  double number = 1;
  std::optional<std::size_t> constant = {};   ///< place of the other constant
  bool is_reciprocal = false;                 ///< of the other constant
  std::optional<std::size_t> exclusive = {};  ///< see unless()
};

/// 1/(another constant of the law)
template <class Constant>
requires std::is_enum_v<Constant>
constexpr UnitExponent reciprocal(Constant place) {
  UnitExponent result = place;
  result.is_reciprocal = true;
  return result;
}

struct UnitPower {
  BaseUnit unit = BaseUnit::stress;
  UnitExponent exponent = 1.0;
};

/// A product of powers of units, such as 1/(time stress^n). It has no default: whoever declares a constant says it.
class UnitPowers {
 public:
  static constexpr UnitPowers none() { return {}; }
  static constexpr UnitPowers of(BaseUnit unit, UnitExponent exponent = 1.0) {
    UnitPowers result;
    result.all_[result.size_++] = {unit, exponent};
    return result;
  }
  constexpr std::span<const UnitPower> powers() const { return {all_.data(), size_}; }
  /// A temperature, not a difference of temperatures.
  constexpr bool is_temperature() const { return size_ == 1 && all_[0].unit == BaseUnit::temperature; }

  friend constexpr UnitPowers operator*(UnitPowers a, const UnitPowers& b) {
    for (const UnitPower& power : b.powers()) {
      if (a.size_ == a.all_.size()) throw std::length_error("too many powers of units");
      a.all_[a.size_++] = power;
    }
    return a;
  }
  friend constexpr UnitPowers operator/(const UnitPowers& a, UnitPowers b) {
    for (UnitPower& power : b.all_) power.exponent = -power.exponent;
    return a * b;
  }

 private:
  constexpr UnitPowers() = default;
  std::array<UnitPower, 6> all_{};
  std::size_t size_ = 0;
};

/// Words for dimensions: unit::per_time / unit::pow(unit::stress, n).
namespace unit {

inline constexpr UnitPowers none = UnitPowers::none();
inline constexpr UnitPowers stress = UnitPowers::of(BaseUnit::stress);
inline constexpr UnitPowers time = UnitPowers::of(BaseUnit::time);
inline constexpr UnitPowers length = UnitPowers::of(BaseUnit::length);
inline constexpr UnitPowers degree = UnitPowers::of(BaseUnit::degree);
inline constexpr UnitPowers temperature = UnitPowers::of(BaseUnit::temperature);
inline constexpr UnitPowers per_stress = none / stress;
inline constexpr UnitPowers per_time = none / time;
inline constexpr UnitPowers per_degree = none / degree;

/// @param of  one of the units above
constexpr UnitPowers pow(const UnitPowers& of, UnitExponent exponent) {
  return UnitPowers::of(of.powers()[0].unit, exponent);
}

}  // namespace unit

/// From one set of units to another: new number = factor * old number.
struct UnitChange {
  double stress = 1, time = 1, length = 1;
  double degree = 1, zero = 0;  ///< new temperature = degree * old temperature + zero

  double of(BaseUnit unit) const;
};

/// Returns the factor on the number of a constant; for a temperature that of the degree alone.
/// @param constant  value of another constant of the law by its place
double factor(const UnitPowers& dimension, const UnitChange& change,
              const std::function<double(std::size_t)>& constant);

}  // namespace creepcontact
