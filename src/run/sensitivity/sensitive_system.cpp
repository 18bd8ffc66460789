#include "sensitive_system.hpp"

#include <algorithm>
#include <cmath>

#include "creepcontact/numerics/long_vectors.hpp"

namespace creepcontact::run {
namespace {

constexpr double power = 4;  // of the norm of errors
/// Errors of derivatives may be so many times those of the state: steps then suit the state, and so do its results.
constexpr double of_derivatives = 4;

}  // namespace

SensitiveSystem::SensitiveSystem(Derivatives& derivatives) : of_(derivatives), base_(derivatives.base()) {
  set_scale(std::vector<double>(size(), 0.0));
}

void SensitiveSystem::set_scale(std::span<const double> y) {
  // The norm is a mean over all blocks: with this share it is at least that of the run's own.
  const double share = std::pow(static_cast<double>(of_.n_blocks()), -1 / power);
  const std::span<const double> of_run = base_.scale();
  const auto size_of = [&](std::size_t i) {
    const std::span<const double> values = of_.block(y, i);
    double largest = 1;
#pragma omp parallel for schedule(static) reduction(max : largest) if (values.size() >= numerics::parallel_entries)
    for (std::size_t j = 0; j < values.size(); ++j) largest = std::max(largest, std::abs(values[j]) / of_run[j]);
    return largest;
  };
  scale_.resize(size());
  const double of_state = size_of(0);
  for (std::size_t i = 0; i < of_.n_blocks(); ++i) {
    const double factor = i == 0 ? share : of_derivatives * std::max(1.0, size_of(i) / of_state);
    const std::span<double> own = of_.block(std::span(scale_), i);
    numerics::for_each_piece(own.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t j = begin; j < end; ++j) own[j] = factor * of_run[j];
    });
  }
}

void SensitiveSystem::prepare_preconditioner(double t, std::span<const double> y) {
  base_.prepare_preconditioner(t, of_.block(y, 0));
}

void SensitiveSystem::precondition(double gamma, std::span<const double> r, std::span<double> z) {
  for (std::size_t i = 0; i < of_.n_blocks(); ++i) base_.precondition(gamma, of_.block(r, i), of_.block(z, i));
}

void SensitiveSystem::prepare_tangent(double t, std::span<const double> y, double gamma) {
  base_.prepare_tangent(t, of_.block(y, 0), gamma);
}

void SensitiveSystem::solve_tangent(std::span<const double> r, std::span<double> z) {
  for (std::size_t i = 0; i < of_.n_blocks(); ++i) base_.solve_tangent(of_.block(r, i), of_.block(z, i));
}

}  // namespace creepcontact::run
