#pragma once
/// The result of one elastic solve, and the history of accepted steps that later solves start from: plain values.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "creepcontact/base/memory.hpp"
#include "creepcontact/contact/gasket.hpp"
#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/mechanics/body_conditions.hpp"

namespace creepcontact::creep {

/// Mechanical state of one body.
struct BodyState {
  std::vector<double> displacement;  ///< 3 n_nodes
  std::vector<double> stress;        ///< n_points x 6, Mandel order
};

/// Creep strains of all bodies, closures of creeping gaskets, and temperatures if they are part of the state. Refers to
/// values of the caller.
class CreepStrains {
 public:
  // NOLINTBEGIN(google-explicit-constructor): without creeping gaskets the views are all
  CreepStrains(std::span<const mechanics::CreepStrainView> bodies, std::span<const double> closures = {},
               std::span<const std::vector<double>> temperatures = {})
      : bodies_(bodies), closures_(closures), temperatures_(temperatures) {}
  CreepStrains(const std::vector<mechanics::CreepStrainView>& bodies) : bodies_(bodies) {}
  // NOLINTEND(google-explicit-constructor)

  const mechanics::CreepStrainView& operator[](std::size_t body) const { return bodies_[body]; }
  std::size_t size() const { return bodies_.size(); }
  std::span<const mechanics::CreepStrainView> bodies() const { return bodies_; }  ///< one per body
  /// Closures by creep, per node of the contact problem [length]; empty: none.
  std::span<const double> closures() const { return closures_; }
  /// Temperatures at the points of each body; empty: those of its field hold.
  std::span<const std::vector<double>> temperatures() const { return temperatures_; }

