#include "creepcontact/contact/gasket_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

namespace creepcontact::contact {
namespace {

constexpr double on_curve = 0.01;         // of a pressure: an unloading curve ends on the loading curve
constexpr double above_curve = 1e-9;      // of the largest pressure: rounding
constexpr double shortest_piece = 1e-12;  // of the largest closure

/// Place between two entries of an increasing list; beyond its ends that of the end.
struct Between {
  std::size_t below = 0, above = 0;
  double part = 0;
};
Between find_between(const std::vector<double>& list, double value) {
  if (value <= list.front()) return {};
  if (value >= list.back()) return {list.size() - 1, list.size() - 1, 0};
  const auto above = static_cast<std::size_t>(std::ranges::upper_bound(list, value) - list.begin());
  return {above - 1, above, (value - list[above - 1]) / (list[above] - list[above - 1])};
}

/// A function of straight pieces through the points; the last piece goes on.
double at(const std::vector<double>& x, const std::vector<double>& y, double value) {
  const auto found = std::ranges::upper_bound(x, value) - x.begin();
  const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(found, 1, std::ssize(x) - 1));
  return y[i - 1] + (value - x[i - 1]) * (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
}
double pressure_of(const GasketCurve& curve, double closure) {
  return std::max(0.0, at(curve.closure, curve.pressure, closure));
}

void require_increasing(const std::vector<double>& values, const std::string& name) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]))
      throw std::invalid_argument(fmt::format("{}: point {} is not a number", name, i + 1));
    if (i > 0 && !(values[i] > values[i - 1]))
      throw std::invalid_argument(
          fmt::format("{}: must increase from point to point, but point {} is {:.6g} and point {} is {:.6g}{}", name, i,
                      values[i - 1], i + 1, values[i],
                      values[i] == values[i - 1] ? "; give a plateau a small slope, or end the curve before it" : ""));
  }
}

void require_curve(const GasketCurve& curve, const std::string& name) {
  if (curve.closure.size() != curve.pressure.size())
    throw std::invalid_argument(fmt::format("{}: {} closures and {} pressures; give as many of each", name,
                                            curve.closure.size(), curve.pressure.size()));
  if (curve.closure.size() < 2) throw std::invalid_argument(fmt::format("{}: needs at least two points", name));
  require_increasing(curve.closure, name + ", closure");
  require_increasing(curve.pressure, name + ", pressure");
  if (curve.pressure.front() != 0)
    throw std::invalid_argument(
        fmt::format("{}: the first pressure must be 0, at the closure where contact begins; it is {:.6g}", name,
                    curve.pressure.front()));
}

}  // namespace

struct GasketLaw::Unloading {
  double residual = 0;  // over the largest closure
  std::vector<double> s{0, 1}, r{0, 1};

  static Unloading mixed(const Unloading& a, const Unloading& b, double part) {
    Unloading result;
    result.residual = (1 - part) * a.residual + part * b.residual;
    result.s.clear();
    std::ranges::set_union(a.s, b.s, std::back_inserter(result.s));
    result.r.clear();
    for (const double s : result.s) result.r.push_back((1 - part) * at(a.s, a.r, s) + part * at(b.s, b.r, s));
    return result;
  }
};

GasketLaw::GasketLaw(double thickness, std::vector<GasketData> data) : thickness_(thickness), data_(std::move(data)) {
  if (!(thickness > 0) || !std::isfinite(thickness)) throw std::invalid_argument("thickness: must be positive");
  for (std::size_t i = 0; i < data_.size(); ++i) {
    if (i > 0 && !(data_[i].temperature > data_[i - 1].temperature))
      throw std::invalid_argument("the temperatures of the curves must increase");
    if (data_[i].unloading.empty() != data_.front().unloading.empty())
      throw std::invalid_argument("unloading: must be given at all temperatures or at none");
    check(data_[i]);
  }
}

