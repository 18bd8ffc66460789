#include "creepcontact/model/temperature.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <span>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/io/temperatures/temperature_reader.hpp"
#include "creepcontact/mesh/cell_faces.hpp"
#include "creepcontact/mesh/point_tree.hpp"

namespace creepcontact::model {

namespace {

using Coordinates = io::PointTemperatures::Coordinates;

/// Points of a solid, or with y and z exchanged, would give temperatures of other places without a word.
void require_plane(const std::vector<Vector3>& points, const std::string& file, const std::string& why) {
  constexpr double small = 1e-6;  // of the largest coordinate
  double largest = 0;
  for (const Vector3& x : points) largest = std::max(largest, x.cwiseAbs().maxCoeff());
  for (const Vector3& x : points)
    if (std::abs(x.z()) > small * largest)
      throw ModelError(fmt::format(
          "temperature: '{}' has a point ({:.6g}, {:.6g}, {:.6g}), but {}; give the points of the section, with z = 0",
          file, x[0], x[1], x[2], why));
}

/// The axis of a solid's temperatures if they are those of a section, whose x is then the radius.
std::optional<mechanics::RevolutionAxis> revolution(const config::Temperature& temperature,
                                                    const io::PointTemperatures& read, const std::string& file) {
  if (!temperature.axis && read.coordinates == Coordinates::xyz) return std::nullopt;
  if (!temperature.axis && read.coordinates == Coordinates::xy)
    throw ModelError(fmt::format(
        "temperature: '{}' has columns of x and y, but none of z; name it by columns = {{ z = \"...\" }}. If x is the "
        "radius and y the position along the axis of a round part, give 'axis'",
        file));
  require_plane(read.points, file, "the section that is revolved about 'axis' lies in the plane z = 0");
  for (const Vector3& x : read.points)
    if (x[0] < 0)
      throw ModelError(
          fmt::format("temperature: '{}' has a point with the radius {:.6g}; a radius is at least 0", file, x[0]));
  mechanics::RevolutionAxis axis;
  axis.origin = Vector3(temperature.origin.data());
  if (temperature.axis) axis.direction = Vector3(temperature.axis->data()).normalized();
  return axis;
}

/// The distance within which a point is a node, if that is to be looked at: a ten-thousandth of the size of the
/// smallest element, or what the six digits of files leave open.
std::optional<double> tolerance_of_nodes(const std::vector<Vector3>& points, const mesh::Mesh& mesh,
                                         const std::string& file) {
  constexpr double of_edge = 1e-4, of_digits = 1e-5, most_of_edge = 0.05;
  constexpr double finer = 8;  // points per node: more than a mesh of second order has
  double shortest = std::numeric_limits<double>::infinity(), largest = 0;
  Eigen::AlignedBox3d box;
  std::vector<char> is_corner(mesh.nodes.size(), 0);
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type)) continue;
    for (std::size_t c = 0; c < block.size(); ++c) {
      const auto cell = block.cell(c);
      for (const auto& [a, b] : mesh::cell_edges(block.type))
        if (const double length = (mesh.nodes[cell[a]] - mesh.nodes[cell[b]]).norm(); length > 0)
          shortest = std::min(shortest, length);
      for (int i = 0; i < mesh::n_corners(block.type); ++i) is_corner[cell[i]] = 1;
      for (const std::int64_t node : cell) box.extend(mesh.nodes[node]);
    }
  }
  if (box.isEmpty()) return std::nullopt;
  largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const double tolerance = std::max(of_edge * shortest, std::min(of_digits * largest, most_of_edge * shortest));
  const mesh::PointTree tree(points);
  std::vector<char> is_node(points.size(), 0);
  std::size_t n_given = 0;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const std::vector<mesh::Neighbour> nearest = tree.nearest(mesh.nodes[i], 1);
    if (nearest.empty() || nearest[0].distance > tolerance) continue;
    is_node[nearest[0].point] = 1;
    n_given += static_cast<std::size_t>(is_corner[i]);
  }
  if (n_given == 0) return std::nullopt;
  std::size_t n_others = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (is_node[p] == 0 && box.exteriorDistance(points[p]) <= tolerance) ++n_others;
  if (static_cast<double>(n_others) > finer * static_cast<double>(n_given)) return std::nullopt;
  const auto n_corners = static_cast<std::size_t>(std::ranges::count(is_corner, 1));
  if (n_others > 0 && 2 * n_given > n_corners)
    log::info("temperature: {} points of '{}' are not nodes of the mesh; where nodes have values, they are left out",
              n_others, file);
  return tolerance;
}

std::string named(const std::vector<std::filesystem::path>& files) {
  return files.size() == 1 ? files[0].string()
                           : fmt::format("{} ... {}", files.front().string(), files.back().string());
}

}  // namespace

