#include "creepcontact/material/bar.hpp"

#include <algorithm>
#include <cmath>

#include "rosenbrock.hpp"

namespace creepcontact::material {
namespace {

constexpr double ruptured_damage = 0.99;
constexpr double largest_strain = 1e6;
constexpr double shortest_step = 1e-7;  // of the time
constexpr int most_steps = 20000;
constexpr double smallest_unknown = 1e-14;  // whose relative error counts

using Laws = std::span<const std::shared_ptr<const CreepLaw>>;

/// The state of one point: the creep strain, then the internal variables of the laws.
class Bar final : public StiffSystem {
 public:
  Bar(Laws laws, const BarTest& test) : laws_(laws), test_(test) {
    for (const auto& law : laws) {
      n_ += law->n_internal();
      for (const Function& parameter : law->parameters()) parameters_.push_back(parameter({.T = test.temperature}));
    }
  }

  Eigen::VectorXd virgin() const { return Eigen::VectorXd::Zero(n_); }

  double stress(const Eigen::VectorXd& y) const {
    return test_.relaxes() ? test_.stress - test_.young_modulus * y[0] : test_.stress;
  }

  Eigen::VectorXd rate(double t, const Eigen::VectorXd& y) const override {
    Eigen::VectorXd result = virgin();
    each(t, y, [&](const CreepLaw& law, const PointState& at, std::size_t first) {
      law.rate(at, {tensor::Map(result.data()), internal(law, result, first)});
    });
    return result;
  }

  /// The growth over `duration` from t = 0 on.
  Eigen::VectorXd increment(double duration) const {
    Eigen::VectorXd result = virgin();
    const Eigen::VectorXd y = virgin();
    each(0, y, [&](const CreepLaw& law, const PointState& at, std::size_t first) {
      law.increment(at, duration, {tensor::Map(result.data()), internal(law, result, first)});
    });
    return result;
  }

  Eigen::MatrixXd jacobian(double t, const Eigen::VectorXd& y) const override {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(y.size(), y.size());
    Eigen::VectorXd unit = virgin(), column = virgin();
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      unit[i] = 1;
      column.setZero();
      Tensor6 relaxed = Tensor6::Zero();
      if (i == 0 && test_.relaxes()) relaxed[0] = -test_.young_modulus;
      each(t, y, [&](const CreepLaw& law, const PointState& at, std::size_t first) {
        const std::span<const double> own{unit.data() + first, static_cast<std::size_t>(law.n_internal())};
        law.derivative(
            at, {.stress = tensor::view(relaxed), .creep_strain = tensor::ConstMap(unit.data()), .internal = own},
            {tensor::Map(column.data()), internal(law, column, first)});
      });
      result.col(i) = column;
      unit[i] = 0;
    }
    return result;
  }

  bool is_damaged(double t, const Eigen::VectorXd& y) const {
    bool found = false;
    each(t, y, [&](const CreepLaw& law, const PointState& at, std::size_t) {
      double value = 0;
      found = found || (law.evaluate(damage, at, {&value, 1}) && !(value < ruptured_damage));
    });
    return found;
  }

  bool is_isochronous() const {
    return std::ranges::any_of(laws_, [](const auto& law) { return law->is_isochronous(); });
  }

  BarState state(const Eigen::VectorXd& y) const { return {y[0], stress(y)}; }

 private:
  static std::span<double> internal(const CreepLaw& law, Eigen::VectorXd& y, std::size_t first) {
    return {y.data() + first, static_cast<std::size_t>(law.n_internal())};
  }

  template <typename Visit>
  void each(double t, const Eigen::VectorXd& y, const Visit& visit) const {
    Tensor6 along = Tensor6::Zero();
    along[0] = stress(y);
    std::size_t first = 6, parameter = 0;
    for (const auto& law : laws_) {
      const PointState at{.stress = tensor::view(along),
                          .creep_strain = tensor::ConstMap(y.data()),
                          .internal = {y.data() + first, static_cast<std::size_t>(law->n_internal())},
                          .parameters = {parameters_.data() + parameter, static_cast<std::size_t>(law->n_parameters())},
                          .time = t,
                          .temperature = test_.temperature};
      visit(*law, at, first);
      first += static_cast<std::size_t>(law->n_internal());
      parameter += static_cast<std::size_t>(law->n_parameters());
    }
  }

