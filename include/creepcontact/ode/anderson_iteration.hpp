#pragma once
/// The fixed-point iteration y = G(y) with Anderson acceleration (SUNDIALS KINSOL).

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <span>

#include "creepcontact/base/team.hpp"

namespace creepcontact::ode {

/// The next iterate is the linear combination of the last images G(y) for which the combined residual G(y) - y has the
/// smallest norm; the plain iteration takes the last image alone. It needs fewer iterations than the plain one, and can
/// converge where the plain one amplifies the fastest modes. Collective.
/// Memory: 12 + 3 depth vectors. Source: Anderson (1965), as in SUNDIALS.
class AndersonIteration {
 public:
  /// image = G(y); may throw. @returns true to end the iteration, converged or not
  using Step = std::function<bool(std::span<const double> y, std::span<double> image)>;

  /// @param size  of the part of y held by this member of the team
  /// @param depth  earlier residuals combined, at least 1; at most `size` are used
  /// @param trust  if an iterate is farther from the last image than this multiple of |G(y) - y|, the acceleration
  /// restarts
  AndersonIteration(std::size_t size, int depth, double trust = std::numeric_limits<double>::infinity(),
                    const Team& team = serial_team());
  ~AndersonIteration();
  AndersonIteration(const AndersonIteration&) = delete;
  AndersonIteration& operator=(const AndersonIteration&) = delete;

  /// Iterates from y until a step returns true; y is then the image of the last argument.
  /// @throws what the step throws, unchanged
  void run(std::span<double> y, const Step& step);

 private:
  struct Kinsol;
  std::unique_ptr<Kinsol> kinsol_;
};

}  // namespace creepcontact::ode
