#include "error_norm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "creepcontact/base/error.hpp"

namespace creepcontact::ode {

void set_error_weights(std::span<const double> scale, double tolerance, std::span<double> weights) {
  const auto bad = std::ranges::find_if(scale, [](double value) { return !(value > 0); });
  if (bad != scale.end())
    throw std::invalid_argument(fmt::format("scale()[{}] = {} is not positive", bad - scale.begin(), *bad));
  const double unit = local_share * tolerance;
  for_each_index(scale.size(), [&](std::size_t i) { weights[i] = 1 / (unit * scale[i]); });
}

ErrorNorm::ErrorNorm(const Team& team, double tolerance) : team_(team), tolerance_(tolerance) {
  if (!(tolerance > 0)) throw ConfigError(fmt::format("tolerance = {}: must be positive", tolerance));
}

}  // namespace creepcontact::ode
