#include "initial_stress.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "creepcontact/base/log.hpp"
#include "creepcontact/io/temperatures/stress_reader.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {
namespace {

Arguments at(const Vector3& x) {
  return {.x = x.x(), .y = x.y(), .z = x.z()};
}

Tensor6 along_coordinates(const std::array<Function, 6>& components, const Vector3& place) {
  Tensor6 stress;
  for (std::size_t i = 0; i < 6; ++i)
    stress[static_cast<Index>(i)] = components[i](at(place)) * (i < 3 ? 1 : tensor::sqrt2);
  return stress;
}

/// On the axis itself, where radial and tangential stress are the same, any direction is radial.
Tensor6 about_axis(const config::InitialStress& given, const Vector3& place) {
  const Vector3 axis = vector(given.axis).normalized();
  const Vector3 from_axis = (place - vector(given.origin)) - axis * axis.dot(place - vector(given.origin));
  Matrix3 directions;
  directions.col(0) = axis.unitOrthogonal();
  if (from_axis.norm() > 0) directions.col(0) = from_axis.normalized();
  directions.col(2) = axis;
  directions.col(1) = axis.cross(Vector3(directions.col(0)));
  const Vector3 normal(given.about_axis[0](at(place)), given.about_axis[1](at(place)), given.about_axis[2](at(place)));
  return tensor::from_matrix(directions * normal.asDiagonal() * directions.transpose());
}

void warn_of_nodes_outside(const mechanics::ScatteredStress& field, const mesh::Mesh& mesh, const std::string& body,
                           const std::string& file) {
  const std::span<const Vector3> nodes(mesh.nodes.data(), mesh.n_cell_nodes());
  std::size_t n_outside = 0;
  double farthest = 0;
  for (const Vector3& node : nodes) {
    const double distance = field.outside(node);
    if (distance == 0) continue;
    ++n_outside;
    farthest = std::max(farthest, distance);
  }
  if (n_outside > 0)
    log::warning(
        "initial_stress.{}: {} of {} nodes lie far outside the points of '{}', by up to {:.4g}; the stress of the "
        "nearest point is used there. Are units and axes the same?",
        body, n_outside, nodes.size(), file, farthest);
}

mechanics::StressField of_file(const config::InitialStress& given, const mesh::Mesh& mesh) {
  const std::string file = given.file->string();
  io::PointStresses read = io::read_stresses(*given.file, mesh.section.dimension());
  mechanics::ScatteredStress field(read.points, std::move(read.stresses));
  warn_of_nodes_outside(field, mesh, given.name, file);
  return field;
}

}  // namespace

mechanics::StressField initial_stress(const config::InitialStress& given, const mesh::Mesh& mesh) {
  if (given.file) return of_file(given, mesh);
  if (std::ranges::all_of(given.about_axis, &Function::is_zero))
    return
        [components = given.along_coordinates](const Vector3& place) { return along_coordinates(components, place); };
  return [given](const Vector3& place) { return about_axis(given, place); };
}

}  // namespace creepcontact::model
