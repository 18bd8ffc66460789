#include "creepcontact/statistics/sampling.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <boost/random/sobol.hpp>
#include <numeric>
#include <random>

#include "creepcontact/statistics/distribution.hpp"

namespace creepcontact::statistics {
namespace {

/// Finaliser of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

std::uint32_t reversed(std::uint32_t x) {
  x = ((x >> 1) & 0x55555555U) | ((x & 0x55555555U) << 1);
  x = ((x >> 2) & 0x33333333U) | ((x & 0x33333333U) << 2);
  x = ((x >> 4) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4);
  return __builtin_bswap32(x);
}

/// Burley (2020), listing 2 and 3: each digit is flipped by a hash of the digits before it.
std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
  x = reversed(x);
  x += seed;
  x ^= x * 0x6c50b47cU;
  x ^= x * 0xb82f1e52U;
  x ^= x * 0xc7afe638U;
  x ^= x * 0x8d22f6e6U;
  return reversed(x);
}

/// The middle of one of 2^32 cells: never 0 or 1.
double in_unit_interval(std::uint32_t digits) {
  return (static_cast<double>(digits) + 0.5) * 0x1p-32;
}

/// The standard fixes this engine, but not its distributions.
double uniform_number(std::mt19937_64& engine) {
  return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53;
}

std::size_t below(std::size_t n, std::mt19937_64& engine) {
  return std::min(n - 1, static_cast<std::size_t>(uniform_number(engine) * static_cast<double>(n)));
}

std::vector<double> sobol_points(std::uint64_t seed, std::size_t n, std::size_t dimensions) {
  std::vector<std::uint32_t> seeds(dimensions);
  for (std::size_t d = 0; d < dimensions; ++d) seeds[d] = static_cast<std::uint32_t>(mixed(seed + mixed(d)));
  boost::random::sobol_engine<std::uint_least32_t, 32> engine(dimensions);
  std::vector<double> points(n * dimensions);
  for (std::size_t i = 0; i < points.size(); ++i) {
    // The engine leaves out the first point of the sequence, all of whose digits are 0.
    const std::uint32_t digits = i < dimensions ? 0 : engine();
    points[i] = in_unit_interval(scrambled(digits, seeds[i % dimensions]));
  }
  return points;
}

std::vector<double> latin_points(std::uint64_t seed, std::size_t n, std::size_t dimensions) {
  std::vector<double> points(n * dimensions);
  std::vector<std::size_t> strata(n);
  for (std::size_t d = 0; d < dimensions; ++d) {
    std::mt19937_64 engine(mixed(seed + mixed(d)));
    std::iota(strata.begin(), strata.end(), std::size_t{0});
    for (std::size_t i = n; i > 1; --i) std::swap(strata[i - 1], strata[below(i, engine)]);
    for (std::size_t i = 0; i < n; ++i)
      points[i * dimensions + d] = (static_cast<double>(strata[i]) + uniform_number(engine)) / static_cast<double>(n);
  }
  return points;
}

std::vector<double> random_points(std::uint64_t seed, std::size_t n, std::size_t dimensions) {
  std::mt19937_64 engine(mixed(seed));
  std::vector<double> points(n * dimensions);
  for (double& value : points) value = uniform_number(engine);
  return points;
}

}  // namespace

std::vector<double> uniform_points(SamplingMethod method, std::uint64_t seed, std::size_t n, std::size_t dimensions) {
  switch (method) {
    case SamplingMethod::latin_hypercube:
      return latin_points(seed, n, dimensions);
    case SamplingMethod::monte_carlo:
      return random_points(seed, n, dimensions);
    case SamplingMethod::sobol:
      break;
  }
  return sobol_points(seed, n, dimensions);
}

std::vector<double> normal_points(SamplingMethod method, std::uint64_t seed, std::size_t n, std::size_t dimensions) {
  std::vector<double> points = uniform_points(method, seed, n, dimensions);
  for (double& value : points) value = normal_score(value);
  return points;
}

std::vector<double> correlation_factor(const std::vector<double>& matrix, std::size_t dimensions) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto n = static_cast<Eigen::Index>(dimensions);
  const Eigen::LLT<RowMajor> factor(Eigen::Map<const RowMajor>(matrix.data(), n, n));
  constexpr double least = 1e-6;  // of the factor's diagonal: less is a sum of the keys before it
  if (factor.info() != Eigen::Success || !(factor.matrixLLT().diagonal().minCoeff() > least)) return {};
  const RowMajor lower = factor.matrixL();
  return {lower.data(), lower.data() + lower.size()};
}

void correlate(std::vector<double>& points, const std::vector<double>& factor, std::size_t dimensions) {
  for (std::size_t begin = 0; begin < points.size(); begin += dimensions)
    for (std::size_t row = dimensions; row-- > 0;) {  // a row needs the entries before it alone
      double sum = 0;
      for (std::size_t column = 0; column <= row; ++column)
        sum += factor[row * dimensions + column] * points[begin + column];
      points[begin + row] = sum;
    }
}

}  // namespace creepcontact::statistics
