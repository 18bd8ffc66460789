#pragma once
/// What a body consists of.

#include "creepcontact/mechanics/body.hpp"
#include "section_supports.hpp"

namespace creepcontact::mechanics {

struct Body::Impl {
  Impl(std::string name_in, mesh::Mesh mesh_in, material::Material material_in, std::vector<Support> supports_in,
       std::optional<TemperatureField> temperature_in, const NodeLinks& links, std::optional<MaterialAxes> axes_in,
       StressField initial_stress_in)
      : name(std::move(name_in)),
        mesh(std::move(mesh_in)),
        material(std::move(material_in)),
        supports(std::move(supports_in)),
        discretization(mesh),
        constraints(mesh.nodes, with_section_supports(mesh, supports), links),
        parts(mesh_parts(mesh)),
        free_motions(mechanics::free_motions(mesh, parts, constraints)),
        fixing_dofs(determinate_fixing_dofs(free_motions, constraints)),
        temperature(std::move(temperature_in)),
        axes_of_place(std::move(axes_in)),
        initial_stress(std::move(initial_stress_in)) {
    prepare_points();
  }

  /// See Body::part().
  Impl(const Impl& whole, std::span<const std::size_t> elements)
      : name(whole.name),
        mesh(whole.mesh),
        material(whole.material),
        supports(whole.supports),
        discretization(Discretization::part(whole.mesh, elements)),
        constraints(whole.constraints),
        parts(whole.parts),
        free_motions(whole.free_motions),
        fixing_dofs(whole.fixing_dofs),
        temperature(whole.temperature),
        axes_of_place(whole.axes_of_place),
        initial_stress(whole.initial_stress),
        own_elements(std::vector<std::size_t>(elements.begin(), elements.end())) {
    prepare_points();
  }

  /// What depends on the places of the points.
  void prepare_points() {
    if (temperature) temperature_at_points = temperature->at_points(discretization, mesh);
    if (axes_of_place && material.has_axes())
      axes = axes_of_place->at_points(discretization.point_coordinates(), mesh.section);
    set_initial_strain();
  }
  /// From the initial stress, with the elastic constants at the reference temperature.
  void set_initial_strain();

  std::string name;
  mesh::Mesh mesh;
  material::Material material;
  std::vector<Support> supports;
  Discretization discretization;
  Constraints constraints;
  MeshParts parts;
  std::vector<FreeMotion> free_motions;
  std::vector<std::int64_t> fixing_dofs;
  std::optional<TemperatureField> temperature;
  std::unique_ptr<const TemperatureAtPositions> temperature_at_points;
  std::optional<MaterialAxes> axes_of_place;
  std::vector<Matrix3> axes{Matrix3::Identity()};  // of the material, one for all points or one per point
  StressField initial_stress;
  std::vector<double> initial_strain;  // Body::initial_strain()
  std::vector<std::unique_ptr<const Load>> loads;
  std::optional<std::vector<std::size_t>> own_elements;  // of a part
};

}  // namespace creepcontact::mechanics
