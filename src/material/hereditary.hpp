#pragma once
/// Linear viscoelastic creep: the strain follows from the history of the stress (Boltzmann 1874, Volterra 1909) with
/// the kernel of a Prony series. This is a chain of Kelvin elements with the strains e_i, and a dashpot in series with
/// it:
///   tau_i d e_i/dt = 3/2 J_i s + (B_i/9) tr(sigma) I - e_i,   rate = sum of d e_i/dt + 3/2 fluidity s.
/// In a uniaxial test sigma gives the creep strain sigma (sum of J_i (1 - exp(-t/tau_i)) + fluidity t); under the mean
/// stress p volume creeps by p sum of B_i (1 - exp(-t/tau_i)). Special cases: kelvin_voigt (one element), maxwell (the
/// dashpot; with the material's elasticity a Maxwell body), burgers (both).
/// Internal variables: e_i, 6 per Kelvin element. Limits: parameters may depend on T, but no time-temperature shift is
/// made.

#include "creepcontact/base/index.hpp"
#include "creepcontact/material/creep_law.hpp"
#include "law_table.hpp"

namespace creepcontact::material {

inline constexpr StateVariable kelvin_strain{
    .name = "kelvin_strain",
    .description =
        "strain of all Kelvin elements together, which recovers after unloading; tensor components; 0 where "
        "there are none",
    .label = "Kelvin strain",
    .is_tensor = true,
    .of_several = StateVariable::OfSeveralLaws::sum};

class Hereditary final : public CreepLaw {
 public:
  enum Constant {
    compliances,             ///< uniaxial J_i [1/stress], >= 0; empty: a dashpot alone
    times,                   ///< of retardation tau_i [time], > 0
    volumetric_compliances,  ///< B_i [1/stress], >= 0; empty: volume does not creep
    fluidity,                ///< uniaxial [1/(stress time)], >= 0; empty: 0
    n_constants
  };
  /// @throws ParameterError if the lists differ in length
  Hereditary(std::string name, const ParameterValues& values);
  std::string name() const override { return name_; }
  int n_internal() const override { return static_cast<int>(6 * n_elements_); }

  bool is_linear() const override { return true; }
  void rate(const PointState& at, PointRate into) const override;
  void derivative(const PointState& at, const PointChange& change, PointRate into) const override;
  StressTangent stress_tangent(const PointState& at) const override;
  /// Exact.
  void increment(const PointState& at, double duration, PointIncrement into) const override;
  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;

 private:
  /// The values of the parameters at a point.
  struct Chain {
    double fluidity;
    std::span<const double> J, tau, B;  ///< n_elements_; B empty: volume does not creep
  };
  /// The strains to which the elements tend under a stress that stays.
  class Limits {
   public:
    Limits(const Chain& chain, const tensor::ConstMap& stress);
    Tensor6 of(int element) const;
    const Tensor6& deviator() const { return deviator_; }

   private:
    const Chain& chain_;
    Tensor6 deviator_;  ///< 3/2 s
    double mean_;       ///< tr(sigma)/9
  };
  Chain chain(const PointState& at) const;

  std::string name_;
  Index n_elements_;
  bool volumetric_;
};

LawInfo hereditary_info();
LawInfo kelvin_voigt_info();
LawInfo maxwell_info();
LawInfo burgers_info();

}  // namespace creepcontact::material
