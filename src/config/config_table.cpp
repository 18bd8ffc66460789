/// The document as a whole.

#include <algorithm>
#include <map>
#include <stdexcept>

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {

const Material& Config::material(const std::string& name) const {
  for (const Material& candidate : materials) {
    if (candidate.name == name) return candidate;
  }
  throw std::out_of_range("no material '" + name + "'");
}

bool Config::is_heat_alone() const {
  if (!heat) return false;
  return heat->alone.value_or(std::ranges::all_of(
      materials, [](const Material& material) { return !material.orthotropic && material.young_modulus.is_zero(); }));
}

bool Config::has_coupled_heat() const {
  return heat && !is_heat_alone() && std::ranges::any_of(contacts, [](const Contact& contact) {
           return contact.conductance.value.depends_on_contact();
         });
}

Value<Config> config_table(const Vocabulary& vocabulary) {
  return table<Config>({
      field<Config>("title", &Config::title, text(), "title of the run; copied to `summary.json`").changeable(),
      field<Config>(
          "units", &Config::units, text(),
          "the units used, such as `\"mm, N, MPa, h, degC\"`; copied to `summary.json` and the field files, and "
          "needed where a material has `use`")
          .changeable(),
      field<Config>("remarks", &Config::remarks, list(text()),
                    "what `check` and `run` repeat as warnings, such as what `import` left out of a deck")
          .changeable(),
      field<Config>("analysis", &Config::analysis, choice<settings::Analysis>("analysis"),
                    "what the mesh is: the `solid` itself, or a section in the plane z = 0 (axisymmetric: x is the "
                    "radius, y the axis)"),
      field<Config>("mesh", &Config::mesh, mesh_table(), "the mesh of all bodies", Presence::required),
      field<Config>("surfaces", &Config::surfaces, named(surface_table()),
                    "names for faces of the mesh or the CAD model, next to its physical surfaces")
          .changeable(),
      field<Config>("bodies", &Config::bodies, named(body_table()), "the bodies; all results list them in this order",
                    Presence::required),
      field<Config>("materials", &Config::materials, named(material_table(vocabulary)), "the materials",
                    Presence::required),
      field<Config>("supports", &Config::supports, tables(support_table()), "prescribed displacements"),
      field<Config>("loads", &Config::loads, tables(load_table()), "external forces"),
      field<Config>("generalized_plane_strain", &Config::generalized_plane_strain, generalized_plane_strain_table(),
                    "the axial strain of sections, common to all bodies or of each by itself"),
      field<Config>("temperature", &Config::temperature, temperature_table(), "temperature of all bodies")
          .otherwise("each material is at its `reference_temperature`"),
      field<Config>("heat", &Config::heat, heat_table(), "the temperature of all bodies is computed")
          .otherwise("it is not"),
      field<Config>("initial_stress", &Config::initial_stress, named(initial_stress_table()),
                    "stress that a body has before it is loaded, by the name of the body"),
      field<Config>("gaskets", &Config::gaskets, named(gasket_table(vocabulary)),
                    "gaskets between surfaces, by the pressure over their closure"),
      field<Config>("contacts", &Config::contacts, tables(contact_table()), "pairs of surfaces in contact"),
      field<Config>("springs", &Config::springs, tables(spring_table(vocabulary)),
                    "springs between surfaces or points, and to the ground"),
      field<Config>("cyclic", &Config::cyclic, tables(cyclic_table()),
                    "cyclic symmetry: the model is one of the sectors of a full circle"),
      field<Config>("rigid", &Config::rigid, tables(rigid_table()), "surfaces that move as rigid bodies"),
      field<Config>("coupling", &Config::coupling, tables(coupling_table()),
                    "surfaces whose mean motion follows a point"),
      field<Config>("equations", &Config::equations, tables(equation_table()),
                    "linear equations between displacements of nodes"),
      field<Config>("contact_solver", &Config::contact_solver, contact_solver_table(),
                    "settings of the contact solver"),
      field<Config>("linear_solver", &Config::linear_solver, linear_solver_table(),
                    "solution with the elastic stiffness")
          .changeable(),
      field<Config>("time", &Config::time, time_table(vocabulary), "time integration", Presence::required).changeable(),
      field<Config>("output", &Config::output, output_table(), "which results are written, and where").changeable(),
      field<Config>("report", &Config::report, report_table(vocabulary),
                    "what a report says next to the results; the run copies it into its output directory")
          .changeable(),
      field<Config>("probes", &Config::probes, tables(probe_table(vocabulary)), "columns of `history.csv`"),
      field<Config>("events", &Config::events, tables(event_table()),
                    "times at which conditions on probes first hold, for `summary.json` and plots"),
      field<Config>("criteria", &Config::criteria, tables(criterion_table(vocabulary)),
                    "what the run is judged by, for `summary.json` and the report"),
      field<Config>("sensitivity", &Config::sensitivity, sensitivity_table(),
                    "derivatives of the results with respect to numbers of this configuration"),
  });
}

}  // namespace creepcontact::config
