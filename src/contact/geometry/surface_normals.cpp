#include "creepcontact/contact/geometry/surface_normals.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "open_edge_normals.hpp"
#include "symmetry.hpp"

namespace creepcontact::contact {
namespace {

constexpr double crease_cosine = 0.766;  // cos 40 degrees
constexpr double min_face_area = 1e-10;  // of the squared diameter: such a face has no normal

/// Faces around one node that make one smooth piece of surface.
struct Cluster {
  Vector3 area = Vector3::Zero();      // sum of area vectors: tells which faces belong to it
  Vector3 weighted = Vector3::Zero();  // sum of normals with their weights
  int multiplier = -1;
};

/// The face's own normal at a node, weighted: at corners by |a x b|/(|a|^2 |b|^2) of the edges there, exact on spheres.
Vector3 weighted_normal(const Facet& facet, int node, const Vector3& area_vector) {
  Vector3 normal = area_vector.normalized();
  const int n = facet.n_corners();
  if (node >= n) {
    const auto corners = std::span(facet.nodes()).first(n);  // in a strip a corner may be on mid-edges too
    return std::ranges::find(corners, facet.nodes()[node]) == corners.end() ? normal : Vector3::Zero();
  }
  const Vector3 a = facet.node_position((node + 1) % n) - facet.node_position(node);
  const Vector3 b = facet.node_position((node + n - 1) % n) - facet.node_position(node);
  const double lengths = a.squaredNorm() * b.squaredNorm();
  return lengths > 0 ? Vector3(a.cross(b).norm() / lengths * normal) : Vector3::Zero();
}

/// Index of the cluster of every facet's nodes.
class Clusters {
 public:
  explicit Clusters(const std::vector<Facet>& facets) : of_node_(facets.size()) {
    for (std::size_t f = 0; f < facets.size(); ++f) of_node_[f].resize(facets[f].nodes().size());
    for (const bool with_area : {true, false})  // faces without area join whatever is there
      for (std::size_t f = 0; f < facets.size(); ++f)
        for (int i = 0; i < facets[f].n_nodes(); ++i) add(facets[f], f, i, with_area);
  }

  Cluster& at(const Facet& facet, std::size_t f, int i) {
    const std::size_t node = i;
    return around_[facet.nodes()[node]][of_node_[f][node]];
  }

 private:
  void add(const Facet& facet, std::size_t f, int i, bool with_area) {
    const std::size_t node = i;
    const Vector3 area_vector = facet.area_vector(facet.element().nodes().row(i).transpose());
    if ((area_vector.norm() > min_face_area * facet.diameter() * facet.diameter()) != with_area) return;
    auto& around = around_[facet.nodes()[node]];
    std::size_t c = 0;
    while (with_area && c < around.size() && around[c].area.normalized().dot(area_vector.normalized()) < crease_cosine)
      ++c;
    if (c == around.size()) around.emplace_back();
    of_node_[f][node] = c;
    if (!with_area) return;
    around[c].area += area_vector;
    around[c].weighted += weighted_normal(facet, i, area_vector);
  }

  std::unordered_map<std::int64_t, std::vector<Cluster>> around_;
  std::vector<std::vector<std::size_t>> of_node_;
};

Vector3 normal_of(const Cluster& cluster) {
  if (cluster.weighted.norm() > 0) return cluster.weighted.normalized();
  if (cluster.area.norm() > 0) return cluster.area.normalized();
  return Vector3::UnitZ();  // no face has any area
}

/// Mean normals of the faces around, without regard to symmetry.
SurfaceNormals mean_normals(const std::vector<Facet>& facets) {
  Clusters clusters(facets);
  SurfaceNormals result;
  result.multiplier_of_corner.resize(facets.size());
  result.normal_of_node.resize(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Facet& facet = facets[f];
    for (int i = 0; i < facet.n_nodes(); ++i) {
      Cluster& cluster = clusters.at(facet, f, i);
      const Vector3 normal = normal_of(cluster);
      result.normal_of_node[f].push_back(normal);
      if (i >= facet.n_corners()) continue;
      if (cluster.multiplier < 0) {
        cluster.multiplier = static_cast<int>(result.multipliers.size());
        result.multipliers.push_back({facet.nodes()[i], normal});
      }
      result.multiplier_of_corner[f].push_back(cluster.multiplier);
    }
  }
  return result;
}

/// Faces on one side of a supported plane alone do not tell a curved surface that meets it at a right angle from one
/// that meets it obliquely; normals extrapolated from inside the surface do.
void exclude_oblique_nodes(const std::vector<Facet>& facets, const SurfaceNormals& mean, SymmetryPlanes& symmetry) {
  constexpr double oblique_share = 0.35;  // of the mean's tilt: what a curved surface would lose by extrapolation
  constexpr double min_tilt = 0.02, min_tilt_of_quadratic = 0.05;
  SurfaceNormals extrapolated = mean;
  correct_open_edges(facets, SymmetryPlanes(), extrapolated);
  std::vector<std::int64_t> oblique;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Facet& facet = facets[f];
    const double least = facet.n_nodes() == facet.n_corners() ? min_tilt : min_tilt_of_quadratic;
    for (int i = 0; i < facet.n_nodes(); ++i) {
      const std::size_t at = i;
      const double tilt = symmetry.held_part(extrapolated.normal_of_node[f][at], facet.nodes()[at]);
      const double of_mean = symmetry.held_part(mean.normal_of_node[f][at], facet.nodes()[at]);
      if (tilt > std::max(least, oblique_share * of_mean)) oblique.push_back(facet.nodes()[at]);
    }
  }
  for (const std::int64_t node : oblique) symmetry.exclude(node);
}

}  // namespace

SurfaceNormals surface_normals(const std::vector<Facet>& facets, const mechanics::Constraints& constraints) {
  SurfaceNormals result = mean_normals(facets);
  SymmetryPlanes symmetry(constraints);
  exclude_oblique_nodes(facets, result, symmetry);
  for (MultiplierNode& at : result.multipliers) at.normal = symmetry.lay(at.normal, at.node);
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (std::size_t i = 0; i < facets[f].nodes().size(); ++i)
      result.normal_of_node[f][i] = symmetry.lay(result.normal_of_node[f][i], facets[f].nodes()[i]);
  correct_open_edges(facets, symmetry, result);
  return result;
}

}  // namespace creepcontact::contact
