#include "kept_factor.hpp"

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace creepcontact::heat {
namespace {

constexpr int most_of_one_solution = 20;  // iterations
constexpr double near = 0.3;              // part of the residual that a factor leaves after a step along what it gives

}  // namespace

void KeptFactor::set(const linalg::SparseMatrix& lower) {
  matrix_ = &lower;
  is_exact_ = false;
}

void KeptFactor::factorize() {
  if (!solver_) {
    std::vector<std::int64_t> block(static_cast<std::size_t>(matrix_->rows()));
    std::iota(block.begin(), block.end(), std::int64_t{0});
    solver_ = linalg::default_stiffness_solver({*matrix_, block, {}, {}});
  }
  ++n_factorizations_;
  spent_ = 0;
  is_exact_ = has_factor_ = false;  // for good, if the matrix is singular
  solver_->factorize(*matrix_);
  is_exact_ = has_factor_ = true;
}

double KeptFactor::worth() const {
  // Operations over entries grow with the width of separators: the root of the entries in solids, about. Measured.
  return 0.005 * std::sqrt(static_cast<double>(solver_->factor_bytes()) / sizeof(double));
}

void KeptFactor::pass(std::span<double> x) {
  solver_->forward(x, x);
  solver_->backward(x, x);
  ++n_passes_;
}

void KeptFactor::solve(std::span<double> x, Accuracy accuracy) {
  if (!has_factor_ || (!is_exact_ && spent_ > worth())) factorize();
  if (!is_exact_ && iterate(x, accuracy)) return;
  if (!is_exact_) factorize();
  pass(x);
}

bool KeptFactor::iterate(std::span<double> x, Accuracy accuracy) {
  using Vector = Eigen::VectorXd;
  Eigen::Map<Vector> given(x.data(), std::ssize(x));
  Vector residual = given, solution = Vector::Zero(given.size()), z, direction, image;
  const double enough = accuracy.absolute * std::sqrt(static_cast<double>(x.size()));
  const auto precondition = [&] {
    z = residual;
    pass({z.data(), x.size()});
  };
  precondition();
  direction = z;
  double size = residual.dot(z), energy = 0;
  for (int iteration = 1; size > 0; ++iteration) {
    image.noalias() = matrix_->selfadjointView<Eigen::Lower>() * direction;
    const double curvature = direction.dot(image);
    if (!(curvature > 0)) return false;  // rounding, or a matrix that is not positive
    // What the factor alone gives would be far too small if it were that of shorter steps: the length of the step
    // along it is what tells the size of the solution.
    const double step = size / curvature, gained = step * size;
    solution += step * direction;
    residual -= step * image;
    energy += gained;
    if (step * direction.norm() <= enough && residual.norm() <= near * given.norm()) break;
    // What an iteration gains is about what is left; the residual also tells it after the first one.
    if (gained <= accuracy.relative * accuracy.relative * energy || residual.norm() <= accuracy.relative * given.norm())
      break;
    if (iteration == most_of_one_solution) return false;
    precondition();
    ++spent_;
    const double before = std::exchange(size, residual.dot(z));
    direction = z + (size / before) * direction;
  }
  given = solution;
  return true;
}

}  // namespace creepcontact::heat
