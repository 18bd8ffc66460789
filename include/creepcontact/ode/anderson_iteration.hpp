#pragma once
/// The fixed-point iteration y = G(y) with Anderson acceleration, by SUNDIALS KINSOL.

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <span>

#include "creepcontact/base/team.hpp"

namespace creepcontact::ode {

/// The next iterate is the combination of the last images whose residuals G(y) - y combine to the least norm; the
/// plain iteration takes the last image alone. Where plain iterations converge it needs fewer, and it goes on where
/// the fastest modes are amplified. Memory: 12 + 3 depth vectors.
/// Source: Anderson (1965), as in SUNDIALS.
class AndersonIteration {
 public:
  /// image = G(y); may throw. @returns true to end the iteration, converged or not
  using Step = std::function<bool(std::span<const double> y, std::span<double> image)>;

  /// @param depth  number of earlier residuals combined, at least 1; no more than `size` are used
  /// @param size  of the part of y that this member of the team has
  /// @param trust  an iterate farther from the last image than so many changes |G(y) - y| begins the acceleration anew
  AndersonIteration(std::size_t size, int depth, double trust = std::numeric_limits<double>::infinity(),
                    const Team& team = serial_team());
  ~AndersonIteration();
  AndersonIteration(const AndersonIteration&) = delete;
  AndersonIteration& operator=(const AndersonIteration&) = delete;

  /// Iterates from y until a step ends it; y is then the image of the last argument.
  /// @throws what the step throws, as it is
  void run(std::span<double> y, const Step& step);

 private:
  struct Kinsol;
  std::unique_ptr<Kinsol> kinsol_;
};

}  // namespace creepcontact::ode
