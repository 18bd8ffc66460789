#pragma once
/// The tables of the configuration. Each says its keys once: name, kind of value, struct member (and so the default),
/// description.

#include "creepcontact/config/config.hpp"
#include "creepcontact/config/vocabulary.hpp"
#include "value.hpp"

namespace creepcontact::config {

Value<Mesh> mesh_table();
Value<Body> body_table();
Value<Material> material_table(const Vocabulary& vocabulary);
/// A law of [[materials.<name>.creep]].
Value<CreepMechanism> mechanism_table(const std::vector<Law>& laws);
/// The laws of what is not a material: creep = [{ law = "norton", ... }].
Value<std::vector<CreepMechanism>> laws_elsewhere(const Vocabulary& vocabulary);
/// A constant of a law that is not given.
CreepParameter default_parameter(const LawKey& key, const Location& location);
/// Sets what the law specifies for a constant apart from its values.
void describe_parameter(const LawKey& key, CreepParameter& parameter);
Value<DataRange> data_range_table();
Value<Rupture> rupture_table(const Vocabulary& vocabulary);
Value<Fatigue> fatigue_table(const Vocabulary& vocabulary);
Value<Plasticity> plasticity_table();
Value<Gasket> gasket_table(const Vocabulary& vocabulary);
Value<Support> support_table();
Value<Load> load_table();
Value<Temperature> temperature_table();
Value<Heat> heat_table();
Value<InitialStress> initial_stress_table();
/// A function of place, time and temperature, "perfect" or "insulated".
Value<Conductance> conductance_value();
Value<GeneralizedPlaneStrain> generalized_plane_strain_table();
Value<Contact> contact_table();
Value<Spring> spring_table(const Vocabulary& vocabulary);
std::string default_name(const Contact& contact);
Value<Cyclic> cyclic_table();
Value<Rigid> rigid_table();
Value<Rigid> coupling_table();
Value<Surface> surface_table();
Value<Equation> equation_table();
/// Two different surfaces.
Value<std::array<Reference, 2>> two_surfaces();
Value<ContactSolver> contact_solver_table();
Value<settings::StiffnessSettings> linear_solver_table();
Value<Time> time_table(const Vocabulary& vocabulary);
Value<Output> output_table();
Value<Report> report_table(const Vocabulary& vocabulary);
Value<Probe> probe_table(const Vocabulary& vocabulary);
Value<Event> event_table();
Value<Criterion> criterion_table(const Vocabulary& vocabulary);
Value<Sensitivity> sensitivity_table();
Value<Config> config_table(const Vocabulary& vocabulary);

/// Variables of functions of place and time.
inline const std::vector<std::string> position_and_time{"x", "y", "z", "t"};

/// Which of `keys` the table has.
std::vector<std::string> given_keys(const Item& item, const std::vector<std::string>& keys);

}  // namespace creepcontact::config
