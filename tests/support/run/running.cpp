#include "support/run/running.hpp"

#include <fmt/format.h>

#include <cmath>

namespace creepcontact::run::test {

std::vector<std::string> elastic(std::vector<std::string> more) {
  for (const char* material : {"soft", "hard"}) more.push_back(fmt::format("materials.{}.creep=[]", material));
  return more;
}

double relaxed_pressure(double t) {
  return std::pow(1 + 3 * (3 * 1e-3 / 0.025) * t, -1.0 / 3);
}

void expect_relaxed_pressure(const Table& history, double tolerance, const std::string& where) {
  for (const double t : history.times())
    EXPECT_NEAR(history.at("pressure", t), relaxed_pressure(t), tolerance) << where << " at t = " << t;
}

}  // namespace creepcontact::run::test
