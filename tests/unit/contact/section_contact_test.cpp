/// Contact between the edges of plane and axisymmetric sections.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "support/contact/boxes.hpp"
#include "support/mechanics/sections.hpp"
#include "unit/contact/accelerations.hpp"

namespace creepcontact::test {
namespace section_contact_tests {
namespace {

using contact::CondensedInterface;
using contact::ContactType;
using mesh::CellType;
using settings::Analysis;

constexpr double inner = 2, width = 1, height = 1, pressure = 4, thickness = 0.7, poisson_ratio = 0.3;

struct Section {
  CellType type;
  Analysis analysis;
  bool lower_is_slave = true;
  ContactType contact = ContactType::unilateral;
};

mechanics::Support held(const mesh::Mesh& mesh, const std::string& group, const Vector3& direction) {
  return {.on = group, .nodes = mesh::group_nodes(mesh, group), .directions = {direction}, .value = 0.0};
}

contact::Surface surface(const mechanics::Body& body, const std::string& name) {
  return {name, &body.mesh(), &body.constraints(), mesh::boundary_faces(body.mesh(), name), 1.0};
}

/// One section on another; a pressure on top is all that holds the upper one down. In plane sections both slide along
/// x, the lower one held at a corner: the motion that contact cannot hold is held by supports of the upper one.
std::unique_ptr<Condensed> sections(const Section& of, double dense_bytes = CondensedInterface::unbounded,
                                    double top = pressure) {
  const bool is_plane = of.analysis != Analysis::axisymmetric;
  const double distortion = !is_plane && of.type == CellType::quad8 ? 0 : 0.2;
  const auto mesh = [&](std::array<int, 2> divisions, double bottom) {
    return section_mesh(of.type, divisions, {width, height}, {inner, bottom}, {of.analysis, thickness}, distortion);
  };
  const mesh::Mesh low = mesh({3, 2}, -height), high = mesh({4, 2}, 0);
  std::vector<mechanics::Support> low_held{held(low, "y0", Vector3::UnitY())}, high_held;
  if (is_plane) {
    low_held.push_back(held(low, "x0", Vector3::UnitX()));
    high_held.push_back(held(high, "x0", Vector3::UnitX()));
  }
  if (of.analysis == Analysis::generalized_plane_strain)  // as if both had the same axial strain, that of plane strain
    for (auto* all : {&low_held, &high_held})
      all->push_back({.on = "axial",
                      .nodes = {(all == &low_held ? low : high).axial_node},
                      .directions = {Vector3::UnitZ()},
                      .value = poisson_ratio * pressure / 200});
  Bodies bodies;
  bodies.emplace_back("lower", low, elastic_material(200, poisson_ratio), low_held, std::nullopt);
  bodies.emplace_back("upper", high, elastic_material(200, poisson_ratio), high_held, std::nullopt);
  bodies[1].add_load(mechanics::pressure_load(high, mesh::boundary_faces(high, "y1"), top));
  const contact::Surface below = surface(bodies[0], "y1"), above = surface(bodies[1], "y0");
  contact::Pair pair;
  pair.name = "joint";
  pair.slave_body = of.lower_is_slave ? 0 : 1;
  pair.master_body = 1 - pair.slave_body;
  pair.coupling = of.lower_is_slave ? contact::mortar_coupling(below, above, of.contact)
                                    : contact::mortar_coupling(above, below, of.contact);
  return std::make_unique<Condensed>(std::move(bodies), std::vector<contact::Pair>{std::move(pair)}, dense_bytes);
}

double contact_area(Analysis analysis) {
  return analysis == Analysis::axisymmetric ? std::numbers::pi * width * (2 * inner + width) : width * thickness;
}

void expect_uniform(const ContactEquilibrium& found, Analysis analysis, double tolerance) {
  const double zz = analysis == Analysis::plane_strain ? -poisson_ratio * pressure : 0;
  for (const std::vector<double>& stress : found.stress)
    for (const Tensor6& at : as_tensors(stress)) {
      Tensor6 expected = Tensor6::Zero();
      expected[1] = -pressure;
      expected[2] = zz;
      ASSERT_LT((at - expected).norm(), tolerance * pressure);
    }
}

class SectionPatch : public testing::TestWithParam<Section> {};

TEST_P(SectionPatch, NonMatchingEdgesTransmitUniformPressure) {
  const auto model = sections(GetParam());
  const contact::MortarCoupling& coupling = model->pairs[0].coupling;
  const double whole = contact_area(GetParam().analysis);
  double area = 0;
  for (const double one : coupling.area) area += one;
  EXPECT_NEAR(area, whole, 1e-12 * whole);
  const auto found = model->solve(*contact::active_set_solver(model->interface.problem()));
  expect_uniform(found, GetParam().analysis, 1e-10);
  const bool tied = GetParam().contact == ContactType::tied;
  for (Index i = 0; i < coupling.n_rows(); ++i)
    if (!tied || i % 3 == 1) {
      EXPECT_NEAR(std::abs(found.result.state.multiplier[i]), pressure, 1e-10 * pressure);
    }
}

TEST_P(SectionPatch, WithoutDenseMatrices) {
  const auto model = sections(GetParam(), 0.0);
  ASSERT_FALSE(model->interface.is_dense());
  expect_uniform(model->solve(*contact::active_set_solver(model->interface.problem())), GetParam().analysis, 1e-8);
}

std::vector<Section> patches() {
  std::vector<Section> all;
  for (const CellType type : {CellType::tri3, CellType::tri6, CellType::quad4, CellType::quad8, CellType::quad9})
    for (const Analysis analysis :
         {Analysis::plane_strain, Analysis::axisymmetric, Analysis::plane_stress, Analysis::generalized_plane_strain})
      for (const bool lower : {true, false}) all.push_back({type, analysis, lower});
  for (const Analysis analysis : {Analysis::plane_strain, Analysis::axisymmetric})
    all.push_back({CellType::quad8, analysis, true, ContactType::tied});
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, SectionPatch, testing::ValuesIn(patches()), [](const auto& of) {
  return fmt::format("{}_{}_{}{}", mesh::name(of.param.type), settings::name_of(of.param.analysis),
                     of.param.lower_is_slave ? "lower" : "upper", of.param.contact == ContactType::tied ? "_tied" : "");
});

TEST(SectionContact, EverySolverAndAcceleration) {
  for (const Analysis analysis : {Analysis::plane_strain, Analysis::axisymmetric})
    for (const Acceleration acceleration : accelerations) {
      const auto model = sections({CellType::quad8, analysis});
      contact::SchwarzOptions options = accelerated(acceleration);
      options.max_iterations = 10000;
      expect_uniform(model->solve(*contact::schwarz_solver(model->interface.problem(), options)), analysis, 1e-6);
    }
}

/// Forces on curved edges of both bodies, for any multipliers: equal and opposite, without a moment in the plane.
TEST(SectionContact, ForcesOnCurvedEdgesBalance) {
  for (const CellType type : {CellType::tri3, CellType::tri6, CellType::quad4, CellType::quad8, CellType::quad9}) {
    const auto ring = [&](double from, int around) {
      mesh::Mesh mesh =
          section_mesh(type, {2, around}, {1, std::numbers::pi / 2}, {from, 0}, {Analysis::plane_strain, thickness});
      for (Vector3& x : mesh.nodes) x = Vector3(x.x() * std::cos(x.y()), x.x() * std::sin(x.y()), 0);
      return mesh;
    };
    const auto body = [&](const mesh::Mesh& mesh) {
      return mechanics::Body("ring", mesh, elastic_material(),
                             {held(mesh, "y0", Vector3::UnitY()), held(mesh, "y1", Vector3::UnitX())}, std::nullopt);
    };
    const mechanics::Body shaft = body(ring(1, 7)), hub = body(ring(2, 10));
    const contact::MortarCoupling coupling =
        contact::mortar_coupling(surface(shaft, "x1"), surface(hub, "x0"), ContactType::unilateral);
    EXPECT_LT(coupling.geometric_gap.cwiseAbs().maxCoeff(), 1e-3 * thickness) << "of smooth surfaces";
    for (const contact::MultiplierNode& at : coupling.nodes) {
      EXPECT_NEAR(at.normal.dot(shaft.mesh().nodes[at.node]), 2, 1e-3) << mesh::name(type);
      EXPECT_EQ(at.normal.z(), 0);
    }
    const Eigen::VectorXd multiplier = Eigen::VectorXd::LinSpaced(coupling.n_rows(), 1.0, 2.0);
    Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
    double absolute = 0;
    for (const bool on_slave : {true, false}) {
      const Eigen::VectorXd forces = (on_slave ? coupling.slave_rows : coupling.master_rows).transpose() * multiplier;
      const std::vector<Vector3>& nodes = (on_slave ? shaft : hub).mesh().nodes;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Vector3 one = forces.segment<3>(3 * static_cast<Index>(i));
        force += one;
        moment += nodes[i].cross(one);
        absolute += one.norm();
      }
    }
    EXPECT_LT(force.norm(), 1e-13 * absolute);
    EXPECT_LT(moment.norm(), 1e-3 * absolute) << mesh::name(type);
  }
}

}  // namespace
}  // namespace section_contact_tests
}  // namespace creepcontact::test
