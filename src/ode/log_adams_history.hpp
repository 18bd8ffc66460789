#pragma once
/// The numbers of an Adams method in logarithmic time: where it knows the rate, and the coefficients of its steps.

#include <array>
#include <cmath>
#include <tuple>

#include "creepcontact/base/memory.hpp"

namespace creepcontact::ode {

/// s = log(1 + (t - origin) / unit): linear in t up to the unit, logarithmic beyond it.
struct LogTime {
  double origin = 0, unit = 1;
  double at(double t) const { return std::log1p((t - origin) / unit); }
  static constexpr auto members = std::tuple{Member{"origin", &LogTime::origin}, Member{"unit", &LogTime::unit}};
};

/// Interpolates F(s) = y'(t) exp(power * s) by a polynomial in s. It is held as scaled divided differences:
/// phi_j = (s_0 - s_1) ... (s_0 - s_j) F[s_0, ..., s_j], with s_0 the newest node.
/// Source: Shampine, Gordon (1975), chapter 5; there with s = t.
class LogAdamsHistory {
 public:
  static constexpr int max_order = 3;
  static constexpr int max_nodes = max_order + 2;
  using Row = std::array<double, max_nodes>;
  using Matrix = std::array<Row, max_nodes>;

  LogTime clock;
  double power = 1;
  int count = 0;  ///< of nodes
  Row nodes{};    ///< the newest first
  static constexpr auto members =
      std::tuple{Member{"clock", &LogAdamsHistory::clock}, Member{"power", &LogAdamsHistory::power},
                 Member{"count", &LogAdamsHistory::count}, Member{"nodes", &LogAdamsHistory::nodes}};

  /// Factors of phi_j in a Newton polynomial whose factors are 1 at s.
  Row stretch(double s) const;
  /// Integrals over t, from the newest node to s, of the first terms of that polynomial.
  Row step_integrals(double s, int terms) const;
  /// step_integrals() from s1 back to s in [s2, s1], with the polynomial that belongs to the phi_j of the newest node.
  Row dense_integrals(double s) const;
  /// Integrals over the last step as step_integrals() would have given them with another power.
  Row last_step_integrals(double other_power, int terms) const;

  void add(double s);
  /// phi_j of the polynomial at other nodes, for F times exp(power_change * s): rows times the present ones.
  Matrix moved(const Row& to, double power_change) const;

 private:
  Row integrals(double from, double to, double with_power, const Row& zeros, const Row& scales, int terms) const;
};

}  // namespace creepcontact::ode
