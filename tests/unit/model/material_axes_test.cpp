/// The axes of materials as directions at a place.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "../../../src/model/model_parts.hpp"
#include "creepcontact/base/error.hpp"
#include "support/says.hpp"

namespace creepcontact::model {
namespace {

config::Body cylindrical_body(const std::array<double, 3>& axis, const std::array<double, 3>& origin) {
  config::Body body;
  body.material_axes.emplace();
  body.material_axes->cylindrical = config::CylindricalAxes{axis, origin};
  return body;
}

TEST(CylindricalAxes, AreRadialCircumferentialAndAxial) {
  const auto axes = material_axes(cylindrical_body({2, -1, 3}, {10, 20, -5}));
  const Vector3 axis = Vector3(2, -1, 3).normalized(), origin(10, 20, -5),
                radial = axis.cross(Vector3(1, 2, -1)).normalized();
  const Matrix3 found = axes->at(origin + 7 * radial - 30 * axis);
  EXPECT_LT((found.col(0) - radial).norm(), 1e-14);
  EXPECT_LT((found.col(1) - axis.cross(radial)).norm(), 1e-14);
  EXPECT_LT((found.col(2) - axis).norm(), 1e-14);
}

TEST(CylindricalAxes, DoNotExistOnTheAxis) {
  const auto axes = material_axes(cylindrical_body({0, 0, 1}, {1, 2, 0}));
  const std::string message = test::message_of<ModelError>([&] { axes->at({1, 2, 5}); });
  EXPECT_TRUE(test::says(message, {"material_axes: at (1, 2, 5)", "axis 1", "length", "axis itself"}));
}

}  // namespace
}  // namespace creepcontact::model
