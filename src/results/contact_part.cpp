#include "contact_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "face_points.hpp"
#include "probe_part.hpp"

namespace creepcontact::results {
namespace {

using FaceNodes = std::vector<std::int64_t>;

FaceNodes sorted_nodes(const mesh::Face& face) {
  FaceNodes nodes = face.nodes;
  std::ranges::sort(nodes);
  return nodes;
}

/// A part of a surface in contact, on one body.
struct SurfacePart {
  const mesh::Mesh& mesh;
  std::vector<mesh::Face> faces;  // of the whole surface
  std::set<FaceNodes> selected;   // of these
  const ProbePart& where;

  FaceArea area(const mesh::Face& face) const {
    FaceArea sum;
    const bool is_selected = selected.contains(sorted_nodes(face));
    for (const FacePoint& point : face_points(mesh, face)) {
      sum.whole += point.area;
      if (is_selected && where.holds(point.position)) sum.part += point.area;
    }
    return sum;
  }
  std::map<std::int64_t, FaceArea> areas() const {
    return areas_around(faces, [&](const mesh::Face& face) { return area(face); });
  }
  /// Marks the nodes of selected faces at which the condition holds.
  std::vector<char> nodes_within() const {
    std::vector<char> within(mesh.nodes.size(), 0);
    for (const FaceNodes& face : selected)
      for (const std::int64_t node : face) within[node] = where.holds(mesh.nodes[node]) ? 1 : 0;
    return within;
  }
};

/// Share of the master nodes that a multiplier presses on.
double opposite_share(const contact::Pair& pair, std::size_t multiplier, const std::vector<double>& shares) {
  const contact::MortarCoupling& coupling = pair.coupling;
  const bool is_tied = coupling.type == contact::ContactType::tied;
  Matrix3 directions = coupling.axes.empty() ? Matrix3(Matrix3::Identity()) : coupling.axes[multiplier];
  if (!is_tied) directions.col(0) = coupling.nodes[multiplier].normal;
  double part = 0, whole = 0;
  for (Index k = 0; k < (is_tied ? coupling.rows_per_node() : 1); ++k)  // some may be empty
    for (contact::RowMatrix::InnerIterator entry(coupling.master_rows, coupling.row(multiplier) + k); entry; ++entry) {
      const double weight = entry.value() * directions(entry.col() % 3, k);
      whole += weight;
      part += weight * shares[entry.col() / 3];
    }
  return whole != 0 ? std::clamp(part / whole, 0.0, 1.0) : 0;
}

double share(const FaceArea& area) {
  return area.whole > 0 ? area.part / area.whole : 0;
}

ContactPart part_of(std::size_t number, const contact::Pair& pair, bool is_slave, const SurfacePart& surface) {
  constexpr double most = 0.5;
  ContactPart part{.pair = number,
                   .body = is_slave ? pair.slave_body : pair.master_body,
                   .is_slave = is_slave,
                   .multiplier_shares = {},
                   .lies_within = {},
                   .node_shares = std::vector<double>(surface.mesh.nodes.size(), 0.0)};
  std::map<std::int64_t, FaceArea> areas = surface.areas();
  for (const auto& [node, area] : areas) part.node_shares[node] = share(area);
  std::vector<char> within = surface.nodes_within();
  if (is_slave)
    for (const contact::MortarCoupling::Image& image : pair.coupling.images) {
      const std::int64_t node = pair.coupling.nodes[image.of].node;
      areas[node].part += areas[image.at.node].part;
      areas[node].whole += areas[image.at.node].whole;
      within[node] = static_cast<char>(within[node] != 0 || within[image.at.node] != 0);
    }
  for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
    const std::int64_t node = pair.coupling.nodes[i].node;
    part.multiplier_shares.push_back(is_slave ? share(areas[node]) : opposite_share(pair, i, part.node_shares));
    part.lies_within.push_back(is_slave ? within[node] : static_cast<char>(part.multiplier_shares.back() >= most));
  }
  return part;
}

/// The part that is the whole surface.
ContactPart whole(std::size_t number, const contact::Pair& pair, bool is_slave, const mesh::Mesh& mesh) {
  const std::size_t n = pair.coupling.nodes.size();
  return {.pair = number,
          .body = is_slave ? pair.slave_body : pair.master_body,
          .is_slave = is_slave,
          .multiplier_shares = std::vector<double>(n, 1.0),
          .lies_within = std::vector<char>(n, 1),
          .node_shares = std::vector<double>(mesh.nodes.size(), 1.0)};
}

bool has_surface(const mesh::Mesh& mesh, const std::string& name) {
  const auto found = mesh.groups.find(name);
  return found != mesh.groups.end() && found->second.dimension == mesh.section.dimension() - 1;
}

bool selects(const ContactPart& part, const config::Probe& probe) {
  const bool is_extreme = probe.reduce == config::Reduce::max || probe.reduce == config::Reduce::min;
  if (is_extreme) return std::ranges::any_of(part.lies_within, [](char within) { return within != 0; });
  return std::ranges::any_of(part.multiplier_shares, [](double share) { return share > 0; });
}

}  // namespace

std::vector<ContactPart> contact_parts(const config::Probe& probe, const model::Model& model) {
  const ProbePart where(probe);
  std::vector<ContactPart> parts;
  std::set<std::string> surfaces;
  bool touches = false;  // whatever `where` says
  for (std::size_t p = 0; p < model.pairs().size(); ++p) {
    const contact::Pair& pair = model.pairs()[p];
    if (pair.ties_nodes()) continue;
    surfaces.insert({pair.slave_surface, pair.master_surface});
    bool found = false;
    // The surfaces themselves first: a surface of that name may share faces with the other one too.
    for (const bool by_name : {true, false})
      for (const bool is_slave : {true, false}) {
        const mechanics::Body& body = model.bodies()[is_slave ? pair.slave_body : pair.master_body];
        const std::string& surface = is_slave ? pair.slave_surface : pair.master_surface;
        if (found || (probe.body.given() && body.name() != probe.body.name)) continue;
        if ((surface == probe.on.name) != by_name || !has_surface(body.mesh(), probe.on.name)) continue;
        if (by_name && where.is_whole()) {
          parts.push_back(whole(p, pair, is_slave, body.mesh()));
          found = touches = true;
          continue;
        }
        SurfacePart selected{body.mesh(), mesh::boundary_faces(body.mesh(), surface), {}, where};
        std::set<FaceNodes> own;
        for (const mesh::Face& face : selected.faces) own.insert(sorted_nodes(face));
        for (const mesh::Face& face : mesh::boundary_faces(body.mesh(), probe.on.name))
          if (own.contains(sorted_nodes(face))) selected.selected.insert(sorted_nodes(face));
        if (selected.selected.empty()) continue;
        found = touches = true;
        parts.push_back(part_of(p, pair, is_slave, selected));
        if (!selects(parts.back(), probe)) parts.pop_back();
      }
  }
  if (!touches) {
    std::string names;
    for (const std::string& name : surfaces) names += (names.empty() ? "'" : ", '") + name + "'";
    throw ModelError(
        fmt::format("surface '{}' is in no contact, nor part of a surface that is; surfaces in contact: {}",
                    probe.on.name, names.empty() ? "none" : names));
  }
  if (!where.is_whole()) where.require(!parts.empty(), fmt::format("surface '{}' in contact", probe.on.name));
  return parts;
}

}  // namespace creepcontact::results
