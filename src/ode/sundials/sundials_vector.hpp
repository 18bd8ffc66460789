#pragma once
/// N_Vector of SUNDIALS with hot operations of our own: vectorised, and shared among the OpenMP threads if long.
/// The state is up to 15 times as long as the displacement; the packaged SUNDIALS is compiled without optimisation,
/// so that both its serial and its OpenMP vector would be the second bottleneck after the elastic solves.
/// Operations on whole vectors are delayed until a number or a pointer to the entries is asked for (DelayedOperations);
/// so only N_VGetArrayPointer gives the entries, not the macros of the serial vector.

#include <sundials/sundials_nvector.h>

#include <cstddef>
#include <memory>
#include <span>

#include "creepcontact/base/team.hpp"

namespace creepcontact::ode {

struct VectorDeleter {
  void operator()(N_Vector v) const { N_VDestroy(v); }
};
using Vector = std::unique_ptr<_generic_N_Vector, VectorDeleter>;

/// Zero vector of `size` entries here, one if that is none; norms, products and the length are those of all that the
/// members of the team have. The integrators clone theirs from it, operations included. Collective.
/// @param team  must outlive the vector and its clones
Vector make_vector(const Team& team, std::size_t size, SUNContext context);

/// The first `size` entries of v, which v keeps owning, as they are until the next operation on v or a clone of it.
inline std::span<double> view(N_Vector v, std::size_t size) {
  return {N_VGetArrayPointer(v), size};
}

}  // namespace creepcontact::ode
