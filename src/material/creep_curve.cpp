#include "creepcontact/material/creep_curve.hpp"

#include <Eigen/LU>
#include <cmath>
#include <optional>

namespace creepcontact::material {
namespace {

constexpr int steps_per_decade = 40;
constexpr double largest_strain = 1;

/// The state of one point under constant stress: the creep strain, then the internal variables of the laws.
class Bar {
 public:
  Bar(const Material& material, const CreepTest& test) : material_(material), temperature_(test.temperature) {
    stress_[0] = test.stress;
    for (const auto& law : material.creep)
      for (const Function& parameter : law->parameters()) parameters_.push_back(parameter({.T = test.temperature}));
  }

  Eigen::VectorXd rate(double t, const Eigen::VectorXd& y) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(y.size());
    each(t, y, [&](const CreepLaw& law, const PointState& at, std::size_t first) {
      law.rate(at, {tensor::Map(result.data()), internal(law, result, first)});
    });
    return result;
  }

  /// The growth over `duration` from t = 0 on.
  Eigen::VectorXd increment(const Eigen::VectorXd& y, double duration) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(y.size());
    each(0, y, [&](const CreepLaw& law, const PointState& at, std::size_t first) {
      law.increment(at, duration, {tensor::Map(result.data()), internal(law, result, first)});
    });
    return result;
  }

  Eigen::MatrixXd jacobian(double t, const Eigen::VectorXd& y) const {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(y.size(), y.size());
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      const Eigen::VectorXd unit = Eigen::VectorXd::Unit(y.size(), i);
      Eigen::VectorXd column = Eigen::VectorXd::Zero(y.size());
      each(t, y, [&](const CreepLaw& law, const PointState& at, std::size_t first) {
        const std::span<const double> own{unit.data() + first, static_cast<std::size_t>(law.n_internal())};
        law.derivative(at, {.creep_strain = tensor::ConstMap(unit.data()), .internal = own},
                       {tensor::Map(column.data()), internal(law, column, first)});
      });
      result.col(i) = column;
    }
    return result;
  }

  bool is_isochronous() const {
    return std::ranges::any_of(material_.creep, [](const auto& law) { return law->is_isochronous(); });
  }

 private:
  static std::span<double> internal(const CreepLaw& law, Eigen::VectorXd& y, std::size_t first) {
    return {y.data() + first, static_cast<std::size_t>(law.n_internal())};
  }

  template <typename Visit>
  void each(double t, const Eigen::VectorXd& y, const Visit& visit) const {
    std::size_t first = 6, parameter = 0;
    for (const auto& law : material_.creep) {
      const PointState at{.stress = tensor::ConstMap(stress_.data()),
                          .creep_strain = tensor::ConstMap(y.data()),
                          .internal = {y.data() + first, static_cast<std::size_t>(law->n_internal())},
                          .parameters = {parameters_.data() + parameter, static_cast<std::size_t>(law->n_parameters())},
                          .time = t,
                          .temperature = temperature_};
      visit(*law, at, first);
      first += static_cast<std::size_t>(law->n_internal());
      parameter += static_cast<std::size_t>(law->n_parameters());
    }
  }

  const Material& material_;
  double temperature_;
  Tensor6 stress_ = Tensor6::Zero();
  std::vector<double> parameters_;
};

/// k = f(t, base + h gamma k) by Newton's method. @returns nullopt if it does not converge
std::optional<Eigen::VectorXd> stage(const Bar& bar, double t, const Eigen::VectorXd& base, double h_gamma,
                                     Eigen::VectorXd k) {
  for (int i = 0; i < 30; ++i) {
    const Eigen::VectorXd y = base + h_gamma * k;
    const Eigen::VectorXd defect = bar.rate(t, y) - k;
    const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(k.size(), k.size()) - h_gamma * bar.jacobian(t, y);
    const Eigen::VectorXd change = matrix.partialPivLu().solve(defect);
    if (!change.allFinite()) return std::nullopt;
    k += change;
    if (change.norm() <= 1e-8 * k.norm()) return k;
  }
  return std::nullopt;
}

/// One step of SDIRK2. @returns nullopt if it cannot be made
std::optional<Eigen::VectorXd> advanced(const Bar& bar, double t, double h, const Eigen::VectorXd& y) {
  const double gamma = 1 - 1 / std::sqrt(2.0);
  const auto first = stage(bar, t + gamma * h, y, gamma * h, bar.rate(t, y));
  if (!first) return std::nullopt;
  const Eigen::VectorXd base = y + h * (1 - gamma) * *first;
  const auto second = stage(bar, t + h, base, gamma * h, *first);
  if (!second) return std::nullopt;
  return base + h * gamma * *second;
}

}  // namespace

CreepCurve creep_curve(const Material& material, const CreepTest& test, double decades) {
  CreepCurve curve;
  if (!material.creeps() || !(test.end > 0)) return curve;
  const Bar bar(material, test);
  const int n = static_cast<int>(std::ceil(decades * steps_per_decade));
  const double first = test.end * std::pow(10, -decades - 2);  // two decades more for what the first increment neglects
  Eigen::VectorXd y = Eigen::VectorXd::Zero(material.n_state());
  if (!bar.is_isochronous()) y += bar.increment(y, first);
  double t = first;
  for (int i = -2 * steps_per_decade; i <= n; ++i) {
    const double next = test.end * std::pow(10, decades * (static_cast<double>(i) / n - 1));
    if (bar.is_isochronous()) {
      y.head<6>() = bar.rate(next, y).head<6>();  // the strain itself
    } else if (next > t) {
      const auto reached = advanced(bar, t, next - t, y);
      if (!reached) break;
      y = *reached;
    }
    t = next;
    if (!y.allFinite() || std::abs(y[0]) > largest_strain) break;
    if (i < 0) continue;
    curve.time.push_back(t);
    curve.strain.push_back(y[0]);
  }
  return curve;
}

}  // namespace creepcontact::material
