#pragma once
/// Creep of gaskets at the contact nodes: the strain closure/thickness under the uniaxial stress -pressure, by the same
/// laws as in bodies.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/creep/state_layout.hpp"
#include "creepcontact/material/creep_law.hpp"

namespace creepcontact::creep {

/// All creeping gaskets of an assembly. States, their rates and changes are whole vectors like y (StateLayout), of
/// which the gaskets' part is read or set.
class GasketCreep {
 public:
  /// @param assembly  must outlive the object @param min_strain  per pair, see material::PointState
  GasketCreep(const Assembly& assembly, std::vector<double> min_strain);

  /// True if no gasket creeps, or another process has them.
  bool empty() const { return gaskets_.empty(); }
  /// Sets the closures by creep, per node of the contact problem; of no size if no gasket creeps. Collective: all
  /// processes have them.
  void closures(std::span<const double> state, std::vector<double>& into) const;

  /// Rates at the pressures of an equilibrium.
  void rate(const Equilibrium& at, std::span<const double> state, std::span<double> rate) const;
  /// Their change. @param multiplier  change of the multipliers @param change  of the state
  void derivative(const Equilibrium& at, std::span<const double> state, const Eigen::VectorXd& multiplier,
                  std::span<const double> change, std::span<double> product) const;
  /// The smallest start exponent (CreepLaw::start_exponent), and increments (CreepLaw::increment) at constant pressure.
  double start_exponent(double t, const Equilibrium& at, std::span<const double> state) const;
  void add_increment(double t, double duration, const Equilibrium& at, std::span<const double> state,
                     std::span<double> change) const;

  /// The Jacobian at each node, n_state x n_state in turn: by the state alone, and by the pressure (column n_state).
  using Jacobians = std::vector<Eigen::MatrixXd>;
  Jacobians jacobians(const Equilibrium& at, std::span<const double> state) const;
  /// z = (I - gamma J)^-1 r node by node, where the pressure of a node follows its own closure.
  /// @param flexibility  F_ii + compliance per row, of the contact problem
  void precondition(const Jacobians& at, const Eigen::VectorXd& flexibility, double gamma, std::span<const double> r,
                    std::span<double> z) const;
  /// Eliminates the states from a Newton system (I - gamma J) z = r: given r, by how much the gaps open at constant
  /// pressure, and the compliance that creep adds, per row.
  struct Eliminated {
    Eigen::VectorXd opening, compliance;
  };
  Eliminated eliminated(const Jacobians& at, double gamma, std::span<const double> r, Eigen::Index n_rows) const;
  /// The solution z for a change of the multipliers.
  void solution(const Jacobians& at, double gamma, std::span<const double> r, const Eigen::VectorXd& multiplier,
                std::span<double> z) const;
  /// A bound on the eigenvalues of -J over the nodes, the pressure of a node following its own closure.
  double stiffest_rate(const Jacobians& at, const Eigen::VectorXd& flexibility) const;

 private:
  struct Mechanism {
    const material::CreepLaw* law;
    std::size_t first, n;  // of its variables in the state of a node
  };
  struct OfPair {
    std::size_t pair;
    const contact::Pair* contact;
    std::vector<Mechanism> mechanisms;
    std::size_t n_nodes, n_state, first;  // of the states
    double thickness, stress_per_pressure;
  };
  /// Calls work(gasket, node, its first state, sight) for all nodes; `sight` makes the PointState of a mechanism.
  template <typename Work>
  void for_each_node(const Equilibrium& at, std::span<const double> state, const Work& work) const;
  template <typename Work>
  void for_each_state(const Work& work) const;

  const Team* team_;
  std::vector<double> min_strain_;  // per pair
  bool creeps_ = false;             // a gasket of some process
  std::vector<OfPair> gaskets_;
  std::size_t n_contact_nodes_ = 0;
};

/// Typical elastic strain of each creeping gasket (root mean square of pressure over unloading modulus), per pair; 0 of
/// other pairs. Collective.
std::vector<double> typical_gasket_strains(const Assembly& assembly, const Equilibrium& at);

}  // namespace creepcontact::creep