  Laws laws_;
  const BarTest& test_;
  Eigen::Index n_ = 6;
  std::vector<double> parameters_;
};

/// Laws that give the strain itself.
BarHistory isochronous_history(const Bar& bar, const BarTest& test, std::span<const double> times) {
  BarHistory history;
  const Eigen::VectorXd y = bar.virgin();
  for (const double t : times) {
    Eigen::VectorXd reached = y;
    if (!test.relaxes()) {
      reached = bar.rate(t, y);
    } else {  // creep strain = that of the stress which it leaves; it grows with the stress
      double low = 0, high = test.stress / test.young_modulus;
      for (int i = 0; i < 60; ++i) {
        reached[0] = 0.5 * (low + high);
        (bar.rate(t, reached)[0] > reached[0] ? low : high) = reached[0];
      }
    }
    history.last = {reached[0], test.relaxes() ? test.stress - test.young_modulus * reached[0] : test.stress};
    history.failed = !reached.allFinite() || std::abs(reached[0]) > largest_strain;
    if (history.failed) break;
    history.states.push_back(history.last);
  }
  return history;
}

/// Largest error of a step in units of the tolerance.
double error_of(const RosenbrockStep& step, const Eigen::VectorXd& begin, double tolerance) {
  double largest = 0;
  for (Eigen::Index i = 0; i < begin.size(); ++i) {
    const double size = std::max(std::abs(begin[i]), std::abs(step.end()[i]));
    largest = std::max(largest, std::abs(step.error()[i]) / (tolerance * (size + smallest_unknown)));
  }
  return largest;
}

/// Part of the step after which the damage is that of rupture.
double rupture_within(const Bar& bar, const RosenbrockStep& step, double t, double h) {
  double before = 0, after = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (before + after);
    (bar.is_damaged(t + middle * h, step.within(middle)) ? after : before) = middle;
  }
  return after;
}

}  // namespace

BarHistory bar_history(Laws laws, const BarTest& test, std::span<const double> times, double tolerance) {
  const Bar bar(laws, test);
  if (bar.is_isochronous()) return isochronous_history(bar, test, times);
  BarHistory history;
  const auto positive = std::ranges::find_if(times, [](double t) { return t > 0; });
  history.states.assign(positive - times.begin(), bar.state(bar.virgin()));
  history.last = bar.state(bar.virgin());
  if (positive == times.end()) return history;

  const double end = times.back();
  // The increments are exact at constant stress for all laws but those with damage, which begins slowly.
  double t = (test.relaxes() ? 1e-8 : 1e-4) * *positive, h = t;
  Eigen::VectorXd y = bar.increment(t);
  auto next = positive;
  for (int n = 0; t < end; ++n) {
    if (!y.allFinite() || std::abs(y[0]) > largest_strain || n == most_steps) {
      history.failed = true;
      return history;
    }
    const double to_end = end - t;
    h = std::min(h, to_end);
    const RosenbrockStep step(bar, t, h, y);
    const double error = step.is_finite() ? error_of(step, y, tolerance) : 1e9;
    if (error > 1) {
      h *= std::max(0.1, 0.9 * std::pow(error, -0.25));
      if (h < shortest_step * t) {
        history.rupture = t;
        return history;
      }
      continue;
    }
    const bool ruptures = bar.is_damaged(t + h, step.end());
    const double part = ruptures ? rupture_within(bar, step, t, h) : 1;
    const double reached = ruptures ? t + part * h : h == to_end ? end : t + h;
    for (; next != times.end() && (ruptures ? *next < reached : *next <= reached); ++next)
      history.states.push_back(bar.state(*next == reached ? step.end() : step.within((*next - t) / h)));
    history.last = bar.state(ruptures ? step.within(part) : step.end());
    t = reached;
    if (ruptures) {
      history.rupture = t;
      return history;
    }
    y = step.end();
    h *= std::min(6.0, 0.9 * std::pow(std::max(error, 1e-8), -0.25));
  }
  return history;
}

double initial_rate(Laws laws, const BarTest& test) {
  const Bar bar(laws, test);
  return bar.is_isochronous() ? std::numeric_limits<double>::infinity() : bar.rate(0, bar.virgin())[0];
}

}  // namespace creepcontact::material
