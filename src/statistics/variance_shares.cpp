#include "creepcontact/statistics/variance_shares.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>

#include "creepcontact/statistics/distribution.hpp"

namespace creepcontact::statistics {
namespace {

/// Inputs of a term; the same one twice: of degree 2 in it.
struct Term {
  std::vector<std::size_t> inputs;
};

std::vector<Term> terms_of(std::size_t inputs, int degree, bool with_products) {
  std::vector<Term> terms{{}};
  for (std::size_t i = 0; i < inputs; ++i) terms.push_back({{i}});
  for (std::size_t i = 0; degree > 1 && i < inputs; ++i) terms.push_back({{i, i}});
  for (std::size_t i = 0; with_products && i < inputs; ++i)
    for (std::size_t j = 0; j < i; ++j) terms.push_back({{j, i}});
  return terms;
}

struct Polynomials {
  double first, second;
};

Polynomials polynomials(Basis basis, double score) {
  if (basis == Basis::normal_score) return {score, (score * score - 1) / std::sqrt(2.0)};
  const double x = 2 * normal_probability(score) - 1;
  return {std::sqrt(3.0) * x, std::sqrt(5.0) * (1.5 * x * x - 0.5)};
}

/// Least squares by normal equations: the columns are nearly orthonormal.
std::optional<VarianceShares> regression(const std::vector<std::vector<Polynomials>>& points,
                                         const Eigen::VectorXd& results, const std::vector<Term>& terms,
                                         std::size_t inputs) {
  const auto n = static_cast<Eigen::Index>(points.size()), m = static_cast<Eigen::Index>(terms.size());
  Eigen::MatrixXd columns(n, m);
  for (Eigen::Index row = 0; row < n; ++row)
    for (Eigen::Index column = 0; column < m; ++column) {
      const std::vector<Polynomials>& point = points[static_cast<std::size_t>(row)];
      const std::vector<std::size_t>& of = terms[static_cast<std::size_t>(column)].inputs;
      if (of.empty())
        columns(row, column) = 1;
      else if (of.size() == 2 && of[0] == of[1])
        columns(row, column) = point[of[0]].second;
      else
        columns(row, column) = point[of[0]].first * (of.size() == 2 ? point[of[1]].first : 1);
    }
  const Eigen::LLT<Eigen::MatrixXd> normal(columns.transpose() * columns);
  if (normal.info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXd coefficients = normal.solve(columns.transpose() * results);
  const Eigen::VectorXd residuals = results - columns * coefficients;
  const Eigen::VectorXd leverage = columns.cwiseProduct(normal.solve(columns.transpose()).transpose()).rowwise().sum();
  const double variance = (results.array() - results.mean()).square().mean();
  if (!(variance > 0)) return std::nullopt;
  VarianceShares shares{std::vector<double>(inputs, 0.0)};
  for (Eigen::Index i = 1; i < m; ++i) {
    const std::vector<std::size_t>& of = terms[static_cast<std::size_t>(i)].inputs;
    const double share = coefficients[i] * coefficients[i];
    (of.front() == of.back() ? shares.first_order[of.front()] : shares.interactions) += share;
  }
  constexpr double least = 1e-12;  // a point that alone decides a coefficient is not predicted by the others
  const Eigen::ArrayXd left_out = residuals.array() / (1 - leverage.array()).max(least);
  shares.quality = 1 - left_out.square().mean() / variance;
  // Of the true distribution of the inputs, not of the sample: the sum of squares, and what the polynomials leave.
  const double whole = coefficients.tail(m - 1).squaredNorm() + left_out.square().mean();
  for (double& share : shares.first_order) share /= whole;
  shares.interactions /= whole;
  return shares;
}

}  // namespace

VarianceShares variance_shares(const std::vector<double>& scores, const std::vector<Basis>& bases,
                               const std::vector<double>& results) {
  std::vector<std::vector<Polynomials>> points;
  std::vector<double> known;
  for (std::size_t row = 0; row < results.size(); ++row) {
    if (!std::isfinite(results[row])) continue;
    std::vector<Polynomials>& point = points.emplace_back();
    for (std::size_t i = 0; i < bases.size(); ++i)
      point.push_back(polynomials(bases[i], scores[row * bases.size() + i]));
    known.push_back(results[row]);
  }
  VarianceShares best;
  const Eigen::Map<const Eigen::VectorXd> values(known.data(), static_cast<Eigen::Index>(known.size()));
  constexpr std::size_t most_terms = 150;
  const auto attempt = [&](int degree, bool with_products) {
    const std::vector<Term> terms = terms_of(bases.size(), degree, with_products);
    if (2 * terms.size() > known.size() || terms.size() > most_terms) return;
    auto shares = regression(points, values, terms, bases.size());
    if (!shares || (!best.first_order.empty() && shares->quality <= best.quality)) return;
    best = *shares;
    best.degree = degree;
  };
  attempt(1, false);
  attempt(2, false);
  if (bases.size() > 1) attempt(2, true);
  return best;
}

}  // namespace creepcontact::statistics
