#pragma once
/// The magnitude of the stress, against which the error of the creep strain is measured.

#include <span>
#include <vector>

#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/creep/state_layout.hpp"

namespace creepcontact::creep {

/// Scale of the state per body: typical stress / Young's modulus. An error of the creep strain of a fraction of this
/// scale causes a relative error of the stress of at most the same fraction. The scale follows the stress as it
/// relaxes; otherwise the relative error would grow. Fractions have the scale 1; those of a life less, if many cycles
/// of the loads use it up, since their errors add up.
class ErrorScale {
 public:
  /// @param assembly  must outlive the object
  /// @param elastic_stress  per body, the largest typical stress that the loads of the run cause without creep
  /// (ElasticSurvey::stress); not all zero, or empty if nothing creeps. No body counts as stressed by less than 1 % of
  /// the largest.
  /// @param gasket_strain  per pair, ElasticSurvey::gasket_strain; or empty
  ErrorScale(const Assembly& assembly, const std::vector<double>& elastic_stress,
             const std::vector<double>& gasket_strain = {});

  /// Typical stress per body: root mean square of the von Mises stress over its points. Collective.
  static std::vector<double> typical(const Assembly& assembly, const Equilibrium& at);

  /// Adapts the scale to the stress of an accepted step; a body changes only if its scale would change by more than
  /// 10 %.
  /// Collective.
  void follow(const Equilibrium& at);

  /// What a cycle of the loads changes is resolved as a whole: scales of lives become fifty times the largest
  /// change over the points of a body, 1 at most. Collective.
  /// @param change  of the state in the last cycle @param least  change per cycle of a life that does not count
  void resolve_cycle(std::span<const double> change, double least);

  /// Scale of every entry of y (StateLayout).
  std::span<const double> values() const { return values_; }
  /// Scale of the creep strain per body.
  const std::vector<double>& strain() const { return strain_; }
  /// Scale of the strain of gaskets, per pair; 0 where none creeps.
  const std::vector<double>& gasket_strain() const { return gasket_strain_; }
  /// Saves the complete state.
  void save(Memory& memory) const;
  /// Inverse of save(). @throws std::out_of_range if an entry is missing
  void restore(const Memory& memory);
  /// values() without what cycles have made of it.
  std::vector<double> of_whole_run() const;

 private:
  void set(std::size_t body, double strain);
  /// Temperatures of the state: those whose thermal strain is the scale of the creep strain.
  void set_temperatures();
  void set_gasket(std::size_t pair, double strain);
  /// One entry per state variable of a point, without what cycles have made of it.
  std::vector<double> of_point(std::size_t body) const;
  void fill(std::size_t body, std::span<const double> of_point, std::vector<double>& values) const;

  const Assembly& assembly_;
  StateLayout layout_;
  double least_ = 0;
  std::vector<double> strain_, thermal_stress_;              // per body; the stress is the least that counts
  std::vector<double> gasket_strain_, least_gasket_strain_;  // per pair
  /// A state variable that counts life.
  struct Life {
    std::size_t body, column;
    double scale = 1;
    static constexpr auto members =
        std::tuple{Member{"body", &Life::body}, Member{"column", &Life::column}, Member{"scale", &Life::scale}};
  };
  std::vector<Life> lives_;
  std::vector<double> values_;
};

}  // namespace creepcontact::creep
