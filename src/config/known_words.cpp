#include "known_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "item.hpp"

namespace creepcontact::config {
namespace {

constexpr std::array words{
    // the whole file
    KnownWord{"", "axisymmetric plane_strain plane_stress dimension model_type",
              "sections are chosen by 'analysis', as in analysis = \"axisymmetric\""},
    KnownWord{"", "generalised_plane_strain", "the table is 'generalized_plane_strain', with a z"},
    KnownWord{"analysis=", "axisymmetry axi axisym axis cax cax4 cax6 cax8 2d_axisymmetric",
              "sections through the axis of a ring are \"axisymmetric\": 'analysis' = \"axisymmetric\""},
    KnownWord{"analysis=", "cpe cpe4 cpe6 cpe8 d_plan 2d",
              "plane sections are 'analysis' = \"plane_strain\" or \"plane_stress\""},
    KnownWord{"analysis=", "cps cps4 cps6 cps8 c_plan", "plane stress is 'analysis' = \"plane_stress\""},
    KnownWord{"analysis=", "generalised_plane_strain cpeg cpeg4 cpeg6 cpeg8",
              "the word is 'generalized_plane_strain', with a z"},
    KnownWord{"analysis=", "3d three_dimensional full",
              "models in three dimensions are 'analysis' = \"solid\", which need not be given"},
    KnownWord{"", "cyclic_symmetry sector sectors periodic", "cyclic symmetry is 'cyclic'"},
    KnownWord{"", "equation constraints constraint mpc mpcs linear_constraints",
              "a linear equation between displacements is an entry of 'equations'"},
    KnownWord{"", "rigid_bodies rigid_body rigid_surfaces", "a surface that moves as a rigid body is 'rigid'"},
    KnownWord{"", "residual_stress residual_stresses prestress initial_conditions",
              "stress before the loads act is 'initial_stress'"},
    KnownWord{"", "criterion requirements requirement limits acceptance", "what a run is judged by are 'criteria'"},
    KnownWord{"", "event", "conditions on probes are 'events'"},
    KnownWord{"", "restart resume",
              "to continue from the last checkpoint, use the option --resume of creepcontact run"},
    KnownWord{"", "boundary_conditions boundary bc bcs constraints constraint fixed",
              "prescribed displacements are entries of 'supports', forces are entries of 'loads'"},
    KnownWord{"", "forces force pressure pressures", "external forces are entries of 'loads'"},
    KnownWord{"", "parts part", "parts are entries of 'bodies'"},
    KnownWord{"", "geometry", "the geometry is given by 'file' in [mesh]"},
    KnownWord{"", "solver integrator integration step steps",
              "time integration is chosen in 'time', the contact solver in 'contact_solver'"},
    KnownWord{"", "interactions interfaces ties", "pairs of surfaces are entries of 'contacts'"},
    KnownWord{"", "results history", "what is written is chosen in 'output' and 'probes'"},

    KnownWord{"mesh", "analysis", "'analysis' is a key of the whole file: write it before the first table"},
    KnownWord{"mesh", "element_order degree", "the order of the elements is 'order'"},
    KnownWord{"mesh", "h element_size lc",
              "element sizes are 'size' for CAD files, and constants of a .geo file, which 'parameters' sets"},
    KnownWord{"bodies.<name>", "volume volumes physical elements group",
              "the physical volume of a body is its 'region'"},

    KnownWord{"bodies.<name>", "orientation axes csys coordinate_system esys",
              "the axes of the material are 'material_axes'"},

    // materials
    KnownWord{"materials.<name>",
              "e young youngs_modulus young's_modulus elastic_modulus modulus_of_elasticity modulus",
              "Young's modulus is 'young_modulus'"},
    KnownWord{"materials.<name>", "nu poisson poissons_ratio poisson's_ratio pr", "Poisson's ratio is 'poisson_ratio'"},
    KnownWord{"materials.<name>", "alpha cte expansion thermal_expansion_coefficient alpha_t",
              "the secant coefficient of thermal expansion is 'thermal_expansion'"},
    KnownWord{"materials.<name>", "anisotropic orthotropy transversely_isotropic engineering_constants",
              "elasticity along three axes is 'orthotropic'"},
    KnownWord{"materials.<name>.orthotropic", "e e1 e2 e3 ex ey ez young_modulus moduli",
              "Young's moduli along the axes are 'young_moduli', a list of three"},
    KnownWord{"materials.<name>.orthotropic", "nu nu12 nu23 nu13 nu21 poisson_ratio prxy nuxy",
              "Poisson's ratios nu12, nu23, nu13 are 'poisson_ratios', a list of three"},
    KnownWord{"materials.<name>.orthotropic", "g g12 g23 g13 gxy shear_modulus",
              "the shear moduli G12, G23, G13 are 'shear_moduli', a list of three"},
    KnownWord{"materials.<name>.orthotropic", "alpha thermal_expansion",
              "three coefficients along the axes are 'thermal_expansion' of the material"},
    KnownWord{"materials.<name>", "t_ref tref t0 reference_temp",
              "the temperature without thermal strain is 'reference_temperature'"},
    KnownWord{"materials.<name>", "rho",
              "mass per volume is 'density', for heat; loads have their own: 'loads[].rotation.density'"},
    KnownWord{"materials.<name>", "law a n m norton",
              "a creep law has its own table, [[materials.<name>.creep]] with 'law' and its constants"},
    KnownWord{"materials.<name>", "source reference references", "where the data come from is said by 'sources'"},
    KnownWord{"materials.<name>", "yield yield_stress plastic hardening",
              "yielding is [materials.<name>.plasticity]; the law 'chaboche' in creep depends on the rate"},
    KnownWord{"materials.<name>", "specific_heat cp c", "the specific heat is 'heat_capacity'"},
    KnownWord{"materials.<name>", "lambda thermal_conductivity k", "the conductivity of heat is 'conductivity'"},
    KnownWord{"materials.<name>.creep[]", "type model name", "the name of the creep law is 'law'"},
    KnownWord{"materials.<name>.creep[]", "exponent stress_exponent power", "the exponent of the stress is 'n'"},
    KnownWord{"materials.<name>.creep[]", "coefficient factor constant k c", "the factor of the rate is 'A'"},
    KnownWord{"materials.<name>.creep[]", "time_exponent", "the exponent of the time is 'm'"},
    KnownWord{"materials.<name>.creep[]", "q", "the activation energy is 'activation_energy'"},
    KnownWord{"materials.<name>.creep[]", "omega_0 omega0", "the parameter Omega is 'omega'"},
    KnownWord{"materials.<name>.creep[]", "eps0 rate_0 initial_rate", "the rate of the virgin material is 'rate0'"},
    KnownWord{"materials.<name>.creep[]", "theta1 theta2 theta3 theta4",
              "the parameters of the theta projection are 'theta_1' to 'theta_4'"},
    KnownWord{"materials.<name>.creep[]", "r", "the gas constant is 'gas_constant'"},
    KnownWord{"materials.<name>.creep[].law=",
              "nortonbailey bailey bailey_norton power_law_hardening modified_time_hardening modified_strain_hardening "
              "mtime mstrain",
              "the law of Norton and Bailey, strain A q^n t^m, is 'norton_bailey', with the key 'hardening'"},
    KnownWord{"materials.<name>.creep[].law=", "power power_law norton_hoff odqvist glen",
              "the power law, rate A q^n, is 'norton'"},
    KnownWord{"materials.<name>.creep[].law=", "sinh hyperbolic_sine hyperbolic", "the law with sinh is 'garofalo'"},
    KnownWord{"materials.<name>.creep[].law=", "prony viscoelastic generalized_maxwell generalised_maxwell",
              "linear viscoelasticity is 'hereditary', with a list of compliances and times"},
    KnownWord{"materials.<name>.creep[].law=", "damage kachanov rabotnov", "creep with damage is 'kachanov_rabotnov'"},
    KnownWord{"materials.<name>.creep[].law=", "arrhenius",
              "laws depend on the temperature through their key 'activation_energy', as 'norton' does"},
    KnownWord{"materials.<name>.creep[].law=", "user umat creep_subroutine",
              "to give your own creep rate, use 'expression'"},
    KnownWord{"materials.<name>.creep[].law=", "mpc_omega mpc project_omega api_579 api579 prager",
              "the Omega method of API 579-1 is 'omega'"},
    KnownWord{"materials.<name>.creep[].law=", "theta theta_method evans_wilshire wilshire",
              "the theta projection of Evans and Wilshire is 'theta_projection'"},
    KnownWord{"materials.<name>.creep[].law=", "rccmr rcc_mrx rccmrx rcc-mr", "the creep law of RCC-MR is 'rcc_mr'"},
    KnownWord{"materials.<name>.creep[].law=", "mcvetty soderberg_law",
              "primary creep that ends exponentially is 'soderberg'"},
    KnownWord{"materials.<name>.creep[].law=", "plastic viscoplastic visc_cin1_chab visc_cin2_chab viscochab",
              "viscoplasticity with hardening is 'chaboche'; what does not depend on the rate is "
              "[materials.<name>.plasticity]"},

    // supports, loads, temperature
    KnownWord{"supports[]", "surface group set nodes face", "the surface, curve or point that is supported is 'on'"},
    KnownWord{"supports[]", "x y z ux uy uz normal radial tangential axial along fix fixed value",
              "components are written 'displacement' = { x = 0 }, with x, y, z, normal, radial or others"},
    KnownWord{"supports[].displacement", "r ur",
              "the radial displacement is 'radial', about an 'axis'; in an axisymmetric model it is 'x'"},
    KnownWord{"loads[]", "rpm speed omega angular_velocity centrifugal rotational_velocity",
              "centrifugal force is 'rotation' = { angular_velocity = ..., density = ... }, in radians per unit of "
              "time: one revolution per minute is 2 pi/60 = 0.10472 rad/s"},
    KnownWord{"loads[]", "gravity acceleration", "weight is 'body_force', density times acceleration"},
    KnownWord{"loads[]", "preload pretension bolt_preload bolt",
              "a bolt is tightened by 'preload' of a contact: under its head, or a tied one that cuts its shank"},
    KnownWord{"loads[]", "moment torque",
              "not in this version; a surface made 'rigid' takes a moment, or use a 'traction' that varies over "
              "the surface"},
    KnownWord{"loads[]", "surface group set face", "the surface of a load is 'on'"},
    KnownWord{"loads[]", "point", "the point where a force acts is 'at'"},
    KnownWord{"loads[]", "temperature", "temperatures are given by the table [temperature], with 'value' or 'file'"},
    KnownWord{"loads[].rotation", "rpm speed omega",
              "the speed is 'angular_velocity', in radians per unit of time: one revolution per minute is 2 pi/60 = "
              "0.10472 rad/s"},
    KnownWord{"loads[].rotation", "rho", "mass per volume is 'density'"},
    KnownWord{"loads[].rotation", "center centre point", "a point on the axis is 'origin'"},
    KnownWord{"temperature", "t constant uniform", "the temperature is 'value'"},
    KnownWord{"temperature", "files path pattern",
              "files are given by 'file': one path, a list, or a pattern such as t_*.csv"},
    KnownWord{"temperature", "time", "the times of a list of files are 'times'"},
    KnownWord{"temperature", "column mapping header", "names of columns are given by 'columns' = { x = ..., T = ... }"},
    KnownWord{"temperature", "cycle repeat", "what repeats in time has a 'period'"},

    // contact
    KnownWord{"contacts[]", "mu friction_coefficient coefficient_of_friction",
              "the coefficient of friction is 'friction'"},
    KnownWord{"contacts[]", "pretension bolt_preload bolt_load tightening",
              "the normal force of a tightened bolt is 'preload'"},
    KnownWord{"contacts[]", "interference overlap press_fit", "an interference is a negative 'gap'"},
    KnownWord{"contacts[]", "clearance distance offset", "the initial normal distance is 'gap'"},
    KnownWord{"contacts[]", "surfaces pair surface", "the two surfaces are 'between'"},
    KnownWord{"contacts[]", "master", "the slave surface is 'slave'; the other one of the two is the master"},
    KnownWord{"contacts[]", "tied tie bonded glued", "surfaces are joined by 'type' = \"tied\""},
    KnownWord{"contacts[]", "penalty stiffness normal_stiffness",
              "contact needs no stiffness: surfaces do not penetrate each other; remove the key from 'contacts'"},
    KnownWord{"contacts[].type=", "bonded glued glue tie no_separation", "surfaces that stay together are 'tied'"},
    KnownWord{"contacts[].type=", "frictionless contact standard sliding",
              "contact that may open and slide is 'unilateral'"},
    KnownWord{"contacts[].type=", "friction frictional rough",
              "contact with friction is 'unilateral', with the coefficient in the key 'friction'"},
    KnownWord{"contact_solver", "maxiter max_iter iterations", "the largest number of iterations is 'max_iterations'"},
    KnownWord{"contact_solver", "penalty stiffness",
              "contact needs no stiffness: remove the key from 'contact_solver'"},

    // time, output, probes
    KnownWord{"time", "dt step_size timestep time_step delta_t initial_step",
              "the step of the Euler schemes is 'step'; other integrators choose their steps by 'tolerance'"},
    KnownWord{"time", "min_step max_step dt_min dt_max", "steps are chosen by the error that 'tolerance' allows"},
    KnownWord{"time", "t_end tend final_time end_time duration stop total_time", "the end of the run is 'end'"},
    KnownWord{"time", "start t_start begin", "runs start at t = 0 and stop at 'end'"},
    KnownWord{"time", "method solver scheme", "the method of time integration is 'integrator'"},
    KnownWord{"time", "rtol atol accuracy reltol abstol", "the accuracy of the stress is set by 'tolerance'"},
    KnownWord{"time", "steps n_steps num_steps number_of_steps",
              "the number of steps follows from 'step' or 'tolerance'; results are written at the times of 'output'"},
    KnownWord{"time", "outputs output_times times save save_at print", "the times of results are 'output'"},
    KnownWord{"time", "restart resume",
              "to continue from the last checkpoint, use the option --resume of creepcontact run"},
    KnownWord{"time.integrator=", "rkc2", "it was removed; use 'auto' or 'cvode_bdf'"},
    KnownWord{"time.integrator=", "bdf", "backward differentiation formulas (BDF) are 'cvode_bdf'"},
    KnownWord{"time.integrator=", "adams", "Adams' methods are 'cvode_adams' and 'log_adams'"},
    KnownWord{"time.integrator=", "euler forward_euler explicit", "Euler's explicit method is 'explicit_euler'"},
    KnownWord{"time.integrator=", "backward_euler implicit_euler implicit", "Euler's implicit method is 'beta_euler'"},
    KnownWord{"time.integrator=", "rk rk4 rk45 runge_kutta erk", "explicit Runge-Kutta methods are 'arkode_erk'"},
    KnownWord{"time.integrator=", "dirk sdirk radau", "implicit Runge-Kutta methods are 'arkode_dirk'"},
    KnownWord{"output", "folder path", "the directory of the results is 'directory'"},
    KnownWord{"output", "vtk vtu paraview format", "files for ParaView are written unless 'fields' = false"},
    KnownWord{"output", "interval frequency times every", "the times of results are 'time.output'"},
    KnownWord{"output", "field_times", "the times of field files are a list: 'fields' = [0, 100]"},
    KnownWord{"output", "delimiter sep csv_separator", "what separates the cells of CSV files is 'separator'"},
    KnownWord{"output", "decimal_separator decimal_point decimal_sign decimal_comma",
              "the decimal sign in CSV files is 'decimal'"},
    KnownWord{"output", "restart resume",
              "to continue from the last checkpoint, use the option --resume of creepcontact run"},
    KnownWord{"probes[]", "when", "conditions on probes are in 'events'"},
    KnownWord{"probes[]", "region filter", "a part of a surface or body is chosen by 'where'"},
    KnownWord{"probes[]", "plane cut", "the plane of a section force is 'section'"},
    KnownWord{"probes[]", "factor", "a factor on the value is 'scale'"},
    KnownWord{"probes[]", "formula", "a value computed from other probes is an 'expression'"},
    KnownWord{"events[]", "condition if expression", "the condition of an event is 'when'"},
    KnownWord{"probes[]", "point location position coordinates place", "the point of a probe is 'at'"},
    KnownWord{"probes[]", "surface group set face", "the surface, curve or point of a probe is 'on'"},
    KnownWord{"probes[]", "variable type field component", "what a probe records is 'quantity'"},
    KnownWord{"probes[]", "reduction operation average", "how the values over a surface become one is set by 'reduce'"},
    KnownWord{"probes[].quantity=", "hoop hoop_stress stress_hoop tangential_stress circumferential_stress",
              "the hoop stress is 'stress_theta', about the 'axis' of the probe"},
    KnownWord{"probes[].quantity=", "radial_stress stress_radial",
              "the radial stress is 'stress_r', about the 'axis' of the probe"},
    KnownWord{"probes[].quantity=", "seqv equivalent_stress mises_stress stress_mises",
              "the von Mises stress is 'von_mises'"},
    KnownWord{"probes[].quantity=", "ux uy uz u displacement",
              "displacements are 'displacement_x', _y, _z and _magnitude"},
    KnownWord{"probes[].quantity=", "stress s sxx syy szz", "stresses are 'stress_xx' and so on, or 'von_mises'"},
    KnownWord{"probes[].quantity=", "pressure", "the pressure in a contact is 'contact_pressure'"},
    KnownWord{"probes[].quantity=", "force reaction reaction_force",
              "support forces are 'reaction_x', contact forces 'contact_force_x'; likewise with _y and _z"},
    KnownWord{"probes[].quantity=", "ceeq equivalent_creep_strain creep_strain",
              "the equivalent creep strain is 'creep_strain_equivalent'"},
    KnownWord{"probes[].quantity=", "s1 max_principal maximum_principal",
              "the largest principal stress is 'principal_1'"},
    KnownWord{"probes[].quantity=", "section_force section_moment cut_force",
              "what a body transmits across a plane is 'section_force_x' or 'section_moment_x'; likewise with _y, _z"},
};

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

bool names(const KnownWord& known, std::string_view word) {
  return fmt::format(" {} ", known.words).find(fmt::format(" {} ", lower_case(word))) != std::string::npos;
}

std::string said_at(const std::string& place, std::string_view word) {
  for (const KnownWord& known : words)
    if (known.place == place && names(known, word)) return std::string(known.says);
  return {};
}

}  // namespace

std::span<const KnownWord> known_words() {
  return words;
}

std::string said_of_key(const std::string& key, std::string_view word) {
  const std::string place = schema_path(key);
  const std::size_t length = place.size() - std::min(place.size(), word.size());
  return said_at(place.substr(0, length > 0 ? length - 1 : 0), word);
}

std::string said_of_value(const std::string& key, std::string_view word) {
  return said_at(schema_path(key) + '=', word);
}

std::string said_of_word(std::string_view word) {
  std::string all;
  for (const KnownWord& known : words) {
    if (!names(known, word)) continue;
    const std::string_view place = known.place.substr(0, known.place.find('='));
    all += fmt::format("{}{}{}{}", all.empty() ? "" : "; ", place, place.empty() ? "" : ": ", known.says);
  }
  return all;
}

}  // namespace creepcontact::config
