#include "heat_remarks.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "creepcontact/base/log.hpp"

namespace creepcontact::model {
namespace {

constexpr double hardly_heated = 10;   // times of the run to heat through
constexpr double coarse_biot = 1;      // element Biot number
constexpr double noticed_jump = 0.05;  // of the range of temperatures
constexpr int samples = 200;           // of the run

/// Half of the smallest extent of a body; in sections within their plane.
double depth_of(const mesh::Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < mesh.n_cell_nodes(); ++i) box.extend(mesh.nodes[i]);
  const Vector3 sizes = box.sizes();
  return (mesh.section.dimension() == 2 ? std::min(sizes.x(), sizes.y()) : sizes.minCoeff()) / 2;
}

double size_of(const mesh::Mesh& mesh, const mesh::Face& face) {
  return (mesh.nodes[static_cast<std::size_t>(face.nodes[1])] - mesh.nodes[static_cast<std::size_t>(face.nodes[0])])
      .norm();
}

}  // namespace

void tell_of_heat(const config::Heat& heat, const heat::Conduction& problem, std::span<const double> start,
                  double end) {
  const heat::Definition& all = problem.definition();
  for (std::size_t b = 0; b < all.bodies.size(); ++b) {
    const heat::Conductor& body = all.bodies[b];
    const Arguments at{.T = problem.at_nodes(b, start).front()};
    const double depth = depth_of(*body.mesh);
    const double time =
        depth * depth * body.density * body.capacity(at) / body.conductivity.front()(at) / all.time_unit;
    log::info(
        "heat: body '{}' heats through in about {:.3g} units of t (half of its smallest extent, squared, over "
        "the diffusivity)",
        body.name, time);
    if (time > hardly_heated * end)
      log::warning(
          "heat: body '{}' takes about {:.3g} units of t to heat through, and the run lasts {:.3g}: is heat.time_unit "
          "= "
          "{:g} the unit of t in the unit of time of the heat data?",
          body.name, time, end, all.time_unit);
  }
  const auto [low, high] = std::ranges::minmax(start);
  for (std::size_t i = 0; i < all.flows.size(); ++i) {
    const heat::SurfaceFlow& flow = all.flows[i];
    if (flow.kind != heat::SurfaceFlow::Kind::film || flow.faces.empty()) continue;
    const heat::Conductor& body = all.bodies[flow.body];
    const mesh::Face& face = flow.faces.front();
    const Vector3& x = body.mesh->nodes[static_cast<std::size_t>(face.nodes.front())];
    Arguments at{.x = x[0], .y = x[1], .z = x[2], .T = start.front()};
    const auto fluid = [&](double t) {
      at.t = t;
      return flow.beyond(at);
    };
    double largest = 0, range = high - low, jump = std::abs(fluid(0) - start.front());
    for (int k = 0; k <= samples; ++k) {
      at.t = end * k / samples;
      largest = std::max(largest, flow.factor(at));
      range = std::max(range, std::abs(flow.beyond(at) - start.front()));
    }
    at.t = 0;
    if (!(flow.factor(at) > 0)) jump = 0;
    for (const double t : flow.beyond.breakpoints(end))
      jump = std::max(jump, std::abs(fluid(t) - fluid(std::nextafter(t, 0))));
    const double size = size_of(*body.mesh, face);
    const double biot = largest * size / body.conductivity.front()({.T = start.front()});
    if (heat.start && biot > coarse_biot && jump > noticed_jump * range)
      log::warning(
          "heat: a film on body '{}' has the element Biot number {:.2g} (coefficient times size of the element over "
          "the conductivity), and its fluid jumps by {:.3g}: just after that, temperatures one element deep undershoot "
          "by some per cent of it; elements of {:.2g} at that surface, or a ramp of the fluid, avoid it",
          body.name, biot, jump, size / biot / 3);
  }
}

}  // namespace creepcontact::model
