#include "relaxing_share.hpp"

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
  const auto size_of = [&](const std::vector<double>& x) {
    return norm([&](std::size_t begin, std::size_t n) { return piece(x.data(), begin, n); });
  };
  const double all = size_of(whole);
  if (!(all > 0)) return std::nullopt;
  return gamma * size_of(own) / all;
}

}  // namespace creepcontact::ode
