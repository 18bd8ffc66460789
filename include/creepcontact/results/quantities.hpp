#pragma once
/// The output variables of a run, declared once: probes, arrays of the field files, lists and labels of plots follow.

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "creepcontact/base/units.hpp"
#include "creepcontact/results/contact_values.hpp"
#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::results {

// Supports: where a variable is defined, with the evaluator that gives all its components there.

/// Nodes of a body: a function of position and displacement alone, which needs no smoothed field.
struct AtNodes {
  static constexpr std::string_view places = "point, group, body";
  static constexpr bool is_sum = false;
  std::function<void(const Sample& sample, double* components)> evaluate;
};

/// Integration points of a body; at nodes the function of the smoothed fields.
struct AtPoints {
  static constexpr std::string_view places = "point, group, body";
  static constexpr bool is_sum = false;
  std::function<void(const Sample& sample, double* components)> evaluate;
};

/// Multiplier nodes of contact surfaces: a scalar. The files of contact surfaces have it.
struct AtMultipliers {
  static constexpr std::string_view places = "contact surface";
  static constexpr bool is_sum = false;
  double ContactValues::*value;
  /// Which models have it in the field files.
  enum class In { all, with_friction, with_gaskets, with_heat } models = In::all;
  bool in_body_files = true;  ///< also in the field files of bodies
};

/// Contact surfaces: means over the width, at sections around the axis of the probe.
struct OverWidth {
  static constexpr std::string_view places = "contact surface";
  static constexpr bool is_sum = false;
  double ContactValues::*value;
};

/// A spring, which the probe names.
struct OnSpring {
  static constexpr std::string_view places = "spring";
  static constexpr bool is_sum = false;
  double (*evaluate)(const contact::Pair& spring, const creep::Equilibrium& at);
};

/// Force and moment on a part of a body.
struct Resultant {
  Vector3 force = Vector3::Zero();
  Vector3 moment = Vector3::Zero();  ///< about the origin of the probe
};

/// A contact surface: the resultant of the contact forces on its body.
struct OnContactSurface {
  static constexpr std::string_view places = "contact surface";
  static constexpr bool is_sum = true;
  void (*evaluate)(const Resultant& resultant, double* components);
};

/// A contact surface: the area in contact (contact::ContactArea).
struct AreaInContact {
  static constexpr std::string_view places = "contact surface";
  static constexpr bool is_sum = true;
};

/// A supported group: the force of its supports on the body.
struct OnSupports {
  static constexpr std::string_view places = "supported group";
  static constexpr bool is_sum = true;
  void (*evaluate)(const Vector3& force, double* components);
};

/// The cross-section of a body in generalised plane strain: a scalar. The evaluator is collective.
struct OnCrossSection {
  static constexpr std::string_view places = "body";
  static constexpr bool is_sum = false;
  double (*evaluate)(const Snapshot& snapshot, std::size_t body);
};

/// A plane through a body: the resultant of the stress on it.
struct OnPlane {
  static constexpr std::string_view places = "plane through a body";
  static constexpr bool is_sum = true;
  void (*evaluate)(const Resultant& resultant, double* components);
};

/// A surface: the heat that leaves the bodies through it.
struct ThroughSurface {
  static constexpr std::string_view places = "surface";
  static constexpr bool is_sum = true;
};

using Support = std::variant<AtNodes, AtPoints, AtMultipliers, OverWidth, OnSpring, OnContactSurface, AreaInContact,
                             OnSupports, OnCrossSection, OnPlane, ThroughSurface>;

struct OutputVariable {
  std::string name;
  std::vector<std::string> components = {};  ///< suffixes of their names; empty: a scalar
  std::string description;
  std::string label;  ///< for axes of plots
  Dimension dimension = Dimension::none;
  Support support;
  std::string point_array = {};  ///< of fields of bodies: name in the field files at nodes; empty: not there
  std::string cell_array = {};   ///< the same of element means
  bool cylindrical = false;      ///< components about the z axis; a probe may turn the sample to another axis
  bool about_origin = false;     ///< a moment: the probe gives its `origin`
  bool is_of_heat = false;       ///< exists without mechanics
  bool needs_heat = false;       ///< only where the temperature is computed
  /// If not null, field files have the variable only if a material has this one.
  const material::StateVariable* state_variable = nullptr;

  template <class Kind>
  bool is() const {
    return std::holds_alternative<Kind>(support);
  }
  /// Defined at every point of a body.
  bool is_field() const { return is<AtNodes>() || is<AtPoints>(); }
  /// A sum over a whole surface, group or plane.
  bool is_sum() const {
    return std::visit([](const auto& where) { return where.is_sum; }, support);
  }
  /// Where a probe of it may be, as lists say it.
  std::string_view places() const {
    return std::visit([](const auto& where) { return where.places; }, support);
  }
  std::size_t n_components() const { return components.empty() ? 1 : components.size(); }
  /// Sets all components. Precondition: is_field()
  void evaluate(const Sample& sample, double* into) const;
};

const std::vector<OutputVariable>& output_variables();

/// A scalar for probes: a component of a variable.
struct Quantity {
  std::string name;  ///< "stress_xx"
  const OutputVariable* variable;
  int component;

  /// The component of what an evaluator gives. @param evaluate  (double* components)
  template <class Evaluate>
  double of(const Evaluate& evaluate) const {
    std::array<double, 6> components;
    evaluate(components.data());
    return components[component];
  }
  /// Precondition: a field variable.
  double value(const Sample& sample) const {
    return of([&](double* into) { variable->evaluate(sample, into); });
  }
};

/// All of them, in the order of the variables.
const std::vector<Quantity>& quantities();
/// @throws std::out_of_range if there is none of this name (reading the configuration has checked it)
const Quantity& quantity(const std::string& name);

}  // namespace creepcontact::results
