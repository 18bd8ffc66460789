#pragma once
/// Uniaxial tests of a bar: creep at constant stress, or relaxation at constant length.

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "creepcontact/material/creep_law.hpp"

namespace creepcontact::material {

/// A test of a bar: stress, temperature, and whether it relaxes.
struct BarTest {
  double stress = 0;  ///< constant; of a relaxation test: at t = 0
  double temperature = 0;
  /// Infinite: constant stress. Finite: the length is held, and the stress is E (strain - creep strain).
  double young_modulus = std::numeric_limits<double>::infinity();

  bool relaxes() const { return young_modulus < std::numeric_limits<double>::infinity(); }
};

/// The bar at one time; strain along the bar.
struct BarState {
  double creep_strain = 0;
  double stress = 0;
};

/// The course of a test.
struct BarHistory {
  std::vector<BarState> states;  ///< at the first of the times asked for: those before rupture or a failure
  /// Time at which the damage is 0.99, or the rate grows without limit.
  std::optional<double> rupture;
  BarState last;        ///< at rupture, or at the last of the times
  bool failed = false;  ///< the laws gave no finite rates, or strains beyond 1e6
};

/// All laws together.
/// @param times  increasing, >= 0
/// Method: at constant stress the closed forms of the laws, if growth in one increment and in two are the same to a
/// tenth of `tolerance`. Otherwise the increments of the laws over the first 1e-4 of the shortest time (down to 1e-8 if
/// they are not exact, and in relaxation), then Rosenbrock's method with an error below `tolerance` per step, relative
/// to each unknown. The values between its steps are interpolated. Cost: some ten microseconds per step, some ten steps
/// per decade of time where the rate changes.
BarHistory bar_history(std::span<const std::shared_ptr<const CreepLaw>> laws, const BarTest& test,
                       std::span<const double> times, double tolerance = 1e-6);

/// The creep rate along the bar at t = 0, before any creep; infinite for laws with primary creep.
double initial_rate(std::span<const std::shared_ptr<const CreepLaw>> laws, const BarTest& test);

/// The creep rate along the bar at a time, with this creep strain so far, which hardening laws know.
/// @throws std::invalid_argument if a law knows more of its past than a strain, and the strain is not 0; or if it gives
/// no rate (CreepLaw::is_isochronous)
double rate_at(std::span<const std::shared_ptr<const CreepLaw>> laws, const BarTest& test, double time, double strain);

}  // namespace creepcontact::material
