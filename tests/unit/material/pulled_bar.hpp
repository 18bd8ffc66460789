#pragma once
/// A bar under tension, for tests of laws.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "creepcontact/material/bar.hpp"
#include "creepcontact/material/registry.hpp"
#include "unit/material/with_defaults.hpp"

namespace creepcontact::material {

/// A bar whose material has one law.
class PulledBar {
 public:
  PulledBar(const std::string& name, ParameterValues values, double T = 500) : temperature_(T) {
    law_ = make_law(name, std::move(values));
    for (const Function& parameter : law_->parameters()) parameters_.push_back(parameter({.T = T}));
    internal_.assign(law_->n_internal(), 0.0);
  }

  PointState at(double stress) {
    stress_[0] = stress;
    return {.stress = tensor::view(stress_),
            .internal = internal_,
            .parameters = parameters_,
            .time = time_,
            .temperature = temperature_};
  }

  double rate(double stress) {
    Tensor6 strain_rate = Tensor6::Zero();
    std::vector<double> own(internal_.size());
    law_->rate(at(stress), {tensor::writable(strain_rate), own});
    return strain_rate[0];
  }

  /// Moves on at constant stress by the closed form of the law.
  void grow(double stress, double duration) {
    Tensor6 change = Tensor6::Zero();
    std::vector<double> own(internal_.size(), 0.0);
    law_->increment(at(stress), duration, {tensor::writable(change), own});
    strain_ += change[0];
    for (std::size_t i = 0; i < own.size(); ++i) internal_[i] += own[i];
    time_ += duration;
  }

  /// Moves on at constant stress by the rate alone: Runge and Kutta, fourth order.
  void integrate(double stress, double duration, int steps) {
    const double h = duration / steps;
    const std::vector<double> weight{1, 2, 2, 1}, place{0, 0.5, 0.5, 1};
    for (int step = 0; step < steps; ++step) {
      const std::vector<double> begin = internal_;
      std::vector<double> sum(begin.size(), 0.0), own(begin.size(), 0.0);
      const double t = time_;
      double strain = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t i = 0; i < begin.size(); ++i) internal_[i] = begin[i] + h * place[k] * own[i];
        time_ = t + h * place[k];
        Tensor6 strain_rate = Tensor6::Zero();
        law_->rate(at(stress), {tensor::writable(strain_rate), own});
        strain += weight[k] * strain_rate[0];
        for (std::size_t i = 0; i < begin.size(); ++i) sum[i] += weight[k] * own[i];
      }
      for (std::size_t i = 0; i < begin.size(); ++i) internal_[i] = begin[i] + h / 6 * sum[i];
      strain_ += h / 6 * strain;
      time_ = t + h;
    }
  }

  const CreepLaw& law() const { return *law_; }
  void wait(double duration) { time_ += duration; }

  double value(const StateVariable& variable, double stress) {
    double value = 0;
    EXPECT_TRUE(law_->evaluate(variable, at(stress), {&value, 1}));
    return value;
  }

  double strain() const { return strain_; }
  std::vector<double>& internal() { return internal_; }

 private:
  std::unique_ptr<CreepLaw> law_;
  double temperature_, time_ = 0, strain_ = 0;
  Tensor6 stress_ = Tensor6::Zero();
  std::vector<double> parameters_, internal_;
};

inline void expect_relative(double value, double expected, double error) {
  EXPECT_NEAR(value, expected, error * std::abs(expected));
}

/// The bar at these times in a test of creep or relaxation; one law.
inline std::vector<BarState> history(const std::string& name, const ParameterValues& values, const BarTest& test,
                                     const std::vector<double>& times) {
  const std::shared_ptr<const CreepLaw> law = make_law(name, values);
  BarHistory found = bar_history({&law, 1}, test, times, 1e-7);
  EXPECT_EQ(found.states.size(), times.size()) << name;
  found.states.resize(times.size());
  return found.states;
}

}  // namespace creepcontact::material
