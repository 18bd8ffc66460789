/// No element locks in (almost) incompressible deformation: nearly incompressible elasticity, and creep strain far
/// beyond the elastic strain, on thick cylinders and spheres under internal pressure.

#include <fmt/format.h>

#include <cstdlib>

#include "creepcontact/material/registry.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/results/snapshot.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/sections.hpp"
#include "support/mechanics/solve.hpp"
#include "verification/case.hpp"
#include "verification/reference/thick_cylinder.hpp"
#include "verification/stress_runs.hpp"

namespace creepcontact::test {
namespace locking_tests {
namespace {

constexpr double inner = 100, outer = 200, pressure = 200, young = 200e3, A = 3.125e-14, n = 5;

/// Principal stresses (radial, hoop, third) of a state that depends on the radius alone.
using Exact = std::function<Vector3(double radius)>;

/// Steady state of a hollow sphere of Norton's law under internal pressure.
Vector3 sphere(double r) {
  const double shape = std::pow(outer / r, 3 / n), wall = std::pow(outer / inner, 3 / n) - 1;
  const double radial = -pressure * (shape - 1) / wall, q = pressure * 1.5 / n * shape / wall;
  return {radial, radial + q, radial + q};
}

Vector3 cylinder(double r) {
  constexpr reference::ThickCylinder exact{inner, outer, pressure};
  return {exact.steady_sigma_r(r, n), exact.steady_sigma_theta(r, n), exact.steady_sigma_z(r, n)};
}

/// Of the largest stress.
struct Errors {
  double mean_at_points = 0;  ///< mean stress at an integration point
  double at_nodes = 0;        ///< any component at a node
};

/// A sphere, a cylinder about z, or the axisymmetric section of a cylinder.
enum class Form { sphere, cylinder, ring };

struct Shape {
  mesh::Mesh mesh;
  std::vector<mechanics::Support> supports;
  Form form;
  std::string bore;
};

/// A wedge of a slice of a cylinder, held in z.
Shape cylinder_mesh(CellType type, std::array<int, 3> divisions, double distortion) {
  constexpr double angle = std::numbers::pi / 6;
  mesh::Mesh mesh = mapped(box_mesh(type, divisions, {outer - inner, angle, 20.0}, Vector3::Zero(), distortion),
                           [&](const Vector3& x) {
                             return Vector3((inner + x[0]) * std::cos(x[1]), (inner + x[0]) * std::sin(x[1]), x[2]);
                           });
  std::vector<mechanics::Support> supports{
      support(mesh, "y0", Vector3::UnitY()), support(mesh, "y1", {-std::sin(angle), std::cos(angle), 0}),
      support(mesh, "z0", Vector3::UnitZ()), support(mesh, "z1", Vector3::UnitZ())};
  return {std::move(mesh), std::move(supports), Form::cylinder, "x0"};
}

/// The part of a spherical shell within a square pyramid with its tip at the centre.
Shape sphere_mesh(CellType type, std::array<int, 3> divisions, double distortion) {
  constexpr double half = std::numbers::pi / 12;
  mesh::Mesh mesh =
      mapped(box_mesh(type, divisions, {2 * half, 2 * half, outer - inner}, {-half, -half, 0}, distortion),
             [](const Vector3& x) {
               return Vector3((inner + x[2]) * Vector3(std::tan(x[0]), std::tan(x[1]), 1).normalized());
             });
  std::vector<mechanics::Support> supports;
  const double c = std::cos(half), s = std::sin(half);
  supports.push_back(support(mesh, "x0", {c, 0, s}));
  supports.push_back(support(mesh, "x1", {c, 0, -s}));
  supports.push_back(support(mesh, "y0", {0, c, s}));
  supports.push_back(support(mesh, "y1", {0, c, -s}));
  return {std::move(mesh), std::move(supports), Form::sphere, "z0"};
}

Tensor6 exact_tensor(const Vector3& x, Form form, const Exact& exact) {
  if (form == Form::ring) {
    const Vector3 stress = exact(x[0]);
    return tensor::from_matrix(Vector3(stress[0], stress[2], stress[1]).asDiagonal().toDenseMatrix());
  }
  const Vector3 arm = form == Form::sphere ? x : Vector3(x[0], x[1], 0);
  const Vector3 e = arm.normalized(), stress = exact(arm.norm());
  Matrix3 s = stress[1] * Matrix3::Identity() + (stress[0] - stress[1]) * e * e.transpose();
  if (form == Form::cylinder) s(2, 2) = stress[2];
  return tensor::from_matrix(s);
}

Errors errors(results::Snapshot& snapshot, const mechanics::Body& body, Form form, const Exact& exact) {
  const results::BodyFields& fields = snapshot.fields(0);
  Errors result;
  double largest = 0;
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
    const Tensor6 reference = exact_tensor(body.mesh().nodes[i], form, exact);
    largest = std::max(largest, reference.head<3>().cwiseAbs().maxCoeff());
    result.at_nodes = std::max(result.at_nodes, (fields.at_node(i).stress - reference).cwiseAbs().maxCoeff());
  }
  for (std::size_t p = 0; p < fields.n_points(); ++p) {
    const results::Sample at = fields.at_point(p);
    const Tensor6 difference = at.stress - exact_tensor(at.position, form, exact);
    result.mean_at_points = std::max(result.mean_at_points, std::abs(tensor::trace(difference)) / 3);
  }
  result.at_nodes /= largest;
  result.mean_at_points /= largest;
  return result;
}

/// At the times when the creep strain at the bore is as given.
std::vector<Errors> errors_in_creep(const creep::Assembly& assembly, Form form, const Exact& exact,
                                    const std::vector<double>& creep_strains) {
  const Vector3 bore = exact(inner);
  const double q = form == Form::sphere ? bore[1] - bore[0] : std::sqrt(3.0) / 2 * (bore[1] - bore[0]);
  std::vector<double> times{0.0};
  for (const double strain : creep_strains) times.push_back(strain / (A * std::pow(q, n)));
  Stopwatch watch;
  creep::EquilibriumSolver solver(assembly, {}, watch);
  creep::CreepSystem system(solver, creep::survey_elastic_stress(solver, times, {}), 1e-3, watch);
  ode::IntegratorOptions options{.tolerance = 1e-3};
  options.end_time = times.back();
  const auto integrator = ode::make_integrator("cvode_bdf", system, options);
  std::vector<double> state(system.size(), 0.0);
  integrator->initialize(0, state);
  std::vector<Errors> result;
  for (auto next = times.begin() + 1; next != times.end();) {
    integrator->step(times.back());
    for (; next != times.end() && *next <= integrator->time(); ++next) {
      integrator->interpolate(*next, state);
      results::Snapshot snapshot(system, *next, system.evaluate_output(*next, state));
      result.push_back(errors(snapshot, assembly.bodies()[0], form, exact));
    }
  }
  return result;
}

creep::Assembly assembly_of(const Shape& shape, const material::Material& material) {
  std::vector<mechanics::Body> bodies;
  bodies.emplace_back("wall", shape.mesh, material, shape.supports, std::nullopt);
  bodies[0].add_load(mechanics::pressure_load(shape.mesh, mesh::boundary_faces(shape.mesh, shape.bore), pressure));
  return {std::move(bodies), {}};
}

material::Material norton() {
  material::Material material = elastic_material(young, 0.3);
  material.creep.push_back(material::find_creep_law("norton")->make_by_key({{"A", {A}}, {"n", {n}}}));
  return material;
}

struct Case {
  CellType type;
  std::array<int, 3> divisions;  ///< of the cylinder: radial, around, axial
  double distortion;
};

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return fmt::format("{}_{}", mesh::name(info.param.type), info.param.distortion > 0 ? "distorted" : "structured");
}

class LockingOfElements : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Types, LockingOfElements,
                         testing::Values(Case{CellType::hex8, {30, 12, 2}, 0}, Case{CellType::hex20, {8, 3, 2}, 0},
                                         Case{CellType::hex27, {8, 3, 2}, 0}, Case{CellType::wedge15, {8, 3, 2}, 0},
                                         Case{CellType::tet10, {12, 5, 2}, 0}, Case{CellType::hex8, {30, 12, 2}, 0.25},
                                         Case{CellType::hex20, {8, 3, 2}, 0.25}, Case{CellType::hex27, {8, 3, 2}, 0.25},
                                         Case{CellType::wedge15, {8, 3, 2}, 0.25},
                                         Case{CellType::tet10, {12, 5, 2}, 0.25}),
                         name_of);

