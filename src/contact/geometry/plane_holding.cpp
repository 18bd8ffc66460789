#include "plane_holding.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {
namespace {

constexpr double in_plane = 1e-5;       // of the size of an element or facet
constexpr double along_surface = 1e-6;  // part of a direction along the normal
constexpr double same_factor = 1e-9;

/// The directions of a subspace that are orthogonal to the normal. @param basis  orthonormal
std::vector<Vector3> tangential(const std::vector<Vector3>& basis, const Vector3& normal) {
  std::vector<Vector3> result;
  const auto add = [&](Vector3 direction) {
    for (const Vector3& other : result) direction -= other.dot(direction) * other;
    if (direction.norm() > 1e3 * along_surface) result.push_back(direction.normalized());
  };
  std::vector<Vector3> oblique;
  for (const Vector3& direction : basis) {
    if (std::abs(direction.dot(normal)) <= along_surface)
      add(direction);
    else
      oblique.push_back(direction);
  }
  for (std::size_t i = 1; i < oblique.size(); ++i)
    add(oblique[0].dot(normal) * oblique[i] - oblique[i].dot(normal) * oblique[0]);
  return result;
}

using Parts = std::vector<mechanics::Constraints::PrescribedPart>;

/// Factors by the texts of the functions.
std::map<std::string, double> by_function(const Parts& parts) {
  std::map<std::string, double> result;
  for (const auto& [factor, value] : parts) result[value->text()] += factor;
  return result;
}

/// True if both prescribe the same displacement at all times.
bool is_same(const std::optional<Parts>& first, const std::optional<Parts>& second) {
  if (!first || !second) return false;
  std::map<std::string, double> difference = by_function(*first);
  for (const auto& [text, factor] : by_function(*second)) difference[text] -= factor;
  return std::ranges::all_of(difference, [](const auto& one) { return std::abs(one.second) <= same_factor; });
}

}  // namespace

PlaneHolding::PlaneHolding(const Surface& surface) : surface_(surface) {
  for (const mechanics::NodeLinks::Turned& link : surface.constraints->links().turned)
    if (link.node == link.of) on_axis_.insert(link.node);
  for (const mesh::Face& face : surface.faces)
    for (const std::int64_t node : face.nodes) cells_around_[node];
  for (const mesh::CellBlock& block : surface.mesh->blocks) {
    if (!surface.mesh->is_bulk(block.type)) continue;
    for (std::size_t c = 0; c < block.size(); ++c)
      for (const std::int64_t node : block.cell(c))
        if (const auto around = cells_around_.find(node); around != cells_around_.end())
          around->second.push_back(block.cell(c));
  }
}

std::vector<Vector3> PlaneHolding::directions(std::int64_t node, const Vector3& normal) const {
  std::vector<Vector3> held;
  const Matrix3 frame = constraints().frame(node);
  for (int k = 0; k < constraints().n_held(node); ++k) held.emplace_back(frame.col(k));
  if (held.empty()) return {};
  std::vector<Vector3> result = tangential(held, normal);
  if (!is_on_axis(node)) std::erase_if(result, [&](const Vector3& direction) { return side(node, direction) == 0; });
  return result;
}

int PlaneHolding::side(std::int64_t node, const Vector3& direction) const {
  const auto around = cells_around_.find(node);
  if (around == cells_around_.end()) return 0;
  const std::vector<Vector3>& positions = surface_.mesh->nodes;
  int side = 0;
  for (const std::span<const std::int64_t> cell : around->second) {
    double size = 0;
    for (const std::int64_t other : cell) size = std::max(size, (positions[other] - positions[node]).norm());
    for (const std::int64_t other : cell) {
      const double distance = direction.dot(positions[other] - positions[node]);
      if (std::abs(distance) <= in_plane * size) {
        if (!constraints().holds(other, direction)) return 0;
        continue;
      }
      const int here = distance > 0 ? 1 : -1;
      if (side == -here) return 0;
      side = here;
    }
  }
  return side;
}

bool holds_both(const PlaneHolding& slave, std::int64_t node, const Vector3& direction, const PlaneHolding& master,
                const ContinuedSurface& surface, std::span<const Facet* const> facets) {
  const std::optional<Parts> prescribed = slave.constraints().prescribed_along(node, direction);
  const bool on_axis = slave.is_on_axis(node);
  bool found = false;
  for (const Facet* facet : facets)
    for (int i = 0; i < facet->n_nodes(); ++i) {
      // Of a strip, the layers off the plane of the section lie like it.
      const auto [own, rotation] = surface.own_node(facet->nodes()[static_cast<std::size_t>(i)]);
      const Vector3 along = rotation.transpose() * direction;
      if (on_axis) {
        found = found || master.is_on_axis(own);
        continue;
      }
      const double distance = direction.dot(facet->node_position(i) - slave.position(node));
      if (std::abs(distance) <= in_plane * facet->diameter()) {
        if (master.side(own, along) != slave.side(node, direction)) return false;
        if (!is_same(prescribed, master.constraints().prescribed_along(own, along))) return false;
        found = true;
      } else if ((distance > 0 ? 1 : -1) != slave.side(node, direction)) {
        return false;
      }
    }
  return found;
}

}  // namespace creepcontact::contact
