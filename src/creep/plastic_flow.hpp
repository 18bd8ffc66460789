#pragma once
/// The plastic strains of all bodies in equilibrium: a fixed-point iteration on the factors of the elastic stiffness.

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "anderson_mixing.hpp"
#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"
#include "plastic_points.hpp"

namespace creepcontact::creep {

/// A history of bodies that may yield and have not; without bodies if no material yields.
PlasticHistory virgin_plastic_history(const Assembly& assembly);

/// The iteration of one equilibrium. With the plastic strain of the last accepted step and a guess g of its change, the
/// elastic solver finds stresses; the return of material::Plasticity makes of these another change f(g); what is sought
/// is g = f(g), by Anderson mixing. Where nothing yields one solve is enough, and it is the same as without plasticity.
///
///   PlasticFlow flow(assembly, history, t, conditions, tolerance);
///   do solve(flow.strains(creep)); while (!flow.advance(equilibrium));
///
/// Collective. Refers to its arguments.
class PlasticFlow {
 public:
  /// @param from  the last accepted step; not empty @param at  the conditions at t, one per body
  /// @param tolerance  of the change of the stress in an iteration, relative to the stress, energy norm
  /// @param goes_on  the first guess: the flow of the last step goes on, or nothing flows
  /// @param part  of the loads that acts, for messages
  /// @throws SolverError for constants that are not admissible
  PlasticFlow(const Assembly& assembly, const PlasticHistory& from, double t,
              std::span<const mechanics::BodyConditions> at, double tolerance, bool goes_on = true, double part = 1);

  /// Creep and plastic strains for the next solve, one view per body; those of bodies without plastic strain are
  /// `creep`.
  std::span<const mechanics::CreepStrainView> strains(std::span<const mechanics::CreepStrainView> creep);
  /// Takes the stress that solve() has found. @returns true when the plastic strain has converged: `into` then has it,
  /// and stresses that meet the yield condition
  /// @throws SolverError if the bodies cannot carry the loads
  bool advance(Equilibrium& into);
  /// The largest change of the equivalent stress since the last accepted step, relative to the yield stress; 0 if the
  /// stress leaves the yield surface nowhere. @param at  of the first solve, without a guess
  double excursion(const Equilibrium& at) const;
  /// An estimate of the error that the return has made in the last two steps, from the same way in one step: of the
  /// equivalent stress, largest of all points, relative to the yield stress.
  /// @param before  the history before both @param at  the end of the second step
  double redone_error(const std::vector<PlasticState>& before, const Equilibrium& at) const;
  /// The largest difference of two states at the end, of the equivalent stress or of the elastic stress of the plastic
  /// strain, relative to the yield stress.
  double difference(const PlasticHistory& a, const PlasticHistory& b) const;

 private:
  struct Body {
    std::size_t number;
    PlasticPoints points;
    std::vector<double> guess = {}, flow = {};  // changes of the plastic strain, n_points x 6; empty: zero
    std::vector<double> accumulated = {};       // change of p, n_points
    std::vector<double> back = {};              // alpha_i at the end
    std::vector<double> strain = {};            // creep + plastic strain + guess; empty: no plastic strain
    std::vector<std::int32_t> active = {};      // points that have or had a change, in the order in which they came
    std::vector<char> is_active = {};           // per point
  };
  /// Returns all points to the yield surface. @returns true if a point flows on any process
  bool return_stress(const Equilibrium& at);
  bool return_own_stress(const Equilibrium& at);
  /// True if a stress is outside the yield surface of the last accepted step by more than a margin.
  bool yields(const Body& body, std::size_t point, const std::vector<double>& stress, double margin = 0) const;
  /// True if it is so anywhere. Cost: one pass over the stress, also of bodies that never yield
  bool any_yields(const Body& body, const std::vector<double>& stress) const;
  void activate(Body& body, std::size_t point);
  std::string loads() const;
  std::string place(const Body& body, std::size_t point) const;
  double yield_before(const Body& body, std::size_t point) const;
  double elastic_strain_at_yield(const Body& body, std::size_t point) const;
  void give_up() const;
  void require_limited_flow(const Body& body, std::size_t point, double change) const;
  /// The changes of active points times the root of 2 G times the volume: energies are squares of their norms.
  void gather(std::vector<double>& guess, std::vector<double>& flow) const;
  void scatter(std::span<const double> guess);
  double root_of_energy(const Body& body, std::size_t point) const;
  void finish(Equilibrium& into) const;

  const Assembly& assembly_;
  const PlasticHistory& from_;
  double time_;
  std::span<const mechanics::BodyConditions> at_;
  double tolerance_, part_;
  std::vector<Body> bodies_;  // those that may yield
  std::vector<mechanics::CreepStrainView> views_;
  AndersonMixing mixing_;
  int n_iterations_ = 0;
};

}  // namespace creepcontact::creep
