#include "anderson_mixing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::creep {
namespace {

constexpr double dependent = 1e-10;  // of the largest: directions that add nothing
constexpr double far_off = 10;       // of the smallest residual so far

Eigen::Map<const Eigen::VectorXd> view(std::span<const double> values) {
  return {values.data(), static_cast<Index>(values.size())};
}

void lengthen(Eigen::VectorXd& values, Index size) {
  const Index before = values.size();
  values.conservativeResize(size);
  values.tail(size - before).setZero();
}

}  // namespace

void AndersonMixing::mix(std::span<const double> x, std::span<const double> f, std::span<double> next) {
  const Eigen::VectorXd residual = view(f) - view(x);
  const double size = std::sqrt(team_.sum(residual.squaredNorm()));
  if (size > far_off * smallest_) {  // kinks on the way: what the differences know no longer holds
    differences_.clear();
    has_last_ = false;
  }
  smallest_ = std::min(smallest_, size);
  if (has_last_) {
    for (Difference& difference : differences_) {
      lengthen(difference.f, residual.size());
      lengthen(difference.residual, residual.size());
    }
    lengthen(last_f_, residual.size());
    lengthen(last_residual_, residual.size());
  }
  if (std::exchange(has_last_, true)) {
    differences_.push_front({view(f) - last_f_, residual - last_residual_});
    if (differences_.size() > depth_) differences_.pop_back();
  }
  last_f_ = view(f);
  last_residual_ = residual;
  std::ranges::copy(f, next.begin());
  const auto n = static_cast<Index>(differences_.size());
  if (n == 0) return;
  Eigen::MatrixXd gram(n, n + 1);  // the last column: with the residual
  for (Index i = 0; i < n; ++i) {
    const Eigen::VectorXd& of = differences_[static_cast<std::size_t>(i)].residual;
    for (Index j = 0; j < n; ++j) gram(i, j) = of.dot(differences_[static_cast<std::size_t>(j)].residual);
    gram(i, n) = of.dot(residual);
  }
  team_.sum({gram.data(), static_cast<std::size_t>(gram.size())});
  Eigen::VectorXd scale(n);
  for (Index i = 0; i < n; ++i) scale[i] = gram(i, i) > 0 ? 1 / std::sqrt(gram(i, i)) : 0;
  const Eigen::MatrixXd scaled = scale.asDiagonal() * gram.leftCols(n) * scale.asDiagonal();
  const Eigen::VectorXd right = scale.cwiseProduct(gram.col(n));
  const Eigen::VectorXd weights = scale.cwiseProduct(Eigen::VectorXd(linalg::least_squares(scaled, right, dependent)));
  Eigen::Map<Eigen::VectorXd> into(next.data(), static_cast<Index>(next.size()));
  for (Index i = 0; i < n; ++i) into -= weights[i] * differences_[static_cast<std::size_t>(i)].f;
}

}  // namespace creepcontact::creep
