#pragma once
/// Which of several independent inputs the variance of a result comes from (Sobol' indices), estimated from a sample.

#include <cstddef>
#include <vector>

namespace creepcontact::statistics {

/// Polynomials that are orthonormal over an input: Hermite's of a normal score, or Legendre's of its probability, for
/// inputs whose own values are in proportion to one of the two.
enum class Basis { normal_score, probability };

struct VarianceShares {
  std::vector<double> first_order;  ///< per input: by it alone; empty if the sample is too small
  double interactions = 0;          ///< by pairs of inputs, beyond each alone
  /// 1 - (mean square error of predicting each point from the others)/variance: 1 is perfect, and without a value near
  /// 1 the shares mean little. At most 1, may be negative.
  double quality = 0;
  int degree = 0;  ///< of the polynomials that were taken
};

/// Polynomial chaos: regression of the results on polynomials of degree 1, of degree 2 without, and of degree 2 with
/// products of two inputs (Sudret, Reliab. Eng. Syst. Saf. 93, 2008); that which predicts left-out points best is taken
/// among those with at most half as many terms as there are points.
/// @param scores   independent standard normal scores, row by row, one row per result
/// @param bases    one per input
/// @param results  NaN: not known, left out
/// Cost: n m^2 for m terms.
VarianceShares variance_shares(const std::vector<double>& scores, const std::vector<Basis>& bases,
                               const std::vector<double>& results);

}  // namespace creepcontact::statistics
