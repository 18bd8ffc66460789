#pragma once
/// Factorisations of several matrices.

#include <functional>
#include <span>

namespace creepcontact::linalg {

/// Calls factorize(i) for all i: side by side with one thread each where that is expected to be faster, else one after
/// the other with all threads.
/// @param entries  of the factors
/// @throws the first exception in the order of i, after those under way have ended
void for_each_factorization(std::span<const double> entries, const std::function<void(std::size_t i)>& factorize);

/// True if factors of so many entries are better computed side by side by so many threads.
bool side_by_side(std::span<const double> entries, int threads);

}  // namespace creepcontact::linalg
