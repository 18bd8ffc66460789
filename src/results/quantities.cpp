#include "creepcontact/results/quantities.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "cross_section.hpp"

namespace creepcontact::results {
namespace {

constexpr double smallest_reciprocal = 1e-30;  // of a state variable whose output would be infinite

const std::vector<std::string> vector_components{"x", "y", "z"};
const std::vector<std::string> tensor_components{"xx", "yy", "zz", "xy", "yz", "zx"};

/// @param mandel  in Mandel order
void set_cartesian(const Tensor6& mandel, double* into) {
  const Matrix3 tensor = tensor::to_matrix(mandel);
  const std::array values{tensor(0, 0), tensor(1, 1), tensor(2, 2), tensor(0, 1), tensor(1, 2), tensor(2, 0)};
  std::ranges::copy(values, into);
}

template <Tensor6 Sample::*field>
void cartesian(const Sample& sample, double* into) {
  set_cartesian(sample.*field, into);
}

/// @param first  its place in Sample::state
OutputVariable of_state_variable(const material::StateVariable& variable, std::size_t first) {
  const auto evaluate = [&variable, first](const Sample& sample, double* into) {
    if (sample.state.empty())
      std::fill_n(into, variable.width(), 0.0);
    else if (variable.is_tensor)
      set_cartesian(Eigen::Map<const Tensor6>(sample.state.data() + first), into);
    else
      *into = sample.state[first];
    if (variable.is_reciprocal) *into = 1 / std::max(*into, smallest_reciprocal);
  };
  return {.name = variable.name,
          .components = variable.is_tensor ? tensor_components : std::vector<std::string>(),
          .description = variable.description,
          .label = variable.label,
          .dimension = variable.dimension,
          .support = AtPoints{evaluate},
          .point_array = variable.name,
          .state_variable = &variable};
}

template <Vector3 Resultant::*part>
void part_of(const Resultant& resultant, double* into) {
  std::ranges::copy(resultant.*part, into);
}

double spring_force(const contact::Pair& spring, const creep::Equilibrium& at) {
  return spring.coupling.area.front() * at.contact.multiplier[spring.first_row];
}

double spring_closure(const contact::Pair& spring, const creep::Equilibrium& at) {
  const double creep = at.creep_closure.empty() ? 0 : at.creep_closure[static_cast<std::size_t>(spring.first_node)];
  return creep - at.gaps[spring.first_row] / spring.coupling.area.front();
}

/// Sets the cylindrical components of the stress about the z axis.
void cylindrical(const Sample& sample, double* into) {
  const double r = sample.position.head<2>().norm();
  const Vector3 radial = r > 0 ? Vector3(sample.position.x() / r, sample.position.y() / r, 0) : Vector3(1, 0, 0);
  const Vector3 circumferential(-radial.y(), radial.x(), 0);
  const Matrix3 stress = tensor::to_matrix(sample.stress);
  into[0] = radial.dot(stress * radial);
  into[1] = circumferential.dot(stress * circumferential);
  into[2] = radial.dot(stress * circumferential);
}

void principal(const Sample& sample, double* into) {
  const Vector3 ascending = tensor::principal_values(tensor::to_matrix(sample.stress));
  std::reverse_copy(ascending.begin(), ascending.end(), into);
}

std::vector<OutputVariable> make_variables() {
  std::vector<OutputVariable> all;
  all.push_back({.name = "displacement",
                 .components = vector_components,
                 .description = "displacement",
                 .label = "displacement",
                 .dimension = Dimension::length,
                 .support = AtNodes{[](const Sample& at, double* into) { std::ranges::copy(at.displacement, into); }},
                 .point_array = "displacement"});
  all.push_back({.name = "displacement_magnitude",
                 .description = "magnitude of the displacement",
                 .label = "displacement",
                 .dimension = Dimension::length,
                 .support = AtNodes{[](const Sample& at, double* into) { *into = at.displacement.norm(); }}});
  all.push_back({.name = "stress",
                 .components = tensor_components,
                 .description = "stress",
                 .label = "stress",
                 .dimension = Dimension::stress,
                 .support = AtPoints{cartesian<&Sample::stress>},
                 .point_array = "stress",
                 .cell_array = "stress"});
  all.push_back({.name = "stress",
                 .components = {"r", "theta", "rtheta"},
                 .description = "stress in cylindrical components about the probe's `axis`, by default z",
                 .label = "stress",
                 .dimension = Dimension::stress,
                 .support = AtPoints{cylindrical},
                 .point_array = "stress_cylindrical",
                 .cylindrical = true});
  all.push_back({.name = "von_mises",
                 .description = "von Mises equivalent stress",
                 .label = "von Mises stress",
                 .dimension = Dimension::stress,
                 .support = AtPoints{[](const Sample& at, double* into) { *into = tensor::von_mises(at.stress); }},
                 .point_array = "von_mises",
                 .cell_array = "von_mises"});
  all.push_back({.name = "principal",
                 .components = {"1", "2", "3"},
                 .description = "principal stress; 1: largest, 3: smallest",
                 .label = "principal stress",
                 .dimension = Dimension::stress,
                 .support = AtPoints{principal},
                 .point_array = "principal_stress"});
  all.push_back({.name = "hydrostatic",
                 .description = "mean stress",
                 .label = "mean stress",
                 .dimension = Dimension::stress,
                 .support = AtPoints{[](const Sample& at, double* into) { *into = tensor::trace(at.stress) / 3; }}});
  all.push_back({.name = "strain",
                 .components = tensor_components,
                 .description = "total strain, tensor components",
                 .label = "strain",
                 .support = AtPoints{cartesian<&Sample::strain>}});
  all.push_back({.name = "creep_strain",
                 .components = tensor_components,
                 .description = "creep strain, tensor components",
                 .label = "creep strain",
                 .support = AtPoints{cartesian<&Sample::creep_strain>},
                 .point_array = "creep_strain",
                 .cell_array = "creep_strain"});
  all.push_back(
      {.name = "creep_strain_equivalent",
       .description = "equivalent creep strain sqrt(2/3 e:e)",
       .label = "creep strain",
       .support = AtPoints{[](const Sample& at, double* into) { *into = tensor::equivalent_strain(at.creep_strain); }},
       .point_array = "creep_strain_equivalent"});
  // The same with the word for laws of creep and plasticity in one. Field files have one array of both.
  for (const std::size_t creep : {all.size() - 2, all.size() - 1}) {
    OutputVariable inelastic = all[creep];
    const auto renamed = [](std::string text) { return text.replace(text.find("creep"), 5, "inelastic"); };
    inelastic.name = renamed(inelastic.name);
    inelastic.description = renamed(inelastic.description) + ": another name of `" + all[creep].name + "`";
    inelastic.label = renamed(inelastic.label);
    inelastic.point_array.clear();
    inelastic.cell_array.clear();
    all.push_back(std::move(inelastic));
  }
  all.push_back({.name = "temperature",
                 .description = "temperature",
                 .label = "temperature",
                 .dimension = Dimension::temperature,
                 .support = AtPoints{[](const Sample& at, double* into) { *into = at.temperature; }},
                 .point_array = "temperature",
                 .is_of_heat = true});
  all.push_back({.name = "heat_flux",
                 .components = vector_components,
                 .description = "heat per area and time, where `[heat]` computes the temperature",
                 .label = "heat flux",
                 .support = AtPoints{[](const Sample& at, double* into) { std::ranges::copy(at.heat_flux, into); }},
                 .point_array = "heat_flux",
                 .is_of_heat = true,
                 .needs_heat = true});
  all.push_back({.name = "heat_flow",
                 .description = "heat per time that leaves the bodies through a surface: by films, fluxes, radiation, "
                                "given temperatures and contacts",
                 .label = "heat flow",
                 .support = ThroughSurface{},
                 .is_of_heat = true,
                 .needs_heat = true});
  std::size_t first = 0;
  for (const material::StateVariable* variable : material::state_variables()) {
    all.push_back(of_state_variable(*variable, first));
    first += variable->width();
  }

  all.push_back({.name = "contact_pressure",
                 .description = "contact pressure (multiplier); the same on both surfaces of a pair",
                 .label = "contact pressure",
                 .dimension = Dimension::stress,
                 .support = AtMultipliers{&ContactValues::pressure}});
  all.push_back({.name = "gap",
                 .description = "normal distance of the surfaces; zero where they are closed",
                 .label = "gap",
                 .dimension = Dimension::length,
                 .support = AtMultipliers{&ContactValues::gap}});
  all.push_back({.name = "contact_shear",
                 .description = "magnitude of the tangential traction in contact; the same on both surfaces of a pair",
                 .label = "contact shear",
                 .dimension = Dimension::stress,
                 .support = AtMultipliers{&ContactValues::shear, AtMultipliers::In::with_friction}});
  all.push_back({.name = "slip",
                 .description = "accumulated slip of contacts with friction: length of the path along which the "
                                "surfaces have slid while in contact",
                 .label = "slip",
                 .dimension = Dimension::length,
                 .support = AtMultipliers{&ContactValues::slip, AtMultipliers::In::with_friction}});
  all.push_back({.name = "contact_status",
                 .description = "0: open, 1: sticks, 2: slips (always, where there is no friction)",
                 .label = "contact status",
                 .support = AtMultipliers{&ContactValues::status, AtMultipliers::In::with_friction, false}});
  const auto of_gaskets = [&](const char* name, const char* label, double ContactValues::*value,
                              const char* description) {
    all.push_back({.name = name,
                   .description = description,
                   .label = label,
                   .dimension = Dimension::length,
                   .support = AtMultipliers{value, AtMultipliers::In::with_gaskets, false}});
  };
  of_gaskets("closure", "closure", &ContactValues::closure,
             "by how much the surfaces compress a gasket, creep included; negative where they are apart");
  of_gaskets("closure_max", "largest closure", &ContactValues::largest_closure,
             "largest closure of a gasket so far without creep, from which it unloads");
  of_gaskets("creep_closure", "closure by creep", &ContactValues::creep_closure,
             "part of the closure of a gasket that is creep");
  all.push_back(
      {.name = "temperature_jump",
       .description = "temperature of the slave surface less that of the other one, where `[heat]` computes it",
       .label = "temperature jump",
       .support = AtMultipliers{&ContactValues::temperature_jump, AtMultipliers::In::with_heat, false},
       .needs_heat = true});
  all.push_back({.name = "contact_conductance",
                 .description = "heat per area, time and degree that passes a contact",
                 .label = "conductance",
                 .support = AtMultipliers{&ContactValues::conductance, AtMultipliers::In::with_heat, false},
                 .needs_heat = true});
  all.push_back({.name = "gasket_pressure",
                 .description =
                     "contact pressure as tightness is judged by: its mean over the width, at sections around "
                     "the probe's `axis`, of which `min` is the least along the circumference",
                 .label = "gasket pressure",
                 .dimension = Dimension::stress,
                 .support = OverWidth{&ContactValues::pressure},
                 .cylindrical = true});
  all.push_back({.name = "spring_force",
                 .description = "force of a spring, which `on` names; positive where it presses its ends apart",
                 .label = "spring force",
                 .dimension = Dimension::force,
                 .support = OnSpring{spring_force}});
  all.push_back({.name = "spring_closure",
                 .description = "by how much the ends of a spring, which `on` names, have come closer",
                 .label = "closure",
                 .dimension = Dimension::length,
                 .support = OnSpring{spring_closure}});
  all.push_back({.name = "contact_area",
                 .description = "area in contact; its edge is located between the nodes",
                 .label = "contact area",
                 .dimension = Dimension::area,
                 .support = AreaInContact{}});
  all.push_back({.name = "contact_force",
                 .components = vector_components,
                 .description = "resultant contact force on the body of this surface",
                 .label = "contact force",
                 .dimension = Dimension::force,
                 .support = OnContactSurface{part_of<&Resultant::force>}});
  all.push_back({.name = "contact_moment",
                 .components = vector_components,
                 .description = "resultant moment of the contact forces on the body of this surface about the probe's "
                                "`origin`, with the nodes where they are in the mesh",
                 .label = "contact moment",
                 .dimension = Dimension::moment,
                 .support = OnContactSurface{part_of<&Resultant::moment>},
                 .about_origin = true});
  all.push_back({.name = "reaction",
                 .components = vector_components,
                 .description = "resultant force of the supports on the body",
                 .label = "reaction",
                 .dimension = Dimension::force,
                 .support = OnSupports{[](const Vector3& force, double* into) { std::ranges::copy(force, into); }}});
  all.push_back({.name = "axial_strain",
                 .description = "axial strain in generalised plane strain, the same in all bodies",
                 .label = "axial strain",
                 .support = OnCrossSection{axial_strain}});
  all.push_back({.name = "axial_force",
                 .description = "axial force on the cross-section of a body in generalised plane strain",
                 .label = "axial force",
                 .dimension = Dimension::force,
                 .support = OnCrossSection{axial_force}});
  all.push_back({.name = "section_force",
                 .components = vector_components,
                 .description = "force that passes the plane `section` through a body: of the material on the side of "
                                "the normal on the rest, tension along the normal positive",
                 .label = "section force",
                 .dimension = Dimension::force,
                 .support = OnPlane{part_of<&Resultant::force>}});
  all.push_back({.name = "section_moment",
                 .components = vector_components,
                 .description = "moment of that force about the `origin` of the probe or of its `section`",
                 .label = "section moment",
                 .dimension = Dimension::moment,
                 .support = OnPlane{part_of<&Resultant::moment>},
                 .about_origin = true});
  return all;
}

std::vector<Quantity> make_quantities() {
  std::vector<Quantity> all;
  for (const OutputVariable& variable : output_variables()) {
    if (variable.components.empty()) all.push_back({variable.name, &variable, 0});
    for (const std::string& component : variable.components)
      all.push_back(
          {variable.name + '_' + component, &variable, static_cast<int>(&component - variable.components.data())});
  }
  return all;
}

}  // namespace

const std::vector<OutputVariable>& output_variables() {
  static const std::vector<OutputVariable> all = make_variables();
  return all;
}

void OutputVariable::evaluate(const Sample& sample, double* into) const {
  if (const auto* points = std::get_if<AtPoints>(&support))
    points->evaluate(sample, into);
  else
    std::get<AtNodes>(support).evaluate(sample, into);
}

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = make_quantities();
  return all;
}

const Quantity& quantity(const std::string& name) {
  const auto found = std::ranges::find(quantities(), name, &Quantity::name);
  if (found == quantities().end()) throw std::out_of_range("no quantity '" + name + "'");
  return *found;
}

}  // namespace creepcontact::results
