#pragma once
/// A point of a material that yields, by small explicit steps of its rate equations: without a return to the yield
/// surface, so that nothing of what the program does is repeated.
///
///   d sigma = H (d eps - 3/2 N dp),  N = (s - X)/J(s - X),  dX_i = C_i N dp - gamma_i X_i dp,  d sy = H' dp

#include <utility>
#include <vector>

#include "creepcontact/base/tensor.hpp"

namespace creepcontact::test {

struct PlasticRates {
  double young_modulus, poisson_ratio, yield_stress, hardening_modulus = 0;
  std::vector<std::pair<double, double>> back = {};  ///< C, gamma
};

class PlasticPath {
 public:
  /// A straight way. Together with shear strains that stay zero, from the last one on, the conditions are six.
  struct Way {
    std::vector<std::pair<Tensor6, double>> strain;  ///< d and the change of d : strain
    std::vector<Tensor6> free;                       ///< d whose d : stress stays as it is
  };
  explicit PlasticPath(PlasticRates law);

  /// @param n_steps  while it flows
  void follow(const Way& way, int n_steps);

  const Tensor6& stress() const { return now_.stress; }
  const Tensor6& strain() const { return now_.strain; }
  double accumulated() const { return now_.p; }

 private:
  struct State {
    Tensor6 strain = Tensor6::Zero(), stress = Tensor6::Zero();
    double p = 0;
    std::vector<Tensor6> back;  ///< X_i
  };
  Tensor6 relative_stress(const State& at) const;
  double yield_stress(const State& at) const { return law_.yield_stress + law_.hardening_modulus * at.p; }
  /// The rate along a way of length 1. @param yields  else elastic
  State rate(const State& at, const Way& way, bool yields) const;
  static State moved(const State& from, const State& rate, double length);
  /// The part of an elastic way up to the yield surface; more than 1 if it does not get there.
  double part_to_yield(const Way& way) const;

  PlasticRates law_;
  Matrix6 elasticity_;
  State now_;
};

}  // namespace creepcontact::test
