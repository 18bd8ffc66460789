/// Element loops and stiffness of plane and axisymmetric sections, for every element type.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>
#include <numeric>

#include "creepcontact/mechanics/body.hpp"
#include "creepcontact/mechanics/loads.hpp"
#include "element_loops.hpp"
#include "support/mechanics/sections.hpp"
#include "support/says.hpp"

namespace creepcontact::test {
namespace section_tests {
namespace {

using mesh::CellType;
using settings::Analysis;

constexpr double inner = 2, width = 1, height = 1.5, thickness = 0.7;

class Sections : public testing::TestWithParam<std::tuple<CellType, Analysis>> {
 protected:
  Analysis analysis() const { return std::get<1>(GetParam()); }
  bool is_axisymmetric() const { return analysis() == Analysis::axisymmetric; }
  /// Sets what the section holds to zero.
  template <typename Values>
  void clear_held(Values& values) const {
    for (std::size_t node = 0; node < mesh.n_cell_nodes(); ++node) values[3 * node + 2] = 0;
    if (mesh.axial_node >= 0) values[3 * mesh.axial_node] = values[3 * mesh.axial_node + 1] = 0;
  }
  std::vector<double> in_plane_noise(unsigned seed) const {
    std::vector<double> values = noise(3 * mesh.nodes.size(), seed);
    clear_held(values);
    return values;
  }
  std::vector<Moduli> varied_moduli() const {
    std::vector<Moduli> all;
    for (std::size_t p = 0; p < body.n_points(); ++p)
      all.push_back(material::lame(100.0 + static_cast<double>(p), 0.3));
    return all;
  }
  /// B u with the projection.
  std::vector<double> stress(const std::vector<double>& u, const ElasticState& elastic) const {
    std::vector<double> values(6 * body.n_points());
    body.stress(u, elastic, {}, values);
    return values;
  }

