#pragma once
/// Results at the multiplier nodes of a contact pair.

#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/heat/local_values.hpp"

namespace creepcontact::results {

/// Values at one multiplier node. A tied surface carries a vector: its pressure is the part along the normal (tension
/// negative), and its gap is zero.
struct ContactValues {
  double pressure = 0;
  double gap = 0;
  Vector3 traction = Vector3::Zero();                          ///< on the slave body
  double shear = 0;                                            ///< magnitude of the tangential traction
  double slip = 0;                                             ///< accumulated [length]; 0 without friction
  double closure = 0, largest_closure = 0, creep_closure = 0;  ///< of a gasket; see the quantities
  double temperature_jump = 0, conductance = 0;                ///< of heat, means over the linear function of the node
  double status = 0;  ///< 0: open, 1: stick, 2: slip (a closed contact without friction slips)
};

/// The values of a pair at one state, by its multiplier nodes. Pair and state must outlive it. With a gasket the
/// constructor evaluates the temperatures of all nodes; each node then costs a few operations.
class PairValues {
 public:
  /// @param heat  of the nodes of all pairs, or empty; must outlive the object
  PairValues(const contact::Pair& pair, const creep::Equilibrium& at, std::span<const heat::NodeOfInterface> heat = {});

  ContactValues operator[](std::size_t node) const;
  /// Distances of the surfaces at all nodes, weighted by their areas; with a gasket those from it as it is left, zero
  /// where it is pressed.
  Eigen::VectorXd open_gaps() const;

 private:
  double open_gap(std::size_t node) const;

  const contact::Pair& pair_;
  const creep::Equilibrium& at_;
  std::span<const heat::NodeOfInterface> heat_;
  std::vector<double> temperatures_, growth_;  // of the gasket
};

/// Sum of pressure times nodal area over the pair; of a preloaded tied contact the tension across it. @param
/// multipliers  of all pairs
double normal_force(const contact::Pair& pair, const Eigen::VectorXd& multipliers);

/// Young's modulus at the reference temperature of the material; 0 if it is not defined there.
double scale_modulus(const mechanics::Body& body);
/// Stress relative to Young's modulus that rounding alone may make.
inline constexpr double round_off_strain = 1e-14;
/// Normal force that rounding alone may make: that of such a stress of the softer body.
double round_off_force(const creep::Assembly& assembly, const contact::Pair& pair);

}  // namespace creepcontact::results
