#include "creepcontact/material/bar.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "rosenbrock.hpp"

namespace creepcontact::material {
namespace {

constexpr double ruptured_damage = 0.99;
constexpr double max_strain = 1e6;
constexpr double min_relative_step = 1e-7;  // of the time
constexpr int max_steps = 20000;
constexpr double smallest_unknown = 1e-14;  // whose relative error counts

using Laws = std::span<const std::shared_ptr<const CreepLaw>>;

/// The state of one point: the creep strain along the bar, then the internal variables of the laws. Laws do not depend
/// on the creep strain other than through these and the stress.
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
    Tensor6 strain = Tensor6::Zero();
    each(t, y, [&](const CreepLaw& law, const PointState& at, std::size_t first) {
      law.rate(at, {tensor::writable(strain), internal(law, result, first)});
    });
    result[0] = strain[0];
    return result;
  }

  /// The growth over `duration` from (t, y) on, by the laws' closed forms at constant stress.
  Eigen::VectorXd increment(double t, const Eigen::VectorXd& y, double duration) const {
    Eigen::VectorXd result = virgin();
    Tensor6 strain = Tensor6::Zero();
    each(t, y, [&](const CreepLaw& law, const PointState& at, std::size_t first) {
      law.increment(at, duration, {tensor::writable(strain), internal(law, result, first)});
    });
    result[0] = strain[0];
    return result;
  }

  Eigen::MatrixXd jacobian(double t, const Eigen::VectorXd& y) const override {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(y.size(), y.size());
    Eigen::VectorXd unit = virgin(), column = virgin();
    for (Eigen::Index i = test_.relaxes() ? 0 : 1; i < y.size(); ++i) {
      unit[i] = 1;
      column.setZero();
      Tensor6 relaxed = Tensor6::Zero(), along = Tensor6::Zero(), strain = Tensor6::Zero();
      if (i == 0) {
        relaxed[0] = -test_.young_modulus;
        along[0] = 1;
      }
      each(t, y, [&](const CreepLaw& law, const PointState& at, std::size_t first) {
        const std::span<const double> own{unit.data() + first, static_cast<std::size_t>(law.n_internal())};
        law.derivative(at, {.stress = tensor::view(relaxed), .creep_strain = tensor::view(along), .internal = own},
                       {tensor::writable(strain), internal(law, column, first)});
      });
      column[0] = strain[0];
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
    Tensor6 along = Tensor6::Zero(), strain = Tensor6::Zero();
    along[0] = stress(y);
    strain[0] = y[0];
    std::size_t first = 1, parameter = 0;
    for (const auto& law : laws_) {
      const PointState at{.stress = tensor::view(along),
                          .creep_strain = tensor::view(strain),
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
  Eigen::Index n_ = 1;
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
    history.failed = !reached.allFinite() || std::abs(reached[0]) > max_strain;
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

/// Growth up to t at constant stress by the laws' increments, if they are exact: if growth in one increment and in two
/// are the same. The difference is an estimate of the error.
std::optional<Eigen::VectorXd> exact_growth(const Bar& bar, double t, double tolerance) {
  constexpr double first_part = 0.4;
  const Eigen::VectorXd begin = bar.virgin();
  Eigen::VectorXd whole = bar.increment(0, begin, t);
  const Eigen::VectorXd first = bar.increment(0, begin, first_part * t);
  const Eigen::VectorXd again = first + bar.increment(first_part * t, first, (1 - first_part) * t);
  for (Eigen::Index i = 0; i < whole.size(); ++i)
    if (!(std::abs(again[i] - whole[i]) <= tolerance * (std::abs(whole[i]) + smallest_unknown))) return std::nullopt;
  return whole;
}

/// The history at constant stress by the laws' closed forms alone, where they have them.
std::optional<BarHistory> closed_history(const Bar& bar, std::span<const double> times, double tolerance) {
  BarHistory history;
  for (const double t : times) {
    const std::optional<Eigen::VectorXd> whole = exact_growth(bar, t, tolerance);
    if (!whole || !(std::abs((*whole)[0]) <= max_strain) || bar.is_damaged(t, *whole)) return std::nullopt;
    history.last = bar.state(*whole);
    history.states.push_back(history.last);
  }
  return history;
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
  if (!test.relaxes() && !times.empty()) {
    if (auto closed = closed_history(bar, times, 0.1 * tolerance)) return std::move(*closed);
  }
  BarHistory history;
  const auto positive = std::ranges::find_if(times, [](double t) { return t > 0; });
  history.states.assign(positive - times.begin(), bar.state(bar.virgin()));
  history.last = bar.state(bar.virgin());
  if (positive == times.end()) return history;

  const double end = times.back();
  // The increments of most laws are exact at constant stress. Those of others are exact enough for a short time.
  constexpr double long_start = 1e-4, short_start = 1e-8;  // of the first of the times
  double t = (test.relaxes() ? short_start : long_start) * *positive;
  while (t > short_start * *positive && !exact_growth(bar, t, tolerance)) t *= 0.1;
  double h = t;
  Eigen::VectorXd y = bar.increment(0, bar.virgin(), t);
  auto next = positive;
  for (int n = 0; t < end; ++n) {
    if (!y.allFinite() || std::abs(y[0]) > max_strain || n == max_steps) {
      history.failed = true;
      return history;
    }
    const double to_end = end - t;
    h = std::min(h, to_end);
    const RosenbrockStep step(bar, t, h, y);
    const double error = step.is_finite() ? error_of(step, y, tolerance) : 1e9;
    if (error > 1) {
      h *= std::max(0.1, 0.9 * std::pow(error, -0.25));
      if (h < min_relative_step * t) {
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

double rate_at(Laws laws, const BarTest& test, double time, double strain) {
  const Bar bar(laws, test);
  if (bar.is_isochronous()) throw std::invalid_argument("the law gives the strain itself, not a rate");
  Eigen::VectorXd y = bar.virgin();
  y[0] = strain;
  Eigen::Index first = 1;
  for (const auto& law : laws) {
    const int n = law->n_internal();
    const bool is_strain = n == 1 && law->internal_kind(0) == InternalKind::strain;
    if (strain != 0 && n > 0 && !is_strain)
      throw std::invalid_argument(law->name() + ": its rate depends on more than the strain so far; use a creep curve");
    if (is_strain) y[first] = strain;
    first += n;
  }
  return bar.rate(time, y)[0];
}

}  // namespace creepcontact::material
