#include "log_adams_history.hpp"

#include <algorithm>
#include <cstddef>

namespace creepcontact::ode {

namespace {
/// Gauss quadrature with 6 points, on pieces of at most length 1 in s: what it leaves out is rounding.
constexpr std::array<double, 6> gauss_points{-0.9324695142031521, -0.6612093864662645, -0.2386191860831969,
                                             0.2386191860831969,  0.6612093864662645,  0.9324695142031521};
constexpr std::array<double, 6> gauss_weights{0.1713244923791704, 0.3607615730481386, 0.4679139345726910,
                                              0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
}  // namespace

LogAdamsHistory::Row LogAdamsHistory::stretch(double s) const {
  Row factors{1};
  for (std::size_t j = 1; j < static_cast<std::size_t>(count); ++j)
    factors[j] = factors[j - 1] * (s - nodes[j - 1]) / (nodes[0] - nodes[j]);
  return factors;
}

/// Terms: products of the first (s - zero_i) / scale_i.
LogAdamsHistory::Row LogAdamsHistory::integrals(double from, double to, double with_power, const Row& zeros,
                                                const Row& scales, int terms) const {
  Row sums{};
  const int n_pieces = std::max(1, static_cast<int>(std::ceil(std::abs(to - from))));
  const double half = 0.5 * (to - from) / n_pieces;
  for (int piece = 0; piece < n_pieces; ++piece)
    for (std::size_t q = 0; q < gauss_points.size(); ++q) {
      const double s = from + half * (2 * piece + 1 + gauss_points[q]);
      double term = half * gauss_weights[q] * clock.unit * std::exp((1 - with_power) * s);  // dt = unit exp(s) ds
      for (std::size_t j = 0; j < static_cast<std::size_t>(terms); ++j) {
        sums[j] += term;
        term *= (s - zeros[j]) / scales[j];
      }
    }
  return sums;
}

LogAdamsHistory::Row LogAdamsHistory::step_integrals(double s, int terms) const {
  Row scales{};
  std::ranges::transform(nodes, scales.begin(), [s](double node) { return s - node; });
  return integrals(nodes[0], s, power, nodes, scales, terms);
}

LogAdamsHistory::Row LogAdamsHistory::last_step_integrals(double other_power, int terms) const {
  LogAdamsHistory before = *this;
  std::copy(nodes.begin() + 1, nodes.end(), before.nodes.begin());
  before.power = other_power;
  return before.step_integrals(nodes[0], terms);
}

LogAdamsHistory::Row LogAdamsHistory::dense_integrals(double s) const {
  Row scales{};
  scales.fill(1);
  for (std::size_t j = 1; j < static_cast<std::size_t>(count); ++j) scales[j - 1] = nodes[0] - nodes[j];
  return integrals(nodes[0], s, power, nodes, scales, count);
}

void LogAdamsHistory::add(double s) {
  std::copy_backward(nodes.begin(), nodes.end() - 1, nodes.end());
  nodes[0] = s;
}

LogAdamsHistory::Matrix LogAdamsHistory::moved(const Row& to, double power_change) const {
  Matrix matrix{};
  const auto n = static_cast<std::size_t>(count);
  for (std::size_t column = 0; column < n; ++column) {
    Row values{};
    for (std::size_t i = 0; i < n; ++i) {
      values[i] = std::exp(power_change * to[i]);
      for (std::size_t j = 0; j < column; ++j) values[i] *= (to[i] - nodes[j]) / (nodes[0] - nodes[j + 1]);
    }
    for (std::size_t j = 1; j < n; ++j)
      for (std::size_t i = n - 1; i >= j; --i) values[i] = (values[i] - values[i - 1]) / (to[i] - to[i - j]);
    double scale = 1;
    for (std::size_t i = 0; i < n; ++i) {
      matrix[i][column] = values[i] * scale;
      if (i + 1 < n) scale *= to[0] - to[i + 1];
    }
  }
  return matrix;
}

}  // namespace creepcontact::ode
