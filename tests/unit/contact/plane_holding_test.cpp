/// Planes of symmetry that cut contacts: parts of a model against the whole, where the meshes of the bodies differ.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <tuple>

#include "support/contact/boxes.hpp"

namespace creepcontact::test {
namespace {

using contact::ContactType;

/// Blocks of a whole model that is symmetric about x = 0 and y = 0, or the half beyond y = 0, or the quarter beyond
/// both.
enum class Part { whole, half, quarter };

struct Cut {
  CellType type = CellType::hex8;
  ContactType contact = ContactType::unilateral;
  double moved = 0;   ///< the top along x; not with a quarter
  double turned = 0;  ///< the model about z
};

class CutModel {
 public:
  CutModel(const Cut& cut, Part part) : turn_(Eigen::AngleAxisd(cut.turned, Vector3::UnitZ()).toRotationMatrix()) {
    std::vector<mechanics::Body> made = bodies(cut, part);
    std::vector<contact::Pair> pairs(1);
    contact::Pair& pair = pairs.front();
    pair.name = "joint";
    pair.slave_body = 1;
    pair.master_body = 0;
    const contact::Surface slave = Boxes::surface(made[1], "z0"), master = Boxes::surface(made[0], "z1");
    const bool tied = cut.contact == ContactType::tied;
    pair.coupling =
        tied ? contact::tied_coupling(slave, master) : contact::mortar_coupling(slave, master, cut.contact, {}, true);
    if (!tied) {
      std::vector<Vector3> positions;
      for (const auto& node : pair.coupling.nodes)
        positions.push_back(made[1].mesh().nodes[static_cast<std::size_t>(node.node)]);
      pair.friction = {0.3, std::nullopt, std::move(positions)};
    }
    joined_ = std::make_unique<Condensed>(std::move(made), std::move(pairs));
    state_ = joined_->solve(*contact::friction_solver(joined_->interface.problem(), {.schwarz = {.tolerance = 1e-12}}));
  }

  const contact::MortarCoupling& coupling() const { return joined_->pairs[0].coupling; }

  /// Pressure, traction and relative displacement by position in the whole model, turned back.
  struct Values {
    double pressure = 0;
    Vector3 traction = Vector3::Zero(), displacement = Vector3::Zero();
  };
  using Place = std::tuple<long, long>;
  std::map<Place, Values> values() const {
    std::map<Place, Values> result;
    const mesh::Mesh& mesh = joined_->bodies[1].mesh();
    for (std::size_t i = 0; i < coupling().nodes.size(); ++i) {
      const auto node = static_cast<std::size_t>(coupling().nodes[i].node);
      const Vector3 x = turn_.transpose() * mesh.nodes[node];
      const auto& multiplier = state_.result.state.multiplier;
      Values& here = result[{std::lround(1e6 * x.x()), std::lround(1e6 * x.y())}];
      here.pressure = coupling().pressure(i, multiplier);
      here.traction = turn_.transpose() * coupling().shear(i, multiplier);
      here.displacement = turn_.transpose() * Vector3(Vector3::Map(state_.displacement[1].data() + 3 * node));
    }
    return result;
  }

 private:
  std::vector<mechanics::Body> bodies(const Cut& cut, Part part) const {
    const int nx = part == Part::quarter ? 1 : 2, ny = part == Part::whole ? 2 : 1;
    const double x0 = part == Part::quarter ? 0 : 1, y0 = part == Part::whole ? 1 : 0;
    const auto box = [&](std::array<int, 3> divisions, const Vector3& half, double z0) {
      return mapped(box_mesh(cut.type, {nx * divisions[0], ny * divisions[1], divisions[2]},
                             {nx * half.x(), ny * half.y(), half.z()}, {-x0 * half.x(), -y0 * half.y(), z0}),
                    [&](const Vector3& x) { return Vector3(turn_ * x); });
    };
    const mesh::Mesh low = box({3, 2, 1}, {1.5, 1.25, 1}, -1), up = box({2, 3, 1}, {1, 0.8, 0.7}, 0);
    const auto along = [&](const Vector3& direction) { return Vector3(turn_ * direction); };
    const Vector3 x = along(Vector3::UnitX()), y = along(Vector3::UnitY()), z = Vector3::UnitZ();
    std::vector<mechanics::Support> of_low{support(low, "z0", x), support(low, "z0", y), support(low, "z0", z)},
        of_up{support(up, "z1", z, cut.contact == ContactType::tied ? 0.01 : -0.01), support(up, "z1", y),
              support(up, "z1", x, cut.moved)};
    if (part != Part::whole) {
      of_low.push_back(support(low, "y0", y));
      of_up.push_back(support(up, "y0", y));
    }
    if (part == Part::quarter) {
      of_low.push_back(support(low, "x0", x));
      of_up.push_back(support(up, "x0", x));
    }
    std::vector<mechanics::Body> result;
    result.emplace_back("low", low, elastic_material(200), std::move(of_low), std::nullopt);
    result.emplace_back("up", up, elastic_material(60), std::move(of_up), std::nullopt);
    return result;
  }