/// @param all  in the order of increasing creep strain
void expect_small(const std::vector<Errors>& all) {
  for (const Errors& error : all) {
    if (std::getenv("SHOW")) fmt::print("   points {:.4f}  nodes {:.4f}\n", error.mean_at_points, error.at_nodes);
    EXPECT_LT(error.mean_at_points, 0.05);
    EXPECT_LT(error.at_nodes, 0.02);
  }
  // From 10 to 100 % creep strain nothing but the last digits changes.
  if (all.size() > 1) {
    EXPECT_LT(all.back().mean_at_points, 1.1 * all[all.size() - 2].mean_at_points + 0.003);
    EXPECT_LT(all.back().at_nodes, 1.1 * all[all.size() - 2].at_nodes + 0.003);
  }
}

TEST_P(LockingOfElements, CylinderThatCreeps) {
  const Shape shape = cylinder_mesh(GetParam().type, GetParam().divisions, GetParam().distortion);
  expect_small(errors_in_creep(assembly_of(shape, norton()), shape.form, cylinder, {0.05, 0.1, 1.0}));
}

TEST_P(LockingOfElements, SphereThatCreeps) {
  const auto [radial, around, axial] = GetParam().divisions;
  const Shape shape = sphere_mesh(GetParam().type, {around, around, radial}, GetParam().distortion);
  expect_small(errors_in_creep(assembly_of(shape, norton()), shape.form, sphere, {0.01, 0.1, 1.0}));
}

