#include "vibration_turns.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cstdint>

namespace creepcontact::model {

std::vector<double> turns_of_vibration(const Course& course, Interval over, double n_turns) {
  constexpr double samples_per_turn = 16, most_located = 1e5;
  constexpr int bits = 24;  // a turn is flat: its value is then exact
  constexpr std::uintmax_t most_evaluations = 40;
  if (!(n_turns <= most_located)) return {};
  const auto n = static_cast<std::size_t>(samples_per_turn * std::max(n_turns, 1.0));
  const auto time = [&](std::size_t i) {
    return over.low + (over.high - over.low) * static_cast<double>(i) / static_cast<double>(n);
  };
  std::vector<double> turns;
  double before = course(over.low), here = course(time(1));
  for (std::size_t i = 2; i <= n; ++i) {
    const double after = course(time(i));
    if ((here - before) * (after - here) < 0) {
      const double sign = here > before ? -1 : 1;
      std::uintmax_t evaluations = most_evaluations;
      turns.push_back(boost::math::tools::brent_find_minima([&](double t) { return sign * course(t); }, time(i - 2),
                                                            time(i), bits, evaluations)
                          .first);
    }
    before = here;
    here = after;
  }
  return turns;
}

}  // namespace creepcontact::model
