#include "verification/reference/stiff_integrator.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace creepcontact::reference {

StiffIntegrator::StiffIntegrator(Rate rate, Jacobian jacobian, Eigen::VectorXd y, double tolerance)
    : rate_(std::move(rate)), jacobian_(std::move(jacobian)), y_(std::move(y)), tolerance_(tolerance) {
  const double speed = rate_(y_).lpNorm<Eigen::Infinity>();
  step_ = speed > 0 ? 1e-3 * y_.lpNorm<Eigen::Infinity>() / speed : 1.0;
}

const Eigen::VectorXd& StiffIntegrator::advance(double end) {
  while (time_ < end) {
    const bool last = time_ + step_ >= end;
    const double h = last ? end - time_ : step_;
    const auto [next, error] = extrapolate(h);
    const double factor = 0.9 * std::pow(error + 1e-10, -1.0 / columns);
    if (!(error <= 1)) {  // also where the trial overflowed
      step_ = h * (std::isfinite(error) ? std::max(0.2, factor) : 0.2);
      if (!(step_ > 1e-14 * end)) throw std::runtime_error("reference integration: the step vanishes");
      continue;
    }
    y_ = next;
    time_ = last ? end : time_ + h;
    if (!last || factor < 1) step_ = h * std::min(4.0, factor);
    ++steps_;
  }
  return y_;
}

StiffIntegrator::Trial StiffIntegrator::extrapolate(double h) const {
  const Eigen::MatrixXd jacobian = jacobian_(y_);
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(y_.size(), y_.size());
  std::array<Eigen::VectorXd, columns> row;  // Neville's scheme; row[m] has order m + 1
  for (int j = 0; j < columns; ++j) {
    const double part = h / (j + 1);
    const Eigen::PartialPivLU<Eigen::MatrixXd> factor(unit - part * jacobian);
    Eigen::VectorXd y = y_;
    for (int i = 0; i <= j; ++i) y += factor.solve(part * rate_(y));
    for (int m = 0; m < j; ++m) {
      const double ratio = double(j + 1) / (j - m);
      Eigen::VectorXd better = y + (y - row[m]) / (ratio - 1);
      row[m] = std::exchange(y, std::move(better));
    }
    row[j] = std::move(y);
  }
  const double size = std::max(y_.lpNorm<Eigen::Infinity>(), row[columns - 1].lpNorm<Eigen::Infinity>());
  const double error = (row[columns - 1] - row[columns - 2]).lpNorm<Eigen::Infinity>();
  return {row[columns - 1], row[columns - 1].allFinite() ? error / (tolerance_ * size) : HUGE_VAL};
}

}  // namespace creepcontact::reference