  Matrix3 turn_;
  std::unique_ptr<Condensed> joined_;
  ContactEquilibrium state_;
};

void expect_part_of(const CutModel& whole, const CutModel& part, double tolerance) {
  const auto expected = whole.values(), found = part.values();
  double largest = 0, moved = 0;
  for (const auto& [place, values] : expected) {
    largest = std::max(largest, std::abs(values.pressure));
    moved = std::max(moved, values.displacement.norm());
  }
  ASSERT_GT(largest, 0);
  for (const auto& [place, values] : found) {
    ASSERT_TRUE(expected.contains(place));
    const CutModel::Values& other = expected.at(place);
    EXPECT_NEAR(values.pressure, other.pressure, tolerance * largest);
    EXPECT_LT((values.traction - other.traction).norm(), tolerance * largest);
    EXPECT_LT((values.displacement - other.displacement).norm(), tolerance * moved);
  }
}

class PartsOfAModel : public testing::TestWithParam<Cut> {};

TEST_P(PartsOfAModel, AreAsTheWhole) {
  const CutModel whole(GetParam(), Part::whole);
  expect_part_of(whole, CutModel(GetParam(), Part::half), 1e-9);
  Cut turned = GetParam();
  turned.turned = 0.4;
  expect_part_of(whole, CutModel(turned, Part::half), 1e-9);
  if (GetParam().moved != 0) return;
  expect_part_of(whole, CutModel(GetParam(), Part::quarter), 1e-9);
  expect_part_of(whole, CutModel(turned, Part::quarter), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Cases, PartsOfAModel,
                         testing::Values(Cut{}, Cut{.moved = 0.004}, Cut{.type = CellType::hex20, .moved = 0.004},
                                         Cut{.contact = ContactType::tied},
                                         Cut{.contact = ContactType::tied, .moved = 0.004},
                                         Cut{.type = CellType::hex20, .contact = ContactType::tied, .moved = 0.004}),
                         [](const auto& of) {
                           return std::string(mesh::name(of.param.type)) +
                                  (of.param.contact == ContactType::tied ? "_tied" : "_friction") +
                                  (of.param.moved != 0 ? "_sheared" : "");
                         });

/// Empty rows of a pair of boxes with friction.
int empty_rows(const mechanics::Body& slave, const mechanics::Body& master) {
  const auto coupling = contact::mortar_coupling(Boxes::surface(slave, "z0"), Boxes::surface(master, "z1"),
                                                 ContactType::unilateral, {}, true);
  int n = 0;
  for (Index row = 0; row < coupling.n_rows(); ++row)
    n += coupling.slave_rows.row(row).norm() == 0 && coupling.master_rows.row(row).norm() == 0 ? 1 : 0;
  return n;
}

/// @param y0  where it begins @param held  supports along y at its face there, with these values
mechanics::Body box_with(const std::string& name, double y0, double z0, const std::vector<Function>& held) {
  mesh::Mesh mesh = box_mesh(CellType::hex8, {2, name == "low" ? 3 : 2, 1}, {1, 1 - y0, 1}, {0, y0, z0});
  std::vector<mechanics::Support> supports{support(mesh, name == "low" ? "z0" : "z1", Vector3::UnitZ())};
  for (const Function& value : held) supports.push_back(support(mesh, "y0", Vector3::UnitY(), value));
  return {name, std::move(mesh), elastic_material(), std::move(supports), std::nullopt};
}

// Without a support of the other body, with one that moves it elsewhere, or with a plane inside it, friction acts.
TEST(PlaneHolding, TakesBothBodiesAndTheSamePlane) {
  const Function zero = 0.0, one = Function::expression("0.1*t", {"t"}), other = Function::expression("0.2*t", {"t"});
  const auto up = [&](const std::vector<Function>& held) { return box_with("up", 0, 0, held); };
  const auto low = [&](const std::vector<Function>& held, double y0 = 0) { return box_with("low", y0, -1, held); };
  EXPECT_EQ(empty_rows(up({zero}), low({zero})), 3);
  EXPECT_EQ(empty_rows(up({one}), low({one})), 3);
  EXPECT_EQ(empty_rows(up({}), low({})), 0);
  EXPECT_EQ(empty_rows(up({zero}), low({})), 0);
  EXPECT_EQ(empty_rows(up({}), low({zero})), 0);
  EXPECT_EQ(empty_rows(up({one}), low({zero})), 0);
  EXPECT_EQ(empty_rows(up({one}), low({other})), 0);
  EXPECT_EQ(empty_rows(up({zero}), low({zero}, -0.5)), 0);
}

}  // namespace
}  // namespace creepcontact::test