mechanics::TemperatureField temperature_field(const config::Temperature& temperature, const mesh::Mesh& mesh) {
  const mesh::Section& section = mesh.section;
  if (temperature.files.empty()) return temperature.value;
  io::PointTemperatures read =
      io::read_temperatures({temperature.files, temperature.times, temperature.columns,
                             io::thousands_named(temperature.thousands).value_or(io::Thousands::none)});
  const std::string file = named(temperature.files);
  mechanics::ScatteredTemperatures field;
  if (section.dimension() == 2) {
    if (read.coordinates == Coordinates::rz && !section.is_axisymmetric())
      throw ModelError(
          fmt::format("temperature: '{}' has columns r and z, but the section is not axisymmetric; it "
                      "needs x and y",
                      file));
    require_plane(read.points, file, "the section lies in the plane z = 0");
  } else {
    field.axis = revolution(temperature, read, file);
  }
  if (temperature.period)
    if (const std::string mistake = Function::period_error("t", read.times, *temperature.period); !mistake.empty())
      throw ModelError(fmt::format("temperature: '{}' with period = {}: {}", file, *temperature.period, mistake));
  field.points = std::move(read.points);
  field.times = std::move(read.times);
  field.values = std::move(read.values);
  field.period = temperature.period;
  if (!field.axis) field.node_tolerance = tolerance_of_nodes(field.points, mesh, file);
  mechanics::TemperatureField result(std::move(field));
  const bool is_scaled = temperature.scale.depends_on_time() || temperature.scale({}) != 1;
  return is_scaled ? result.scaled(temperature.scale, temperature.scale_about) : result;
}

void tell_interpolation(const config::Config& config, const std::vector<mechanics::Body>& bodies,
                        const mechanics::TemperatureField& temperature) {
  if (!config.temperature || config.temperature->files.empty()) return;
  const std::string file = named(config.temperature->files);
  for (const mechanics::Body& body : bodies) {
    const mechanics::NodeCover cover = temperature.cover(body.mesh());
    if (cover.is_nodal && cover.mid_sides_given == cover.mid_sides)
      log::info("temperature: '{}' has values at all nodes of '{}'; its elements interpolate between them", file,
                body.name());
    else if (cover.is_nodal)
      log::info(
          "temperature: '{}' has values at all corner nodes of '{}' and at {} of {} mid-side nodes; its elements "
          "interpolate between them, linearly along edges without a value",
          file, body.name(), cover.mid_sides_given, cover.mid_sides);
    else if (2 * cover.corners_given > cover.corners)
      log::warning(
          "temperature: '{}' has values at {} of {} corner nodes of '{}', not at all of them; so it is interpolated "
          "there as from scattered points, less accurately. Give values at all nodes",
          file, cover.corners_given, cover.corners, body.name());
  }
}

void warn_of_positions_outside(const config::Config& config, const std::vector<mechanics::Body>& bodies,
                               const mechanics::TemperatureField& temperature) {
  std::size_t n_nodes = 0, n_outside = 0;
  mechanics::PlaceOutside farthest;
  Vector3 place = Vector3::Zero();
  Eigen::AlignedBox3d box;
  std::string by_body;
  for (const mechanics::Body& body : bodies) {
    const std::span<const Vector3> nodes(body.mesh().nodes.data(), body.mesh().n_cell_nodes());
    std::size_t n = 0;
    for (const Vector3& x : nodes) {
      box.extend(x);
      const mechanics::PlaceOutside outside = temperature.outside(x);
      if (outside.distance == 0) continue;
      ++n;
      if (outside.distance <= farthest.distance) continue;
      farthest = outside;
      place = x;
    }
    if (n > 0) by_body += fmt::format("{}{} of {} in '{}'", n_outside > 0 ? ", " : "", n, nodes.size(), body.name());
    n_nodes += nodes.size();
    n_outside += n;
  }
  if (n_outside == 0) return;
  log::warning(
      "temperature: '{}' does not cover the whole model: {} of {} nodes lie far outside its points ({}); the worst "
      "place "
      "is ({:.6g}, {:.6g}, {:.6g}), {:.4g} (that is {:.2g} of the size of the model) from the nearest point, ({:.6g}, "
      "{:.6g}, {:.6g}); the value of the nearest point is used there. Are units and axes the same?",
      named(config.temperature->files), n_outside, n_nodes, by_body, place[0], place[1], place[2], farthest.distance,
      farthest.distance / box.diagonal().norm(), farthest.nearest[0], farthest.nearest[1], farthest.nearest[2]);
}

std::optional<Interval> temperature_range(const config::Config& config, const Model& model) {
  if (!model.temperature) return std::nullopt;
  std::vector<double> times = config.time.output;
  times.insert(times.end(), model.breakpoints.begin(), model.breakpoints.end());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Interval range{infinity, -infinity};
  for (const mechanics::Body& body : model.bodies())
    for (const double t : times) {
      const std::vector<double> values = body.at(t).temperature;
      const auto [low, high] = std::ranges::minmax_element(values);
      range = {std::min(range.low, *low), std::max(range.high, *high)};
      if (!model.temperature->depends_on_time()) break;
    }
  return range;
}

}  // namespace creepcontact::model
