#pragma once
/// A model with a little more or less of a value, in which nothing is solved: it is evaluated at states of the run.

#include <memory>
#include <vector>

#include "changed_values.hpp"
#include "creepcontact/contact/interface_rows.hpp"
#include "creepcontact/creep/body_laws.hpp"
#include "creepcontact/creep/equilibrium_change.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/results/probes.hpp"
#include "creepcontact/run/run.hpp"

namespace creepcontact::run {

class NearbyModel {
 public:
  /// @param config, kept  must outlive the object @param sign  1: more, -1: less
  /// @param min_strain  as the laws of the run @throws as build_model()
  NearbyModel(const config::Config& config, double sign, Kept& kept, const std::vector<double>& min_strain);
  NearbyModel(const NearbyModel&) = delete;
  NearbyModel& operator=(const NearbyModel&) = delete;

  const model::Model& model() const { return model_; }
  const creep::BodyLaws& laws() const { return laws_; }
  std::span<const std::unique_ptr<results::Probe>> probes() const { return probes_; }

  // All of these are at the time of an equilibrium of the run, of which the first ones need time and conditions alone.
  const mechanics::BodyConditions& conditions(std::size_t body, const creep::Equilibrium& at);
  const creep::LawParameters& law_parameters(std::size_t body, const creep::Equilibrium& at);
  /// Gaps and work of external forces that do not depend on displacements of free unknowns.
  contact::InterfaceLoad load(const creep::Equilibrium& at);
  /// Whether displacements of the run cause other stresses in this body than they do in the run, but for the state.
  bool stresses_differ(std::size_t body, const creep::Equilibrium& at);
  /// The stress that displacements of the run cause with its state changed. @param into  n_points x 6
  void stress(std::size_t body, const creep::Evaluation& at, const mechanics::CreepStrainView& strain_change,
              std::vector<double>& into);
  /// The rate of the laws of a body in a state of the run, n_points x stride.
  void rate(std::size_t body, const creep::Evaluation& at, std::span<double> rate);

  /// Whether some rate is infinite at first, at the stress of the run.
  bool starts_singular(const creep::Evaluation& at);

  /// Takes up the time, state and stress of the run, with their changes.
  void place(const creep::Evaluation& at, const creep::EquilibriumChange& change, std::span<const double> state_change);
  /// What the laws of a body see there.
  creep::PointsState points(std::size_t body) const;
  /// place() with all that results are made of.
  const creep::Evaluation& place_results(const creep::Evaluation& at, const creep::EquilibriumChange& change,
                                         std::span<const double> state_change);

 private:
  std::vector<double> displacement(std::size_t body, const creep::Evaluation& at);
  /// conditions() of all bodies.
  const std::vector<mechanics::BodyConditions>& conditions(const creep::Equilibrium& at);

  double change_;  // of the value, relative to ChangedValue::change
  model::Model model_;
  std::vector<std::unique_ptr<results::Probe>> probes_;
  creep::BodyLaws laws_;
  contact::InterfaceRows rows_;
  creep::Evaluation at_;
};

}  // namespace creepcontact::run
