#include "creepcontact/heat/rate_form.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"

namespace creepcontact::heat {
namespace {

constexpr double rounding = 1e-14;   // of solutions with C, which must not depend on what has been factored
constexpr int most_gradients = 200;  // of conjugate gradients
constexpr double difference = 1e-4;  // of the largest temperature, pressure and gap, in central differences
constexpr double same_gamma = 1.25;

using Vector = Eigen::VectorXd;
using ConstMap = Eigen::Map<const Vector>;
using Map = Eigen::Map<Vector>;

ConstMap vector(std::span<const double> values) {
  return {values.data(), std::ssize(values)};
}
Map vector(std::span<double> values) {
  return {values.data(), std::ssize(values)};
}

double largest(std::span<const double> values) {
  return values.empty() ? 0 : vector(values).cwiseAbs().maxCoeff();
}

/// base + factor change, not below zero
std::vector<double> moved(std::span<const double> base, std::span<const double> change, double factor) {
  std::vector<double> result(base.begin(), base.end());
  for (std::size_t i = 0; i < change.size(); ++i) result[i] = std::max(0.0, result[i] + factor * change[i]);
  return result;
}

}  // namespace

class RateForm::Factor {
 public:
  void factorize(const linalg::SparseMatrix& matrix) {
    if (!solver_) {
      std::vector<std::int64_t> block(static_cast<std::size_t>(matrix.rows()));
      std::iota(block.begin(), block.end(), std::int64_t{0});
      solver_ = linalg::default_stiffness_solver({matrix, block, {}, {}});
    }
    try {
      solver_->factorize(matrix);
    } catch (const linalg::SingularMatrix&) {
      throw ModelError("heat: the heat capacity of a body is zero, or nothing holds its temperature");
    }
  }
  void solve(std::span<double> x) const {
    solver_->forward(x, x);
    solver_->backward(x, x);
  }

 private:
  std::unique_ptr<linalg::StiffnessSolver> solver_;
};

RateForm::RateForm(const Definition& definition) : problem_(definition) {}
RateForm::~RateForm() = default;

void RateForm::solve_capacity(double t, std::span<const double> T, std::span<double> x) {
  if (!capacity_) {
    capacity_ = std::make_unique<Factor>();
    capacity_matrix_ = problem_.matrix(t, T, {}, 0, 1);
    capacity_->factorize(capacity_matrix_);
  }
  if (problem_.has_constant_capacity()) {
    ++n_solves_;
    return capacity_->solve(x);
  }
  // Conjugate gradients, preconditioned with the capacities of some other temperatures.
  capacity_matrix_ = problem_.matrix(t, T, {}, 0, 1);
  const auto matrix = capacity_matrix_.selfadjointView<Eigen::Lower>();
  Vector residual = vector(std::span<const double>(x)), solution = Vector::Zero(residual.size());
  const double allowed = rounding * residual.norm();
  Vector direction;
  double before = 0;
  for (int iteration = 0; iteration < most_gradients && residual.norm() > allowed; ++iteration) {
    Vector better = residual;
    capacity_->solve({better.data(), static_cast<std::size_t>(better.size())});
    ++n_solves_;
    const double now = residual.dot(better);
    if (iteration == 0)
      direction = better;
    else
      direction = better + now / before * direction;
    before = now;
    const Vector image = matrix * direction;
    const double step = now / direction.dot(image);
    if (!std::isfinite(step)) break;
    solution += step * direction;
    residual -= step * image;
  }
  vector(x) = solution;
}

void RateForm::rate(double t, std::span<const double> T, const ContactAtNodes& contact, std::span<double> rate) {
  problem_.inflow(t, T, contact, rate);
  solve_capacity(t, T, rate);
  for (std::size_t u = 0; u < size(); ++u)
    if (problem_.is_given(u)) rate[u] = problem_.given_rate(u, t);
}

void RateForm::derivative(double t, std::span<const double> T, const ContactAtNodes& contact,
                          std::span<const double> T_change, const ContactAtNodes& contact_change,
                          std::span<double> product) {
  double factor = std::numeric_limits<double>::infinity();
  const auto bound = [&](std::span<const double> of, std::span<const double> change) {
    const double most = largest(change);
    if (most > 0) factor = std::min(factor, difference * std::max(largest(of), difference * most) / most);
  };
  bound(T, T_change);
  bound(contact.pressure, contact_change.pressure);
  bound(contact.gap, contact_change.gap);
  std::ranges::fill(product, 0.0);
  if (!std::isfinite(factor)) return;
  std::vector<double> side(size());
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> at(T.begin(), T.end());
    for (std::size_t u = 0; u < size(); ++u) at[u] += sign * factor * T_change[u];
    const std::vector<double> pressure = moved(contact.pressure, contact_change.pressure, sign * factor),
                              gap = moved(contact.gap, contact_change.gap, sign * factor);
    rate(t, at, {pressure, gap}, side);
    for (std::size_t u = 0; u < size(); ++u) product[u] += sign * side[u] / (2 * factor);
  }
  for (std::size_t u = 0; u < size(); ++u)
    if (problem_.is_given(u)) product[u] = 0;
}

void RateForm::prepare(double t, std::span<const double> T, const ContactAtNodes& contact) {
  prepared_capacity_ = problem_.matrix(t, T, contact, 0, 1);
  conduction_matrix_ = problem_.matrix(t, T, contact, 1, 0);
  gamma_ = 0;
}

void RateForm::precondition(double gamma, std::span<const double> r, std::span<double> z) {
  const bool prepared = gamma < same_gamma * gamma_ && gamma_ < same_gamma * gamma;
  if (!prepared) {
    linalg::SparseMatrix both = prepared_capacity_ + gamma * conduction_matrix_;
    if (!both_) both_ = std::make_unique<Factor>();
    both_->factorize(both);
    gamma_ = gamma;
  }
  vector(z) = prepared_capacity_.selfadjointView<Eigen::Lower>() * vector(r);
  for (std::size_t u = 0; u < size(); ++u)
    if (problem_.is_given(u)) z[u] = 0;
  both_->solve(z);
  ++n_solves_;
  for (std::size_t u = 0; u < size(); ++u)
    if (problem_.is_given(u)) z[u] = r[u];
}

std::vector<double> RateForm::steady_change(double t, std::span<const double> T, const ContactAtNodes& contact,
                                            const ContactAtNodes& contact_change) {
  double factor = std::numeric_limits<double>::infinity();
  for (const auto& [of, change] :
       {std::pair(contact.pressure, contact_change.pressure), std::pair(contact.gap, contact_change.gap)})
    if (const double most = largest(change); most > 0)
      factor = std::min(factor, difference * std::max(largest(of), difference * most) / most);
  std::vector<double> result(size(), 0.0), side(size());
  if (!std::isfinite(factor)) return result;
  for (const double sign : {1.0, -1.0}) {
    const std::vector<double> pressure = moved(contact.pressure, contact_change.pressure, sign * factor),
                              gap = moved(contact.gap, contact_change.gap, sign * factor);
    problem_.inflow(t, T, {pressure, gap}, side);
    for (std::size_t u = 0; u < size(); ++u) result[u] += sign * side[u] / (2 * factor);
  }
  if (!steady_) steady_ = std::make_unique<Factor>();
  steady_->factorize(problem_.matrix(t, T, contact, 1, 0));
  steady_->solve(result);
  return result;
}

}  // namespace creepcontact::heat
