#include "relaxing_share.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "error_norm.hpp"

namespace creepcontact::ode {

std::optional<double> relaxing_share(System& system, double t, std::span<const double> y, double stable_step) {
  JacobianProducts* jacobian = system.jacobian();
  if (jacobian == nullptr || std::isinf(stable_step)) return std::nullopt;
  const double gamma = stable_step;
  std::vector<double> rate(y.size()), product(y.size()), own(y.size()), whole(y.size());
  system.rate(t, y, rate);
  jacobian->jacobian_times(t, y, rate, product);
  jacobian->prepare_preconditioner(t, y);
  // (I - gamma J_local)^-1 gamma J f, and the same with J_local, which is the difference of two known vectors.
  jacobian->precondition(gamma, product, own);
  jacobian->precondition(gamma, rate, whole);
  for_each_index(whole.size(), [&](std::size_t i) { whole[i] -= rate[i]; });
  ErrorNorm norm(system.team(), 1);
  norm.set_scale(system.scale());
  const auto squared = [&](const std::vector<double>& a, double factor, const std::vector<double>& b) {
    const double size = norm([&](std::size_t begin, std::size_t n) {
      return piece(a.data(), begin, n) + factor * piece(b.data(), begin, n);
    });
    return size * size;
  };
  const auto product_of = [&](const std::vector<double>& a, const std::vector<double>& b) {
    return (squared(a, 1, b) - squared(a, -1, b)) / 4;
  };
  const double all = squared(whole, 0, whole);
  if (!(all > 0)) return std::nullopt;
  if (product_of(whole, rate) > 0) return 0.0;
  return std::max(0.0, gamma * product_of(own, whole) / all);
}

}  // namespace creepcontact::ode