/// From equator to pole, 30 degrees wide, meshed by Gmsh.
TEST(Locking, SphereOfGmshTetrahedraThatCreeps) {
  const CaseDirectory directory(R"(
    SetFactory("OpenCASCADE");
    Sphere(1) = {0, 0, 0, 200, 0, Pi/2, Pi/6}; Sphere(2) = {0, 0, 0, 100, 0, Pi/2, Pi/6};
    BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
    Mesh.MeshSizeMax = 11; Mesh.MeshSizeMin = 11;
    Physical Volume("wall") = {3};
    e = 1e-3;
    bore[] = Surface In BoundingBox{-e, -e, -e, 100 + e, 100 + e, 100 + e};
    tilted[] = Surface In BoundingBox{-e, -e, -e, 175, 101, 200 + e}; tilted[] -= bore[];
    Physical Surface("bore") = {bore[]};
    Physical Surface("tilted") = {tilted[]};
    Physical Surface("y") = Surface In BoundingBox{-e, -e, -e, 200 + e, e, 200 + e};
    Physical Surface("z") = Surface In BoundingBox{-e, -e, -e, 200 + e, 200 + e, e};
  )");
  const model::Model model = model::build_model(directory.config(fmt::format(R"(
    [mesh]
    file = "case.geo"
    [bodies.wall]
    region = "wall"
    material = "steel"
    [materials.steel]
    young_modulus = {}
    poisson_ratio = 0.3
    [[materials.steel.creep]]
    law = "norton"
    A = {}
    n = {}
    [[supports]]
    on = "tilted"
    displacement = {{ normal = 0 }}
    [[supports]]
    on = "y"
    displacement = {{ y = 0 }}
    [[supports]]
    on = "z"
    displacement = {{ z = 0 }}
    [[loads]]
    on = "bore"
    pressure = {}
    [time]
    end = 1
  )",
                                                                             young, A, n, pressure),
                                                                 {}));
  expect_small(errors_in_creep(model.assembly, Form::sphere, sphere, {0.01, 0.1, 1.0}));
}

void expect_nearly_incompressible(const Shape& shape) {
  constexpr double nu = 0.4999;
  constexpr reference::ThickCylinder lame{inner, outer, pressure};
  const creep::Assembly assembly = assembly_of(shape, elastic_material(young, nu));
  Stopwatch watch;
  creep::EquilibriumSolver solver(assembly, {}, watch);
  creep::CreepSystem system(solver, {}, 1e-3, watch);
  results::Snapshot snapshot(system, 0, system.evaluate_output(0, {}));
  expect_small({errors(snapshot, assembly.bodies()[0], shape.form, [&](double r) {
    return Vector3(lame.elastic_sigma_r(r), lame.elastic_sigma_theta(r), lame.elastic_sigma_z(nu));
  })});
}

