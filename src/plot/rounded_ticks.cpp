#include "creepcontact/plot/rounded_ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace creepcontact::plot {
namespace {

constexpr double min_relative_range = 1e-9, widening = 1e-2;  // of the numbers

}  // namespace

std::vector<double> rounded_ticks(double low, double high, double about) {
  const double size = std::max(std::abs(low), std::abs(high));
  if (!(high - low > min_relative_range * size)) {
    const double pad = size > 0 ? widening * size : 1;
    low -= pad;
    high += pad;
  }
  const double raw = (high - low) / about, decade = std::pow(10, std::floor(std::log10(raw)));
  constexpr std::array factors{1.0, 2.0, 5.0, 10.0};
  const double step = decade * *std::ranges::find_if(factors, [&](double factor) {
                        return factor == factors.back() || factor * decade >= 0.999 * raw;
                      });
  const double first = std::floor(low / step + 1e-6), last = std::ceil(high / step - 1e-6);
  std::vector<double> ticks;
  for (double i = first; i <= last; ++i) ticks.push_back(i * step);
  return ticks;
}

}  // namespace creepcontact::plot
