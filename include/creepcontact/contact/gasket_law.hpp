#pragma once
/// Pressure of a gasket over its closure: loading curves, and how it unloads from the largest closure it has had.

#include <vector>

#include "creepcontact/contact/solver/closure_curve.hpp"

namespace creepcontact::contact {

/// A measured curve; both lists are of one length.
struct GasketCurve {
  std::vector<double> closure;   ///< [length], increasing
  std::vector<double> pressure;  ///< [stress], increasing from 0
};

/// How a gasket unloads: along straight lines, along measured curves, or (both empty) along its loading curve.
struct GasketUnloading {
  /// Unloading moduli E_G(Q) of EN 13555: pressures at which unloading begins, increasing, and the moduli from there.
  /// Their slope is modulus / thickness; it is linear in the largest closure between them, constant beyond.
  std::vector<double> from, modulus;
  /// Each begins at its residual closure with pressure 0 and ends on the loading curve.
  std::vector<GasketCurve> curves;

  bool empty() const { return from.empty() && curves.empty(); }
};

/// The curves of a gasket at one temperature.
struct GasketData {
  double temperature = 0;
  GasketCurve loading;
  GasketUnloading unloading;
};

/// Immutable. At a largest closure m the gasket follows its loading curve from m on. Below m it follows
///   p = P(m) r(s),   s = (c - c_res)/(m - c_res),
/// where the shape r and the residual closure c_res/m are linear in m between the curves given, so that unloading
/// curves never cross; both are linear in the temperature at constant s and m. Pressure is zero below c_res.
class GasketLaw {
 public:
  /// @param thickness  > 0, uncompressed @param data  at least one; temperatures increase; all with or all without
  /// unloading @throws std::invalid_argument naming the points, for lists that do not increase, curves that do not
  /// begin at pressure 0, unloading above the loading curve and unloading curves that do not end on it
  GasketLaw(double thickness, std::vector<GasketData> data);
  /// A spring: the curve for all histories and temperatures, of thickness 1. It pulls if its first pressure is
  /// negative.
  /// @throws std::invalid_argument for a curve that does not increase
  static GasketLaw spring(GasketCurve curve);

  double thickness() const { return thickness_; }
  /// True of a spring that carries tension.
  bool pulls() const { return pulls_; }
  /// Pressure over closure after a largest closure. @param temperature  of the gasket; beyond those given the nearest
  ClosureCurve curve(double largest, double temperature) const;
  /// The closure at which the first of the loading curves ends, beyond which they are extrapolated; infinity for a
  /// line.
  double last_closure() const;
  /// True if it depends on the largest closure.
  bool has_history() const { return !data_.front().unloading.empty(); }
  const std::vector<GasketData>& data() const { return data_; }

 private:
  GasketLaw() = default;

  struct Unloading;  // from one largest closure
  Unloading unloading(const GasketData& at, double largest) const;
  void check(const GasketData& of) const;

  double thickness_ = 1;
  std::vector<GasketData> data_;
  bool pulls_ = false;
};

}  // namespace creepcontact::contact
