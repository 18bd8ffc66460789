#include "creepcontact/heat/figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "creepcontact/mesh/outer_faces.hpp"
#include "patches.hpp"

namespace creepcontact::heat {
namespace {

constexpr int samples = 200;            // of the run
constexpr std::size_t some_faces = 50;  // at which functions of the place are looked at

double area(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces) {
  double sum = 0;
  for (const mesh::Face& face : faces) sum += size_of(mesh, face.type, face.nodes);
  return sum;
}

/// Surfaces through which heat can come, by body.
std::vector<double> exchanging_areas(const Definition& all) {
  std::vector<double> areas(all.bodies.size());
  std::vector<std::set<std::vector<std::int64_t>>> counted(all.bodies.size());  // a face may have several
  for (const SurfaceFlow& flow : all.flows)
    for (const mesh::Face& face : flow.faces) {
      std::vector<std::int64_t> key = face.nodes;
      std::ranges::sort(key);
      if (counted[flow.body].insert(key).second)
        areas[flow.body] += size_of(*all.bodies[flow.body].mesh, face.type, face.nodes);
    }
  for (const Interface& interface : all.interfaces)
    for (const contact::FacingFaces& faces : interface.faces)
      for (const contact::FacingFaces::Point& point : faces.points)
        for (const std::size_t b : {interface.first, interface.second}) areas[b] += point.area;
  for (const GivenTemperature& given : all.given) {
    const mesh::Mesh& mesh = *all.bodies[given.body].mesh;
    const std::set<std::int64_t> nodes(given.nodes.begin(), given.nodes.end());
    std::vector<mesh::Face> faces = mesh::outer_faces(mesh.blocks, mesh.section.dimension());
    std::erase_if(faces, [&](const mesh::Face& face) {
      return !std::ranges::all_of(face.nodes, [&](std::int64_t node) { return nodes.contains(node); });
    });
    areas[given.body] += area(mesh, faces);
  }
  return areas;
}

/// From the volume of a cell over the area of one of its faces to its extent there.
double slenderness(mesh::CellType cell, mesh::CellType face) {
  using enum mesh::CellType;
  const mesh::CellType linear = mesh::linear_type(cell);
  if (linear == tet4) return 3;
  if (linear == tri3) return 2;
  return linear == wedge6 && mesh::linear_type(face) == quad4 ? 2 : 1;
}

/// How far the cells at some faces reach inwards, by face.
std::vector<double> element_sizes(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces) {
  std::multimap<std::int64_t, std::size_t> faces_at;  // by their first nodes
  for (std::size_t f = 0; f < faces.size(); ++f) faces_at.emplace(faces[f].nodes.front(), f);
  std::vector<double> sizes(faces.size());
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type)) continue;
    for (std::size_t c = 0; c < block.size(); ++c) {
      const std::span<const std::int64_t> cell = block.cell(c);
      for (const std::int64_t node : cell)
        for (auto [at, end] = faces_at.equal_range(node); at != end; ++at) {
          const mesh::Face& face = faces[at->second];
          const auto is_of_cell = [&](std::int64_t one) { return std::ranges::find(cell, one) != cell.end(); };
          if (std::ranges::all_of(face.nodes, is_of_cell))
            sizes[at->second] = slenderness(block.type, face.type) * size_of(mesh, block.type, cell) /
                                size_of(mesh, face.type, face.nodes);
        }
    }
  }
  return sizes;
}

double least_conductivity(const Conductor& body, double T) {
  double least = std::numeric_limits<double>::infinity();
  for (const Function& along : body.conductivity) least = std::min(least, along({.T = T}));
  return least;
}

std::vector<HeatingThrough> heating_through(const Definition& definition, std::span<const double> start) {
  const std::vector<double> areas = exchanging_areas(definition);
  std::vector<HeatingThrough> result;
  for (std::size_t b = 0; b < areas.size(); ++b) {
    HeatingThrough& one = result.emplace_back();
    if (!(areas[b] > 0)) continue;
    const Conductor& body = definition.bodies[b];
    double volume = 0;
    for (const mesh::CellBlock& block : body.mesh->blocks)
      for (std::size_t c = 0; body.mesh->is_bulk(block.type) && c < block.size(); ++c)
        volume += size_of(*body.mesh, block.type, block.cell(c));
    one.depth = volume / areas[b];
    const double diffusivity = least_conductivity(body, start[b]) / (body.density * body.capacity({.T = start[b]}));
    one.time = one.depth * one.depth / diffusivity / definition.time_unit;
  }
  return result;
}

