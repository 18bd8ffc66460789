#pragma once
/// Plastic flow linearised at an equilibrium: what a change of the creep strains changes of it.

#include <functional>
#include <span>
#include <vector>

#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"

namespace creepcontact::creep {

/// Points that have flowed in the step to an equilibrium go on to, in the mean direction m of that step:
///   d eps_p = 3/2 m d,   H d = 3/2 m : d sigma,   H = d sy/dp + sum C_i - 3/2 m : sum gamma_i X_i
/// With the stress that d eps_p takes back, this is a symmetric linear system for the d of all points, positive
/// definite below the limit load (J. C. Simo, T. J. R. Hughes, Computational Inelasticity, 1998, with the continuum
/// moduli). Solved by conjugate gradients with one elastic solve in each iteration. Collective.
class PlasticTangent {
 public:
  using Response =
      std::function<void(std::span<const mechanics::CreepStrainView> strain, std::vector<std::vector<double>>& stress)>;

  /// @param assembly  must outlive the object
  PlasticTangent(const Assembly& assembly, const Equilibrium& at);

  /// True if no point flows on any process.
  bool is_elastic() const { return is_elastic_; }
  /// Adds to a change of stress what the flow changes of it. @param stress  of all bodies, n_points x 6, without flow
  /// @param response  the change of stress for a change of initial strains with elastic moduli: to be written
  void add_flow(std::vector<std::vector<double>>& stress, const Response& response) const;

 private:
  struct Point {
    std::size_t body, point;
    Tensor6 direction;           // 3/2 m
    double hardening, diagonal;  // H and H + 3 G, times the volume
    double weight;               // volume
  };
  double dot(std::span<const double> a, std::span<const double> b) const;

  const Assembly& assembly_;
  std::vector<Point> points_;
  bool is_elastic_ = true;
};

}  // namespace creepcontact::creep
