#pragma once
/// Points in a hypercube, as standard normal scores. Equal arguments give equal points on every machine.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "creepcontact/settings/enum_names.hpp"

namespace creepcontact::statistics {

enum class SamplingMethod { sobol, latin_hypercube, monte_carlo };
constexpr auto names_of(SamplingMethod) {
  return std::to_array<settings::EnumName<SamplingMethod>>({{"sobol", SamplingMethod::sobol},
                                                            {"latin_hypercube", SamplingMethod::latin_hypercube},
                                                            {"monte_carlo", SamplingMethod::monte_carlo}});
}

/// Row by row: point i is the entries [i * dimensions, (i + 1) * dimensions).
///
/// sobol: Sobol' sequence with the direction numbers of Joe and Kuo (SIAM J. Sci. Comput. 30, 2008), scrambled in the
/// manner of Owen by the hash of Laine and Karras as given by Burley (J. Comput. Graph. Tech. 9(4), 2020). The first
/// 2^m points have one in each of the 2^m strata of every coordinate.
/// latin_hypercube: McKay, Beckman and Conover (Technometrics 21, 1979): one point in each of `n` strata.
/// monte_carlo: independent points.
///
/// With sobol and monte_carlo the first points are the same for every n.
/// Precondition: 1 <= dimensions <= max_dimensions. Cost: some 50 ns per number.
std::vector<double> uniform_points(SamplingMethod method, std::uint64_t seed, std::size_t n, std::size_t dimensions);
std::vector<double> normal_points(SamplingMethod method, std::uint64_t seed, std::size_t n, std::size_t dimensions);

inline constexpr std::size_t max_dimensions = 1000;

/// The lower Cholesky factor of a matrix of correlations, row by row; empty if the matrix is not positive definite.
/// @param matrix  row by row, symmetric
std::vector<double> correlation_factor(const std::vector<double>& matrix, std::size_t dimensions);

/// Replaces each point z by L z. @param factor  of correlation_factor()
void correlate(std::vector<double>& points, const std::vector<double>& factor, std::size_t dimensions);

}  // namespace creepcontact::statistics