TEST_P(LockingOfElements, NearlyIncompressibleCylinder) {
  expect_nearly_incompressible(cylinder_mesh(GetParam().type, GetParam().divisions, GetParam().distortion));
}

/// A section of a cylinder: axisymmetric, or a sector in plane strain.
Shape section_of_cylinder(const Case& of, Form form) {
  constexpr double angle = std::numbers::pi / 6;
  const auto [radial, around, axial] = of.divisions;
  if (form == Form::ring) {
    mesh::Mesh mesh = section_mesh(of.type, {radial, axial}, {outer - inner, 20}, {inner, 0},
                                   {settings::Analysis::axisymmetric}, of.distortion);
    std::vector<mechanics::Support> supports{support(mesh, "y0", Vector3::UnitY()),
                                             support(mesh, "y1", Vector3::UnitY())};
    return {std::move(mesh), std::move(supports), form, "x0"};
  }
  mesh::Mesh mesh = section_mesh(of.type, {radial, around}, {outer - inner, angle}, {inner, 0},
                                 {settings::Analysis::plane_strain}, of.distortion);
  mesh = mapped(mesh, [](const Vector3& x) { return Vector3(x[0] * std::cos(x[1]), x[0] * std::sin(x[1]), 0); });
  std::vector<mechanics::Support> supports{support(mesh, "y0", Vector3::UnitY()),
                                           support(mesh, "y1", {-std::sin(angle), std::cos(angle), 0})};
  return {std::move(mesh), std::move(supports), form, "x0"};
}

/// From the axis to 30 degrees below the equator: the axis needs no support.
Shape section_of_sphere(const Case& of) {
  constexpr double from = std::numbers::pi / 6, angle = std::numbers::pi / 2 - from;
  const auto [radial, around, axial] = of.divisions;
  mesh::Mesh mesh = section_mesh(of.type, {radial, 3 * around}, {outer - inner, angle}, {inner, from},
                                 {settings::Analysis::axisymmetric}, of.distortion);
  mesh = mapped(mesh, [](const Vector3& x) {
    const bool on_axis = x[1] > std::numbers::pi / 2 - 1e-12;
    return Vector3(on_axis ? 0.0 : x[0] * std::cos(x[1]), x[0] * std::sin(x[1]), 0);
  });
  std::vector<mechanics::Support> supports{support(mesh, "y0", {-std::sin(from), std::cos(from), 0})};
  return {std::move(mesh), std::move(supports), Form::sphere, "x0"};
}

class LockingOfSections : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Types, LockingOfSections,
                         testing::Values(Case{CellType::quad4, {30, 12, 3}, 0}, Case{CellType::quad8, {8, 3, 2}, 0},
                                         Case{CellType::quad9, {8, 3, 2}, 0}, Case{CellType::tri6, {8, 3, 2}, 0},
                                         Case{CellType::quad4, {30, 12, 3}, 0.25},
                                         Case{CellType::quad8, {8, 3, 2}, 0.25}, Case{CellType::quad9, {8, 3, 2}, 0.25},
                                         Case{CellType::tri6, {8, 3, 2}, 0.25}),
                         name_of);

TEST_P(LockingOfSections, CylinderThatCreeps) {
  for (const Form form : {Form::ring, Form::cylinder})
    expect_small(errors_in_creep(assembly_of(section_of_cylinder(GetParam(), form), norton()), form, cylinder,
                                 {0.05, 0.1, 1.0}));
}

TEST_P(LockingOfSections, SphereThatCreeps) {
  expect_small(
      errors_in_creep(assembly_of(section_of_sphere(GetParam()), norton()), Form::sphere, sphere, {0.01, 0.1, 1.0}));
}

TEST_P(LockingOfSections, NearlyIncompressibleCylinder) {
  for (const Form form : {Form::ring, Form::cylinder})
    expect_nearly_incompressible(section_of_cylinder(GetParam(), form));
}

}  // namespace
}  // namespace locking_tests
}  // namespace creepcontact::test
