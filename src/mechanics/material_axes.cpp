#include "creepcontact/mechanics/material_axes.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"

namespace creepcontact::mechanics {
namespace {

constexpr double min_sine = 1e-6;  // of the angle between two directions that are not parallel
constexpr double out_of_plane = 1e-6;

Vector3 direction_at(const std::array<Function, 3>& of, const Vector3& x) {
  const Arguments here{.x = x.x(), .y = x.y(), .z = x.z()};
  return {of[0](here), of[1](here), of[2](here)};
}

bool is_constant(const std::array<Function, 3>& of) {
  return std::ranges::all_of(of, [](const Function& component) { return component.is_constant(); });
}

}  // namespace

Matrix3 MaterialAxes::at(const Vector3& place) const {
  const Vector3 a = direction_at(first, place), b = direction_at(second, place);
  const Vector3 normal = a.cross(b);
  const auto refuse = [&](const std::string& why) {
    throw ModelError(
        fmt::format("material_axes: at ({:.6g}, {:.6g}, {:.6g}) {}", place.x(), place.y(), place.z(), why));
  };
  const auto text = [](const Vector3& v) { return fmt::format("({:g}, {:g}, {:g})", v.x(), v.y(), v.z()); };
  if (!a.allFinite() || !b.allFinite())
    refuse(fmt::format("the directions first = {} and second = {} are not finite; correct their expressions", text(a),
                       text(b)));
  if (!(a.norm() > 0) || !(b.norm() > 0)) {
    const auto& missing = a.norm() > 0 ? second : first;
    refuse(fmt::format("the direction {} has no length; {}", a.norm() > 0 ? "of axis 2" : "of axis 1",
                       is_constant(missing) ? "give one that is not zero"
                                            : "if it is radial or circumferential: there is none on the axis itself. "
                                              "Give the elements there a body and a material of their own"));
  }
  if (!(normal.norm() > min_sine * a.norm() * b.norm()))
    refuse(
        fmt::format("the directions first = {} and second = {} are parallel; they must be two different directions "
                    "throughout the body",
                    text(a), text(b)));
  Matrix3 axes;
  axes.col(0) = a.normalized();
  axes.col(2) = normal.normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

std::vector<Matrix3> MaterialAxes::at_points(std::span<const Vector3> places, const mesh::Section& section) const {
  const std::size_t n = is_constant(first) && is_constant(second) ? 1 : places.size();
  std::vector<Matrix3> result;
  result.reserve(n);
  for (std::size_t p = 0; p < n; ++p) {
    const Vector3 place = places.empty() ? Vector3(Vector3::Zero()) : places[p];
    result.push_back(at(place));
    if (section.dimension() == 3) continue;
    if (result.back().row(2).cwiseAbs().maxCoeff() < 1 - out_of_plane)
      throw ModelError(
          fmt::format("material_axes: at ({:.6g}, {:.6g}) no axis is at right angles to the section; shear out of its "
                      "plane needs a solid model",
                      place.x(), place.y()));
  }
  return result;
}

}  // namespace creepcontact::mechanics
