#pragma once
/// Interface of an accelerated fixed-point iteration x = g(x), supplied to the Schwarz iteration by the caller.

#include <functional>
#include <memory>
#include <span>

namespace creepcontact::contact {

/// An iteration for vectors of one size.
class FixedPointSolver {
 public:
  /// image = g(x). @returns true to end the iteration
  using Step = std::function<bool(std::span<const double> x, std::span<double> image)>;

  virtual ~FixedPointSolver() = default;
  /// Iterates from x until a step returns true; x is then the image of the last argument.
  virtual void solve(std::span<double> x, const Step& step) = 0;
};

/// Makes a solver for vectors of this size.
using FixedPointFactory = std::function<std::unique_ptr<FixedPointSolver>(std::size_t size)>;

}  // namespace creepcontact::contact