GasketLaw GasketLaw::spring(GasketCurve curve) {
  if (curve.closure.size() != curve.pressure.size() || curve.closure.size() < 2)
    throw std::invalid_argument("curve: needs as many forces as closures, and at least two");
  require_increasing(curve.closure, "curve, closure");
  require_increasing(curve.pressure, "curve, force");
  if (curve.pressure.front() > 0)
    throw std::invalid_argument("curve: must begin with a force of 0, or with a negative one if the spring pulls");
  GasketLaw law;
  law.pulls_ = curve.pressure.front() < 0;
  law.data_.push_back({0, std::move(curve), {}});
  return law;
}

void GasketLaw::check(const GasketData& of) const {
  const std::string here = data_.size() > 1 ? fmt::format(" at {:.6g} degrees", of.temperature) : "";
  require_curve(of.loading, "loading" + here);
  const GasketUnloading& unloading = of.unloading;
  if (unloading.from.size() != unloading.modulus.size())
    throw std::invalid_argument(fmt::format("unloading{}: {} pressures in 'from' and {} moduli; give as many of each",
                                            here, unloading.from.size(), unloading.modulus.size()));
  if (!unloading.from.empty() && !unloading.curves.empty())
    throw std::invalid_argument(fmt::format("unloading{}: give either 'from' and 'modulus', or 'curves'", here));
  require_increasing(unloading.from, "unloading" + here + ", from");
  for (std::size_t i = 0; i < unloading.from.size(); ++i)
    if (!(unloading.from[i] > 0) || !(unloading.modulus[i] > 0))
      throw std::invalid_argument(fmt::format("unloading{}: pressures and moduli must be positive", here));
  double last = 0;
  for (std::size_t i = 0; i < unloading.curves.size(); ++i) {
    const GasketCurve& curve = unloading.curves[i];
    const std::string name = fmt::format("unloading{}, curve {}", here, i + 1);
    require_curve(curve, name);
    const double end = curve.closure.back(), wanted = pressure_of(of.loading, end);
    if (!(std::abs(wanted - curve.pressure.back()) <= on_curve * wanted))
      throw std::invalid_argument(
          fmt::format("{}: must end on the loading curve, which has the pressure {:.6g} at its last closure {:.6g}; it "
                      "ends at {:.6g}",
                      name, wanted, end, curve.pressure.back()));
    if (curve.closure.front() < 0) throw std::invalid_argument(fmt::format("{}: begins at a negative closure", name));
    if (!(end > last))
      throw std::invalid_argument(fmt::format("{}: the curves must be in the order of their ends", name));
    last = end;
  }
  if (unloading.empty()) return;
  // Unloading must not give back more than loading took: checked at the points of the curves, where slopes change.
  std::vector<double> ends(of.loading.closure.begin() + 1, of.loading.closure.end());
  for (const double from : unloading.from) ends.push_back(at(of.loading.pressure, of.loading.closure, from));
  const double rounding = above_curve * of.loading.pressure.back();
  for (const double largest : ends) {
    const double top = pressure_of(of.loading, largest);
    const Unloading back = this->unloading(of, largest);
    const double residual = back.residual * largest;
    std::vector<double> places = of.loading.closure;
    for (const double s : back.s) places.push_back(residual + s * (largest - residual));
    for (const double closure : places) {
      if (closure <= residual || closure >= largest) continue;
      const double unloaded = top * at(back.s, back.r, (closure - residual) / (largest - residual));
      if (const double loaded = pressure_of(of.loading, closure); unloaded > loaded + rounding)
        throw std::invalid_argument(fmt::format(
            "unloading{} from the pressure {:.6g} lies above the loading curve: {:.6g} against {:.6g} at the "
            "closure {:.6g}; unloading must be steeper than loading",
            here, top, unloaded, loaded, closure));
    }
    if (residual < std::min(0.0, of.loading.closure.front()) - shortest_piece * largest)
      throw std::invalid_argument(
          fmt::format("unloading{} from the pressure {:.6g} ends at the closure {:.6g}, before that at which loading "
                      "begins; unloading must be steeper than loading",
                      here, top, residual));
  }
}