  mesh::Mesh mesh =
      section_mesh(std::get<0>(GetParam()), {4, 3}, {width, height}, {inner, 0.3}, {analysis(), thickness}, 0.2);
  Discretization body{mesh};
  std::vector<Moduli> uniform_moduli{material::lame(100, 0.3)};
};

TEST_P(Sections, WeightsFillTheVolume) {
  const double volume = is_axisymmetric() ? std::numbers::pi * (std::pow(inner + width, 2) - inner * inner) * height
                                          : width * height * thickness;
  EXPECT_NEAR(std::accumulate(body.weights().begin(), body.weights().end(), 0.0), volume, 1e-12 * volume);
}

TEST_P(Sections, UniformStrainIsExactAndInEquilibrium) {
  // In axisymmetry u_x = c x alone is uniform.
  const double c = 2e-3, d = -1e-3, axial = 4e-3, shear = is_axisymmetric() ? 0 : 3e-3;
  std::vector<double> u = nodal_field(
      mesh, [&](const Vector3& x) { return Vector3(c * x.x() + shear * x.y(), d * x.y() - shear / 3 * x.x(), axial); });
  clear_held(u);
  double zz = 0;
  if (is_axisymmetric()) zz = c;
  if (analysis() == Analysis::generalized_plane_strain) zz = axial;
  if (analysis() == Analysis::plane_stress) zz = -0.3 / 0.7 * (c + d);
  Tensor6 strain = Tensor6::Zero();
  strain << c, d, zz, tensor::sqrt2 / 2 * (shear - shear / 3), 0, 0;
  const Tensor6 expected = material::stress(uniform_moduli[0], strain);
  const std::vector<double> found = stress(u, {uniform_moduli});
  for (const Tensor6& at_point : as_tensors(found)) EXPECT_LT((at_point - expected).norm(), 1e-12 * expected.norm());

  std::vector<double> forces(3 * mesh.nodes.size(), 0.0);
  body.add_internal_force(found, forces);
  if (mesh.axial_node >= 0) {
    EXPECT_NEAR(forces[3 * mesh.axial_node + 2], expected[2] * width * height * thickness, 1e-12 * largest(forces));
  }
  for (std::size_t i = 0; i < mesh.n_cell_nodes(); ++i) {
    const Vector3& x = mesh.nodes[i];
    const bool inside =
        x.x() > inner + 1e-9 && x.x() < inner + width - 1e-9 && x.y() > 0.3 + 1e-9 && x.y() < 0.3 + height - 1e-9;
    EXPECT_LT(inside ? Vector3::Map(&forces[3 * i]).norm() : 0, 1e-12 * largest(forces));
    EXPECT_EQ(forces[3 * i + 2], 0);
  }
}

TEST_P(Sections, InternalForceDoesTheWorkOfTheStress) {
  const std::vector<double> u = in_plane_noise(1), v = in_plane_noise(2);
  const std::vector<Moduli> moduli = varied_moduli();
  const std::vector<double> of_u = stress(u, {moduli}), of_v = stress(v, {moduli});
  std::vector<double> forces(u.size(), 0.0);
  body.add_internal_force(of_v, forces);
  double work = 0;
  for (std::size_t p = 0; p < body.n_points(); ++p)
    work += body.weights()[p] *
            material::elastic_strain(moduli[p], Tensor6::Map(&of_u[6 * p])).dot(Tensor6::Map(&of_v[6 * p]));
  EXPECT_NEAR(dot(forces, u), work, 1e-11 * std::abs(work) + 1e-9);
}

TEST_P(Sections, StiffnessTimesDisplacementIsTheInternalForce) {
  const std::vector<double> u = in_plane_noise(3);
  const std::vector<Moduli> moduli = varied_moduli();
  std::vector<Matrix6> matrices;
  for (const Moduli& h : moduli) {
    Matrix6 matrix;
    for (Eigen::Index k = 0; k < 6; ++k) matrix.col(k) = material::stress(h, Tensor6::Unit(k));
    matrices.push_back(matrix);
  }
  std::vector<double> expected(u.size(), 0.0);
  body.add_internal_force(stress(u, {moduli}), expected);
  const Eigen::Map<const Eigen::VectorXd> force(expected.data(), std::ssize(expected)),
      displacement(u.data(), std::ssize(u));
  for (const linalg::SparseMatrix& lower : {body.stiffness(ElasticState{moduli}), body.stiffness(matrices)}) {
    Eigen::VectorXd product = lower.selfadjointView<Eigen::Lower>() * displacement;
    clear_held(product);
    EXPECT_LT((product - force).norm(), 1e-12 * force.norm());
  }
}

TEST_P(Sections, InitialStrainForceIsThatOfItsStress) {
  std::vector<double> creep = noise(6 * body.n_points(), 6), thermal = noise(body.n_points(), 7);
  const std::vector<Moduli> moduli = varied_moduli();
  const ElasticState elastic{moduli, thermal};
  const std::vector<double> zero(3 * mesh.nodes.size(), 0.0);
  std::vector<double> stress(6 * body.n_points()), expected(zero.size(), 1.0), forces(zero.size(), 1.0);
  body.stress(zero, elastic, {creep, 6}, stress);
  for (double& value : stress) value = -value;
  body.add_internal_force(stress, expected);
  body.add_initial_strain_force(elastic, {creep, 6}, forces);
  for (std::size_t i = 0; i < forces.size(); ++i) EXPECT_NEAR(forces[i], expected[i], 1e-11 * largest(expected));
}

/// The tangent loops with isotropic moduli D and the initial stress D creep are those of elasticity with creep strain.
TEST_P(Sections, TangentLoopsWithIsotropicModuliAreElastic) {
  const std::vector<double> u = in_plane_noise(4);
  std::vector<double> creep = noise(6 * body.n_points(), 5);
  for (std::size_t p = 0; p < body.n_points(); ++p)
    tensor::writable(creep, p) = tensor::deviator(Tensor6::Map(&creep[6 * p])).eval();
  const std::vector<Moduli> moduli = varied_moduli();
  std::vector<Matrix6> matrices(moduli.size());
  std::vector<double> initial(creep.size()), strain(creep.size()), expected(creep.size());
  for (std::size_t p = 0; p < moduli.size(); ++p) {
    for (Eigen::Index k = 0; k < 6; ++k) matrices[p].col(k) = material::stress(moduli[p], Tensor6::Unit(k));
    tensor::writable(initial, p) = matrices[p] * Tensor6::Map(&creep[6 * p]);
  }
  body.stress(u, {moduli}, {creep, 6}, expected);
  body.tangent_strain(u, matrices, initial, strain);
  for (std::size_t p = 0; p < moduli.size(); ++p) {
    const Tensor6 found = matrices[p] * Tensor6::Map(&strain[6 * p]) - Tensor6::Map(&initial[6 * p]);
    EXPECT_LT((found - Tensor6::Map(&expected[6 * p])).norm(), 1e-11 * found.norm());
  }
  std::vector<double> force(u.size(), 0.0), expected_force(u.size(), 0.0);
  body.add_initial_strain_force({moduli}, {creep, 6}, expected_force);
  body.add_initial_stress_force(matrices, initial, force);
  clear_held(force);
  clear_held(expected_force);
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(force[i], expected_force[i], 1e-11 * largest(expected_force));
}

INSTANTIATE_TEST_SUITE_P(Types, Sections,
                         testing::Combine(testing::Values(CellType::tri3, CellType::tri6, CellType::quad4,
                                                          CellType::quad8, CellType::quad9),
                                          testing::Values(Analysis::plane_strain, Analysis::axisymmetric,
                                                          Analysis::plane_stress, Analysis::generalized_plane_strain)),
                         [](const auto& of) {
                           return fmt::format("{}_{}", mesh::name(std::get<0>(of.param)),
                                              settings::name_of(std::get<1>(of.param)));
                         });

/// Thick cylinder under inner pressure in plane strain, nearly incompressible: as an axisymmetric section, and as a
/// quarter of the plane one. Source: G. Lame (1852).
struct Lame {
  static constexpr double a = 100, b = 200, pressure = 50, E = 1e5, nu = 0.4999;
  static constexpr double k = pressure * a * a / (b * b - a * a);
  static double radial(double r) { return k * (1 - b * b / (r * r)); }
  static double hoop(double r) { return k * (1 + b * b / (r * r)); }
  static double displacement(double r) { return (1 + nu) / E * k * ((1 - 2 * nu) * r + b * b / r); }
};

mechanics::Support held(const mesh::Mesh& mesh, const std::string& group, const Vector3& direction) {
  return {.on = group, .nodes = mesh::group_nodes(mesh, group), .directions = {direction}, .value = 0.0};
}

class LameCylinder : public testing::TestWithParam<CellType> {
 protected:
  /// Relative errors of the displacement of the bore and of the stresses at the points.
  static void expect_exact(mechanics::Body& body, const std::string& bore, double tolerance) {
    body.add_load(mechanics::pressure_load(body.mesh(), mesh::boundary_faces(body.mesh(), bore), Lame::pressure));
    const std::vector<double> u = solve(body);
    for (const std::int64_t node : mesh::group_nodes(body.mesh(), bore))
      EXPECT_NEAR(Vector3::Map(&u[3 * node]).norm(), Lame::displacement(Lame::a),
                  tolerance * Lame::displacement(Lame::a));
    std::vector<double> stress = stress_of(body, u);
    body.discretization().fit_mean_stress(stress);
    for (std::size_t p = 0; p < body.discretization().n_points(); ++p) {
      const Vector3& x = body.discretization().point_coordinates()[p];
      const Matrix3 found = tensor::to_matrix(Tensor6::Map(&stress[6 * p]));
      const bool section = body.mesh().section.is_axisymmetric();
      const double r = section ? x.x() : x.head<2>().norm();
      const Vector3 outward = section ? Vector3(1, 0, 0) : Vector3(x / r);
      const Vector3 around = section ? Vector3(0, 0, 1) : Vector3(-outward.y(), outward.x(), 0);
      EXPECT_NEAR(outward.dot(found * outward), Lame::radial(r), 20 * tolerance * Lame::pressure) << r;
      EXPECT_NEAR(around.dot(found * around), Lame::hoop(r), 20 * tolerance * Lame::pressure) << r;
    }
  }
  static double tolerance() { return mesh::order(GetParam()) == 2 ? 1e-3 : 5e-3; }
  static int divisions() { return mesh::order(GetParam()) == 2 ? 8 : 24; }
};

TEST_P(LameCylinder, AxisymmetricSection) {
  const mesh::Mesh mesh =
      section_mesh(GetParam(), {divisions(), 2}, {Lame::b - Lame::a, 20}, {Lame::a, 0}, {Analysis::axisymmetric, 1});
  mechanics::Body body("wall", mesh, elastic_material(Lame::E, Lame::nu),
                       {held(mesh, "y0", Vector3::UnitY()), held(mesh, "y1", Vector3::UnitY())}, std::nullopt);
  EXPECT_TRUE(body.free_motions().empty());
  expect_exact(body, "x0", tolerance());
}

TEST_P(LameCylinder, PlaneStrain) {
  mesh::Mesh mesh = section_mesh(GetParam(), {divisions(), divisions()}, {Lame::b - Lame::a, std::numbers::pi / 2},
                                 {Lame::a, 0}, {Analysis::plane_strain, 3});
  for (Vector3& x : mesh.nodes) x = Vector3(x.x() * std::cos(x.y()), x.x() * std::sin(x.y()), 0);
  mechanics::Body body("wall", mesh, elastic_material(Lame::E, Lame::nu),
                       {held(mesh, "y0", Vector3::UnitY()), held(mesh, "y1", Vector3::UnitX())}, std::nullopt);
  expect_exact(body, "x0", tolerance());
}

INSTANTIATE_TEST_SUITE_P(Types, LameCylinder,
                         testing::Values(CellType::tri6, CellType::quad4, CellType::quad8, CellType::quad9),
                         [](const auto& of) { return std::string(mesh::name(of.param)); });

/// Loads on curves are those of the whole circumference, or of the thickness.
TEST(SectionLoads, PressureAndTractionOverTheDepth) {
  for (const bool is_axisymmetric : {false, true}) {
    const mesh::Mesh mesh =
        section_mesh(CellType::quad8, {3, 2}, {width, height}, {inner, 0},
                     {is_axisymmetric ? Analysis::axisymmetric : Analysis::plane_strain, thickness});
    mechanics::Body body("ring", mesh, elastic_material(), {}, std::nullopt);
    body.add_load(mechanics::pressure_load(mesh, mesh::boundary_faces(mesh, "y1"), 3.0));
    body.add_load(mechanics::traction_load(mesh, mesh::boundary_faces(mesh, "x1"), {0.0, 2.0, 0.0}));
    const double outer = inner + width;
    const double top = is_axisymmetric ? std::numbers::pi * (outer * outer - inner * inner) : width * thickness;
    const double side = is_axisymmetric ? 2 * std::numbers::pi * outer * height : height * thickness;
    const Vector3 found = resultant(body.at(0).external_forces());
    EXPECT_NEAR(found.y(), 2 * side - 3 * top, 1e-11 * top);
    EXPECT_NEAR(found.z(), 0, 1e-12);
  }
}

/// A ring that nothing holds slides along its axis alone; a plane section moves and turns in its plane.
TEST(SectionMotions, OfFreeSections) {
  const auto motions = [](Analysis analysis) {
    const mesh::Mesh mesh = section_mesh(CellType::quad4, {2, 2}, {1, 1}, {1, 0}, {analysis, 1});
    const mechanics::Body body("ring", mesh, elastic_material(), {}, std::nullopt);
    std::vector<std::string> words;
    for (const mechanics::FreeMotion& motion : body.free_motions()) words.push_back(motion.description);
    return words;
  };
  ASSERT_EQ(motions(Analysis::axisymmetric).size(), 1u);
  EXPECT_TRUE(creepcontact::test::says(motions(Analysis::axisymmetric)[0], {"translation", " y"}));
  EXPECT_EQ(motions(Analysis::plane_strain).size(), 3u);
}

/// On the axis the hoop strain is the radial one: a solid shaft needs no supports there.
TEST(SectionAxis, SolidShaftUnderPressure) {
  for (const CellType type : {CellType::tri6, CellType::quad4, CellType::quad8, CellType::quad9}) {
    const mesh::Mesh mesh = section_mesh(type, {4, 3}, {1, 1}, {0, 0}, {Analysis::axisymmetric, 1});
    mechanics::Body body("shaft", mesh, elastic_material(200, 0.3), {held(mesh, "y0", Vector3::UnitY())}, std::nullopt);
    body.add_load(mechanics::pressure_load(mesh, mesh::boundary_faces(mesh, "x1"), 5.0));
    for (const Tensor6& stress : as_tensors(stress_of(body, solve(body)))) {
      EXPECT_NEAR(stress[0], -5, 1e-9) << mesh::name(type);
      EXPECT_NEAR(stress[1], 0, 1e-9);
      EXPECT_NEAR(stress[2], -5, 1e-9);
    }
  }
}

/// A quarter of a ball under pressure all around, its elements with curved edges: uniform stress, the axis included.
TEST(SectionAxis, UniformStressInCurvedElements) {
  for (const CellType type : {CellType::tri6, CellType::quad8, CellType::quad9}) {
    mesh::Mesh mesh = section_mesh(type, {3, 4}, {1, std::numbers::pi / 2}, {1, 0}, {Analysis::axisymmetric, 1});
    for (Vector3& x : mesh.nodes) x = Vector3(x.y() > 1.57 ? 0.0 : x.x() * std::cos(x.y()), x.x() * std::sin(x.y()), 0);
    mechanics::Body body("shell", mesh, elastic_material(200, 0.3), {held(mesh, "y0", Vector3::UnitY())}, std::nullopt);
    for (const char* surface : {"x0", "x1"})
      body.add_load(mechanics::pressure_load(mesh, mesh::boundary_faces(mesh, surface), 5.0));
    const double tolerance = type == CellType::tri6 ? 0.02 : 1e-9;  // curved triangles: of second order
    for (const Tensor6& stress : as_tensors(stress_of(body, solve(body))))
      EXPECT_LT((stress - Tensor6(-5 * tensor::identity())).norm(), tolerance) << mesh::name(type);
  }
}

/// Uniaxial tension in plane stress, smoothed to the nodes.
TEST(SectionFields, PlaneStressAtNodes) {
  for (const CellType type : {CellType::tri3, CellType::tri6, CellType::quad4, CellType::quad8, CellType::quad9}) {
    const mesh::Mesh mesh = section_mesh(type, {3, 2}, {2, 1}, {0, 0}, {Analysis::plane_stress, 1}, 0.2);
    mechanics::Body body("plate", mesh, elastic_material(200, 0.3),
                         {held(mesh, "y0", Vector3::UnitY()), held(mesh, "x0", Vector3::UnitX())}, std::nullopt);
    body.add_load(mechanics::pressure_load(mesh, mesh::boundary_faces(mesh, "x1"), -5.0));
    std::vector<double> stress = stress_of(body, solve(body)), at_nodes(6 * mesh.nodes.size());
    body.discretization().fit_mean_stress(stress);
    body.discretization().tensors_to_nodes(stress, at_nodes);
    for (const Tensor6& at : as_tensors(at_nodes)) {
      EXPECT_LT((at - 5 * Tensor6::Unit(0)).norm(), 1e-10) << mesh::name(type);
      EXPECT_NEAR(at[2], 0, 1e-14) << mesh::name(type);
    }
  }
}

}  // namespace
}  // namespace section_tests
}  // namespace creepcontact::test
