#pragma once
/// Temperatures as a part of the state: what they do to the points of the bodies, and what contact does to their rates.

#include <map>
#include <span>
#include <vector>

#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/evaluation.hpp"
#include "creepcontact/creep/joint_values.hpp"
#include "creepcontact/creep/state_layout.hpp"
#include "creepcontact/heat/rate_form.hpp"

namespace creepcontact::creep {

/// One thread at a time.
class HeatCoupling {
 public:
  /// @param assembly  with heat; must outlive the object
  explicit HeatCoupling(const Assembly& assembly);

  heat::RateForm& rates() { return rates_; }
  /// With the temperatures that are given at time t.
  std::vector<double> completed(double t, std::span<const double> T);
  /// Temperatures at the points of each body. @param T  of the unknowns, at time t
  std::vector<std::vector<double>> at_points(double t, std::span<const double> T);
  /// Values of the unknowns, interpolated to the points of each body.
  std::vector<std::vector<double>> interpolated(std::span<const double> values);
  /// The strain without stress that a change of the temperatures causes, n_points x 6 per body: thermal strain, and
  /// what the change of Young's modulus takes from the elastic strain.
  std::vector<std::vector<double>> strain_change(const Equilibrium& at,
                                                 const std::vector<std::vector<double>>& T_change) const;

 private:
  const Assembly& assembly_;
  heat::RateForm rates_;
  std::vector<std::map<mesh::CellType, Eigen::MatrixXd>> shapes_;  // of the bodies, one row per point of an element
};

}  // namespace creepcontact::creep