GasketLaw::Unloading GasketLaw::unloading(const GasketData& of, double largest) const {
  const GasketUnloading& unloading = of.unloading;
  if (!unloading.from.empty()) {
    std::vector<double> closures;
    for (const double from : unloading.from) closures.push_back(at(of.loading.pressure, of.loading.closure, from));
    const Between found = find_between(closures, largest);
    const double modulus =
        (1 - found.part) * unloading.modulus[found.below] + found.part * unloading.modulus[found.above];
    Unloading line;
    line.residual = 1 - pressure_of(of.loading, largest) * thickness_ / modulus / largest;
    return line;
  }
  const auto shape = [&](std::size_t i) {
    const GasketCurve& curve = unloading.curves[i];
    const double first = curve.closure.front(), last = curve.closure.back();
    Unloading result;
    result.residual = first / last;
    result.s.clear();
    result.r.clear();
    for (std::size_t k = 0; k < curve.closure.size(); ++k) {
      result.s.push_back((curve.closure[k] - first) / (last - first));
      result.r.push_back(curve.pressure[k] / curve.pressure.back());
    }
    return result;
  };
  std::vector<double> ends;
  for (const GasketCurve& curve : unloading.curves) ends.push_back(curve.closure.back());
  const Between found = find_between(ends, largest);
  if (found.part == 0) return shape(found.below);
  return Unloading::mixed(shape(found.below), shape(found.above), found.part);
}

ClosureCurve GasketLaw::curve(double largest, double temperature) const {
  if (pulls_) {
    const GasketCurve& own = data_.front().loading;
    std::vector<Eigen::Vector2d> points;
    for (std::size_t i = 0; i < own.closure.size(); ++i) points.emplace_back(own.closure[i], own.pressure[i]);
    return ClosureCurve(std::move(points), true);
  }
  std::vector<double> temperatures;
  for (const GasketData& one : data_) temperatures.push_back(one.temperature);
  const Between found = find_between(temperatures, temperature);
  const GasketData &below = data_[found.below], &above = data_[found.above];
  const auto loaded = [&](double closure) {
    return (1 - found.part) * pressure_of(below.loading, closure) + found.part * pressure_of(above.loading, closure);
  };
  std::vector<double> closures;
  if (found.part == 0)
    closures = below.loading.closure;
  else
    std::ranges::set_union(below.loading.closure, above.loading.closure, std::back_inserter(closures));
  std::vector<Eigen::Vector2d> points;
  const double shortest = shortest_piece * closures.back(), top = loaded(largest);
  const auto append = [&](double closure, double pressure) {
    if (points.empty() || (closure > points.back().x() + shortest && pressure > points.back().y()))
      points.emplace_back(closure, pressure);
  };
  const bool unloads = has_history() && top > 0;
  if (unloads) {
    const Unloading back = found.part == 0
                               ? unloading(below, largest)
                               : Unloading::mixed(unloading(below, largest), unloading(above, largest), found.part);
    const double residual = back.residual * largest;
    for (std::size_t k = 0; k < back.s.size(); ++k)
      append(residual + back.s[k] * (largest - residual), top * back.r[k]);
  }
  for (std::size_t k = 0; k < closures.size(); ++k) {
    if (unloads && closures[k] <= largest) continue;
    // Where curves begin at different closures, several first points have no pressure: the last of them counts.
    if (points.empty() && k + 1 < closures.size() && loaded(closures[k + 1]) <= 0) continue;
    append(closures[k], loaded(closures[k]));
  }
  // Beyond the last point the last slope goes on.
  const double end = std::max(points.back().x(), closures.back()), beyond = end + (closures.back() - closures.front());
  append(beyond, loaded(beyond));
  return ClosureCurve(std::move(points));
}

double GasketLaw::last_closure() const {
  if (pulls_ && data_.front().loading.closure.size() == 2) return std::numeric_limits<double>::infinity();  // a line
  double least = data_.front().loading.closure.back();
  for (const GasketData& one : data_) least = std::min(least, one.loading.closure.back());
  return least;
}

}  // namespace creepcontact::contact