 private:
  std::span<const mechanics::CreepStrainView> bodies_;
  std::span<const double> closures_;
  std::span<const std::vector<double>> temperatures_;
};

/// Displacements of all bodies on their free dofs, n_free each; a body without numbers: u = 0.
using FreeDisplacements = std::vector<std::vector<double>>;

/// Slip of contacts with friction up to some time. Vectors over rows are zero in rows without friction, but for `gap`.
struct SlipHistory {
  double time = 0;
  Eigen::VectorXd slip;       ///< weighted tangential gaps since the unloaded state, per row; zero in normal rows
  Eigen::VectorXd gap;        ///< weighted gaps of all rows, tangential ones as `slip`; empty: not known
  Eigen::VectorXd direction;  ///< contact::Friction::direction, per row
  /// Rates over the last substep, per row. Tangential rows: of `slip` where the node was open at both ends or slips at
  /// the last one. Normal row: of the weighted gap where the node was open at both ends, of the pressure where it
  /// slips.
  Eigen::VectorXd rate;
  Eigen::VectorXd path;            ///< accumulated slip [length] while in contact, per contact node
  std::vector<double> dissipated;  ///< energy, per pair
  bool is_fresh = true;            ///< nothing is known of rates: at t = 0 and right after a breakpoint
  static constexpr auto members = std::tuple{Member{"time", &SlipHistory::time},
                                             Member{"slip", &SlipHistory::slip},
                                             Member{"gap", &SlipHistory::gap},
                                             Member{"direction", &SlipHistory::direction},
                                             Member{"rate", &SlipHistory::rate},
                                             Member{"path", &SlipHistory::path},
                                             Member{"dissipated", &SlipHistory::dissipated},
                                             Member{"is_fresh", &SlipHistory::is_fresh}};
};

/// What the points of a body have from its yielding; arrays over its integration points, empty where nothing yields.
struct PlasticState {
  std::vector<double> strain;       ///< n_points x 6, Mandel order; empty: nothing has flowed
  std::vector<double> accumulated;  ///< n_points
  std::vector<double> back;         ///< n_points x n_back x 6: alpha_i of material::Plasticity
  std::vector<double> rate;         ///< n_points x 6: of the strain over the last step; empty: nothing flowed in it
  std::vector<double> stress;       ///< n_points x 6 at the end of the last step
  std::vector<double> creep;        ///< n_points x 6: the creep strain there, of bodies that do not yield too
  static constexpr auto members =
      std::tuple{Member{"strain", &PlasticState::strain}, Member{"accumulated", &PlasticState::accumulated},
                 Member{"back", &PlasticState::back},     Member{"rate", &PlasticState::rate},
                 Member{"stress", &PlasticState::stress}, Member{"creep", &PlasticState::creep}};
};

/// In memories: arrays whose names have this part, and then the number of a body, are over its integration points.
inline constexpr std::string_view point_arrays = "of_points", point_arrays_before = "before.of_points";

/// Yielding up to some time.
struct PlasticHistory {
  double time = 0;
  double smooth_since = 0;           ///< loads have no jump or kink between then and `time`
  bool flows = false;                ///< something has flowed in the last step
  std::vector<PlasticState> bodies;  ///< one per body; empty: nothing yields, whatever the stress
  std::vector<PlasticState> before;  ///< `bodies` of the step before; empty: the last one was the first since a kink
  /// Sum over the steps of the estimated errors of the return, of the equivalent stress relative to the yield stress.
  double error = 0;
  static constexpr auto members = std::tuple{Member{"time", &PlasticHistory::time},
                                             Member{"smooth_since", &PlasticHistory::smooth_since},
                                             Member{"flows", &PlasticHistory::flows},
                                             Member{point_arrays, &PlasticHistory::bodies},
                                             Member{point_arrays_before, &PlasticHistory::before},
                                             Member{"error", &PlasticHistory::error}};
};

/// A state of contact on the way of the loads, from which contact and slip go on.
struct PathPoint {
  contact::ContactState contact;
  SlipHistory friction;
  static constexpr auto members =
      std::tuple{Member{"contact", &PathPoint::contact}, Member{"friction", &PathPoint::friction}};
};

/// How the path of friction and of plastic flow is followed when a step is accepted.
struct PathOptions {
  /// Error of tractions and slip per substep, relative to their largest values, and of the stress by flow, relative to
  /// the yield stress. Infinity: flow is not followed in parts.
  double tolerance = 1e-3;
  double interval = 0;  ///< time between the breakpoints around the step; 0: the step is all of it
};

/// Elastic equilibrium of all bodies in contact at one time. Owned by the caller of EquilibriumSolver::solve(), which
/// reuses its memory; it holds no reference to the solver.
struct Equilibrium {
  double time = 0;
  std::vector<mechanics::BodyConditions> conditions;  ///< one per body
  std::vector<BodyState> bodies;
  contact::ContactState contact;  ///< multipliers (contact pressures), rigid-body modes, rows in contact (ascending)
  /// Weighted gaps of all contact rows; in tangential rows the slip since the history that the solve started from.
  /// With gaskets: from their faces, as thin as they have become by creep.
  Eigen::VectorXd gaps;
  std::vector<double> interference;   ///< of preloaded contacts, per pair; zero for others
  SlipHistory friction;               ///< what the history becomes if this is accepted; empty without friction
  PlasticHistory plastic;             ///< likewise; empty if no material yields
  Eigen::VectorXd largest_closure;    ///< GasketHistory::largest if this is accepted; empty without gaskets
  std::vector<double> creep_closure;  ///< of gaskets, that it was solved with: CreepStrains::closures()
  double stiffness_scale = 1;         ///< s: stiffness at this time relative to that of the factors
  FreeDisplacements displacements;    ///< empty unless the stiffness changes in time
  std::int64_t factors = 0;           ///< number of the factorisation with which they were found
};

/// What evaluations depend on in addition to their arguments. Only accepted steps change it, and checkpoints store it.
struct History {
  contact::ContactState contact;     ///< of the last accepted step; contact iterations start from it
  SlipHistory friction;              ///< empty vectors without friction
  PlasticHistory plastic;            ///< empty: nothing yields
  contact::GasketHistory gaskets;    ///< empty: there are none
  std::vector<double> interference;  ///< that preloads have been given, per pair
  /// Weighted gaps that rows of relative pairs had when they began to act, negative; empty if there are none.
  Eigen::VectorXd reached;
  double preloaded_until = -1;  ///< preloads and relative pairs up to this time have been applied
  struct Accepted {
    double time = 0;
    FreeDisplacements displacements;
    std::int64_t factors = 0;
    static constexpr auto members =
        std::tuple{Member{"time", &Accepted::time}, Member{"displacements", &Accepted::displacements},
                   Member{"factors", &Accepted::factors}};
  };
  std::vector<Accepted> accepted;         ///< the last two steps, latest first; only if the stiffness changes in time
  std::vector<std::int64_t> set_changes;  ///< per pair: accepted steps at which its set of closed rows changed
  static constexpr auto members = std::tuple{Member{"contact", &History::contact},
                                             Member{"friction", &History::friction},
                                             Member{"plastic", &History::plastic},
                                             Member{"gaskets", &History::gaskets},
                                             Member{"interference", &History::interference},
                                             Member{"reached", &History::reached},
                                             Member{"preloaded_until", &History::preloaded_until},
                                             Member{"accepted", &History::accepted},
                                             Member{"set_changes", &History::set_changes}};
};

/// A part of the path of an accepted step.
struct PathLeg {
  History before;
  double end = 0;                 ///< time
  std::vector<PathPoint> points;  ///< of friction, that of the history first; empty without friction
};

using creepcontact::Memory;

}  // namespace creepcontact::creep
