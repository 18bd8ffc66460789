#include "creepcontact/ode/restart_share.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace creepcontact::ode {
namespace {

constexpr double least_share = 1e-5;  // beyond, rounding would decide
constexpr double many = 400;          // restarts, from which on the share falls more slowly

/// The share is (few / restarts)^power.
struct Loss {
  double few, power;
};

// Errors fall about as the square root of the tolerance with the first two, nearly as the tolerance with the others.
const std::map<std::string, Loss> losses{
    {"cvode_bdf", {12, 2}}, {"cvode_adams", {12, 2}}, {"log_adams", {40, 1}}, {"auto", {40, 1}}};

}  // namespace

double restart_share(const std::string& integrator, double restarts) {
  const auto found = losses.find(integrator);
  if (found == losses.end() || restarts <= found->second.few) return 1;
  const auto& [few, power] = found->second;
  // Beyond, what creeps grows with the number of pieces, and so does the error that a probe may have.
  const double counted = restarts <= many ? restarts : std::sqrt(many * restarts);
  return std::max(least_share, std::pow(few / counted, power));
}

double vibration_share(double turns) {
  constexpr double few = 100, least = 1e-3;
  return turns <= few ? 1 : std::max(least, few / turns);
}

}  // namespace creepcontact::ode