/// How a temperature that acts at a place jumps; the body has that of the arguments.
Jumps jumps_of(const Function& temperature, Arguments at, double end) {
  Jumps result;
  at.t = 0;
  result.first = std::abs(temperature(at) - at.T);
  for (int k = 0; k <= samples; ++k) {
    at.t = end * k / samples;
    result.range = std::max(result.range, std::abs(temperature(at) - at.T));
  }
  for (const double t : temperature.breakpoints(end)) {
    at.t = std::nextafter(t, 0);
    const double before = temperature(at);
    at.t = t;
    result.later = std::max(result.later, std::abs(temperature(at) - before));
    result.range = std::max(result.range, std::abs(temperature(at) - at.T));
  }
  return result;
}

void add(const Jumps& jumps, Jumps& largest) {
  largest.first = std::max(largest.first, jumps.first);
  largest.later = std::max(largest.later, jumps.later);
  largest.range = std::max(largest.range, jumps.range);
}

std::vector<GivenFigures> given_figures(const Definition& definition, std::span<const double> start, double end) {
  std::vector<GivenFigures> result;
  for (std::size_t i = 0; i < definition.given.size(); ++i) {
    const GivenTemperature& given = definition.given[i];
    GivenFigures& one = result.emplace_back(GivenFigures{.given = i});
    const std::size_t every =
        given.value.depends_on_position() ? 1 + given.nodes.size() / some_faces : given.nodes.size();
    for (std::size_t n = 0; n < given.nodes.size(); n += every) {
      const Vector3& x = definition.bodies[given.body].mesh->nodes[static_cast<std::size_t>(given.nodes[n])];
      add(jumps_of(given.value, {.x = x[0], .y = x[1], .z = x[2], .T = start[given.body]}, end), one.jumps);
    }
  }
  return result;
}

std::vector<FilmFigures> film_figures(const Definition& definition, std::span<const double> start, double end) {
  std::vector<FilmFigures> result;
  for (std::size_t i = 0; i < definition.flows.size(); ++i) {
    const SurfaceFlow& flow = definition.flows[i];
    if (flow.kind != SurfaceFlow::Kind::film || flow.faces.empty()) continue;
    const Conductor& body = definition.bodies[flow.body];
    const double T = start[flow.body];
    const std::vector<double> sizes = element_sizes(*body.mesh, flow.faces);
    const double conductivity = least_conductivity(body, T);
    FilmFigures one{.flow = i};
    const bool is_same_everywhere = !flow.factor.depends_on_position() && !flow.beyond.depends_on_position();
    const std::size_t every = is_same_everywhere ? sizes.size() : 1 + sizes.size() / some_faces;
    for (std::size_t f = 0; f < sizes.size(); f += every) {
      const double size =
          *std::max_element(sizes.begin() + static_cast<std::ptrdiff_t>(f),
                            sizes.begin() + static_cast<std::ptrdiff_t>(std::min(f + every, sizes.size())));
      const Vector3& x = body.mesh->nodes[static_cast<std::size_t>(flow.faces[f].nodes.front())];
      Arguments at{.x = x[0], .y = x[1], .z = x[2], .T = T};
      Jumps jumps = jumps_of(flow.beyond, at, end);
      if (!(flow.factor(at) > 0)) jumps.first = 0;
      for (const double t : flow.factor.breakpoints(end)) {
        at.t = std::nextafter(t, 0);
        const double before = flow.factor(at);
        at.t = t;
        const double after = flow.factor(at);
        if (after > before)
          jumps.later = std::max(jumps.later, (1 - before / after) * std::abs(flow.beyond(at) - at.T));
      }
      add(jumps, one.jumps);
      for (int k = 0; k <= samples; ++k) {
        at.t = end * k / samples;
        const double h = flow.factor(at);
        one.coefficient = std::max(one.coefficient, h);
        if (const double biot = h * size / conductivity; biot > one.biot) {
          one.biot = biot;
          one.element_size = size;
        }
      }
    }
    result.push_back(one);
  }
  return result;
}

}  // namespace

Figures figures(const Definition& definition, std::span<const double> start, double end) {
  return {heating_through(definition, start), film_figures(definition, start, end),
          given_figures(definition, start, end)};
}

}  // namespace creepcontact::heat
