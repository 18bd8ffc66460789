#include "plane_mesh.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "creepcontact/base/error.hpp"

namespace creepcontact::io {
namespace {

constexpr double rounding = 1e-9;  // of the size of the mesh

std::string text(const Vector3& x) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
}

/// Area of the polygon of the corners; positive if they are counter-clockwise.
double signed_area(const mesh::Mesh& mesh, std::span<const std::int64_t> cell, std::size_t n_corners) {
  double twice = 0;
  for (std::size_t i = 0; i < n_corners; ++i) {
    const Vector3 &a = mesh.nodes[cell[i]], &b = mesh.nodes[cell[(i + 1) % n_corners]];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return twice / 2;
}

/// The other way round from the same first corner: the remaining corners, and the nodes on the edges, in reverse.
void turn(std::span<std::int64_t> cell, std::size_t n_corners) {
  std::ranges::reverse(cell.subspan(1, n_corners - 1));
  if (cell.size() >= 2 * n_corners) std::ranges::reverse(cell.subspan(n_corners, n_corners));
}

}  // namespace

void check_plane_mesh(mesh::Mesh& mesh, const std::string& file) {
  Eigen::AlignedBox3d box;
  for (const Vector3& x : mesh.nodes) box.extend(x);
  const double size = box.diagonal().norm(), small = rounding * size;
  if (size > 0) mesh.section.axial_length = size;
  const std::string_view analysis = settings::name_of(mesh.section.analysis);
  for (Vector3& x : mesh.nodes) {
    if (std::abs(x.z()) > small)
      throw ModelError(
          fmt::format("{}: the node {} is not in the plane z = 0, where the section of an analysis = \"{}\" lies; draw "
                      "the section in the xy-plane, or leave 'analysis' out for a solid",
                      file, text(x), analysis));
    if (mesh.section.is_axisymmetric() && x.x() < -small)
      throw ModelError(fmt::format(
          "{}: the node {} has a negative radius: in an axisymmetric model x is the radius and y the axis, so "
          "the section lies at x >= 0; move it, or cut it at the axis",
          file, text(x)));
    x.z() = 0;
  }
  for (mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type)) continue;
    const std::size_t n = mesh::n_nodes(block.type), n_corners = mesh::n_corners(block.type);
    for (std::size_t c = 0; c < block.size(); ++c)
      if (signed_area(mesh, block.cell(c), n_corners) < 0)
        turn(std::span(block.connectivity).subspan(c * n, n), n_corners);
  }
}

}  // namespace creepcontact::io
