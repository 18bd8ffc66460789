#pragma once
/// A gasket between the two surfaces of a contact pair: a law of the pair, without elements and without a mesh.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/memory.hpp"
#include "creepcontact/contact/gasket_law.hpp"
#include "creepcontact/material/material.hpp"
#include "creepcontact/mechanics/temperature_field.hpp"

namespace creepcontact::contact {

/// What gaskets of one kind are made of.
struct GasketKind {
  std::string name;
  GasketLaw law;
  Function expansion = 0.0;  ///< thermal, through the thickness, a function of T: strain per degree from the reference
  double reference_temperature = 0;
  /// Its creep laws, for the uniaxial stress -p: the rate of the creep closure is the thickness times that of the
  /// strain. Null: none.
  std::shared_ptr<const material::Material> creep = nullptr;
  /// What the laws take for the stress, per pressure: 1, or the area of a spring, whose stress is its force.
  double stress_per_pressure = 1;
  bool is_spring = false;  ///< of [[springs]]; for messages
};

/// Immutable; its nodes are the multiplier nodes of a pair.
class Gasket {
 public:
  /// @param temperature  of the bodies around it; nullopt: its reference temperature
  /// @param positions  of the nodes
  Gasket(std::shared_ptr<const GasketKind> kind, const std::optional<mechanics::TemperatureField>& temperature,
         std::vector<Vector3> positions);

  const GasketKind& kind() const { return *kind_; }
  const std::vector<Vector3>& positions() const { return positions_; }
  /// Temperatures of all nodes at time t.
  std::vector<double> temperatures(double t) const;
  /// Changes of its free thickness from the reference temperature on, at all nodes at time t [length].
  std::vector<double> growth(double t) const;

 private:
  std::shared_ptr<const GasketKind> kind_;
  std::vector<Vector3> positions_;
  std::unique_ptr<const mechanics::TemperatureAtPositions> temperature_;  // null: the reference temperature
};

/// What gaskets have gone through, per node of the contact problem; zero in nodes without one. Empty: no gaskets.
struct GasketHistory {
  Eigen::VectorXd largest;          ///< closure without creep
  Eigen::VectorXd closure, before;  ///< at the end of the last two steps, since the last breakpoint; empty: not known
  double time = 0, time_before = 0;
  std::vector<double> creep;  ///< closure by creep at the end of the last step; empty: none
  Eigen::VectorXd error;      ///< estimated, of `largest`; empty: no step has ended
  Eigen::VectorXd summit;     ///< found within the last step, which the next one finds again; zero: none
  static constexpr auto members = std::tuple{Member{"largest", &GasketHistory::largest},
                                             Member{"closure", &GasketHistory::closure},
                                             Member{"before", &GasketHistory::before},
                                             Member{"time", &GasketHistory::time},
                                             Member{"time_before", &GasketHistory::time_before},
                                             Member{"creep", &GasketHistory::creep},
                                             Member{"error", &GasketHistory::error},
                                             Member{"summit", &GasketHistory::summit}};

  /// Takes the closures at the end of a step into it. Where a closure has turned within the last two steps, the largest
  /// one is that of the parabola through the last three. Its error is by how much it exceeds the three points, until
  /// the parabola of the next step finds the same summit: then the difference of both.
  void advance(double t, const Eigen::VectorXd& closures);
  /// Forgets the steps at a breakpoint, where closures may have a kink.
  void begin_segment() {
    before.resize(0);
    summit.resize(0);
  }
};

}  // namespace creepcontact::contact
