#pragma once
/// The fixed-point iteration y = G(y) with Anderson acceleration, by KINSOL.

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <sundials/sundials_context.hpp>
#include <vector>

#include "convergence_watch.hpp"
#include "sundials_vector.hpp"

namespace creepcontact::ode {

/// The next iterate is the combination of the last images whose residuals G(y) - y combine to the least norm; the
/// plain iteration takes the last image alone. Where plain iterations converge it needs fewer, and it goes on where
/// the fastest modes are amplified. Memory: 12 + 3 depth vectors.
/// Source: Anderson (1965), as in SUNDIALS.
class AndersonIteration {
 public:
  /// image = G(y); may throw
  using Map = std::function<void(std::span<const double> y, std::span<double> image)>;

  /// @param depth  number of earlier residuals combined, at least 1; no more than `size` are used
  AndersonIteration(std::size_t size, int depth, int max_iterations, Map map);
  AndersonIteration(const AndersonIteration&) = delete;
  AndersonIteration& operator=(const AndersonIteration&) = delete;

  /// Iterates from y until the watch ends it; y is then the image of the map's last argument.
  /// @throws what the map throws, as it is
  void run(std::span<double> y, ConvergenceWatch& watch);

 private:
  struct MemoryDeleter {
    void operator()(void* memory) const;
  };
  static int evaluate(N_Vector y, N_Vector image, void* self) noexcept;  // a KINSysFn
  bool next(std::span<const double> y, std::span<double> image);

  Map map_;
  sundials::Context context_;  // outlives whatever is made from it
  Vector iterate_;             ///< KINSOL's y, padded to one entry if there is none
  Vector ones_;
  std::unique_ptr<void, MemoryDeleter> memory_;
  std::vector<double> image_;  ///< G of the map's last argument
  ConvergenceWatch* watch_ = nullptr;
  bool plain_ = true;  ///< the next argument is none of the acceleration's
  std::exception_ptr failure_;
};

}  // namespace creepcontact::ode
