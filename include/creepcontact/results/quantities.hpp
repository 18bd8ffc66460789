#pragma once
/// The output variables of a run, declared once: probes, arrays of the field files, lists and labels of plots follow.

#include <functional>
#include <string>
#include <vector>

#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::results {

struct OutputVariable {
  /// Where it is defined.
  enum class Location {
    field,             ///< at every point of a body
    contact_pressure,  ///< at the multiplier nodes of a contact surface
    contact_gap,
    contact_shear,
    contact_slip,
    contact_status,
    contact_area,    ///< of a contact surface
    contact_force,   ///< vector, of a contact surface
    contact_moment,  ///< the same
    reaction,        ///< vector, of a supported group
    axial_strain,    ///< of a body in generalised plane strain
    axial_force,     ///< the same
    section_force,   ///< vector, of a plane through a body
    section_moment   ///< the same
  };
  std::string name;
  std::vector<std::string> components;  ///< suffixes of their names; empty: a scalar
  std::string description;
  std::string label;      ///< for axes of plots
  std::string dimension;  ///< "stress", "length", ...; empty: none
  Location location = Location::field;
  /// Field variables: sets all components.
  std::function<void(const Sample& sample, double* components)> evaluate = {};
  std::string point_array = {};  ///< name in the field files at nodes; empty: not there
  std::string cell_array = {};   ///< the same of element means
  bool cylindrical = false;      ///< components about the z axis; a probe may turn the sample to another axis
  /// In the field files only if a material has this variable; null: always.
  const material::StateVariable* state_variable = nullptr;

  /// At the multiplier nodes of contact surfaces.
  bool is_contact_field() const {
    return location == Location::contact_pressure || location == Location::contact_gap ||
           location == Location::contact_shear || location == Location::contact_slip ||
           location == Location::contact_status;
  }
  /// Of a whole surface or plane: a sum.
  bool is_resultant() const {
    return location == Location::contact_area || location == Location::contact_force ||
           location == Location::contact_moment || location == Location::reaction || is_of_section();
  }
  /// One value per body, in generalised plane strain.
  bool is_axial() const { return location == Location::axial_strain || location == Location::axial_force; }
  bool is_of_section() const { return location == Location::section_force || location == Location::section_moment; }
  std::size_t n_components() const { return components.empty() ? 1 : components.size(); }
};

const std::vector<OutputVariable>& output_variables();

/// A scalar for probes: a component of a variable.
struct Quantity {
  std::string name;  ///< "stress_xx"
  const OutputVariable* variable;
  int component;

  /// Precondition: a field variable.
  double value(const Sample& sample) const;
};

/// All of them, in the order of the variables.
const std::vector<Quantity>& quantities();
/// @throws std::out_of_range if there is none of this name (reading the configuration has checked it)
const Quantity& quantity(const std::string& name);

}  // namespace creepcontact::results
