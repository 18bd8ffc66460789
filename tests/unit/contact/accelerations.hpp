#pragma once
/// The Schwarz iteration in all its forms, with Anderson's method as the program hands it over.

#include "creepcontact/contact/solver/contact_solver.hpp"
#include "creepcontact/ode/anderson_iteration.hpp"

namespace creepcontact::test {

using Acceleration = contact::SchwarzOptions::Acceleration;
inline constexpr Acceleration accelerations[] = {Acceleration::none, Acceleration::aitken, Acceleration::anderson,
                                                 Acceleration::cg};

class Anderson final : public contact::FixedPointSolver {
 public:
  explicit Anderson(std::size_t size) : iteration_(size, 5) {}
  void solve(std::span<double> x, const Step& step) override { iteration_.run(x, step); }

 private:
  ode::AndersonIteration iteration_;
};

inline contact::SchwarzOptions accelerated(Acceleration acceleration) {
  contact::SchwarzOptions options;
  options.acceleration = acceleration;
  options.anderson = [](std::size_t size) { return std::make_unique<Anderson>(size); };
  return options;
}

}  // namespace creepcontact::test
