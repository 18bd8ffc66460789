#pragma once
/// [random] of a study: keys of the configuration that are distributed instead of known.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/config/location.hpp"
#include "creepcontact/statistics/distribution.hpp"
#include "creepcontact/statistics/sampling.hpp"

namespace creepcontact::config {

/// A key with a distribution.
struct RandomKey {
  Reference key;
  statistics::Distribution distribution;
  std::string kind;  ///< of the distribution, as in the file: "lognormal"
  Location location = {};
  std::optional<double> fitted = {};  ///< found by a fit: what the base must have
};

/// The correlation of the normal scores of two keys: of their values, or of the logarithms of lognormal ones.
struct RandomCorrelation {
  std::vector<Reference> keys;  ///< two
  double value = 0;
  Location location = {};
};

/// [random]
struct Random {
  int samples = 0;
  statistics::SamplingMethod method = statistics::SamplingMethod::sobol;
  int seed = 1;
  std::vector<double> quantiles{0.05, 0.5, 0.95};
  std::vector<RandomKey> keys;
  std::vector<RandomCorrelation> correlations;
  Location location = {};
  std::vector<double> factor = {};  ///< lower Cholesky factor of the matrix of correlations; empty: independent keys

  std::size_t n_samples() const { return static_cast<std::size_t>(samples); }
};

/// Standard normal scores of all samples, sample by sample, one per key, with their correlations.
std::vector<double> scores_of(const Random& random);

/// The value of a key at a score, with 12 digits: so it is the same on machines whose libraries round differently.
double sampled_value(const RandomKey& key, double score);

/// The distribution in words: "normal, mean 3, deviation 0.2".
std::string description_of(const RandomKey& key);

}  // namespace creepcontact::config
