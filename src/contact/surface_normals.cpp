#include "creepcontact/contact/surface_normals.hpp"

#include <cmath>
#include <unordered_map>

namespace creepcontact::contact {
namespace {

constexpr double crease_cosine = 0.766;  // cos 40 degrees

/// Faces around one node that make one smooth piece of surface.
struct Cluster {
  Vector3 sum = Vector3::Zero();
  int multiplier = -1;
};

Vector3 lay_into_symmetry_planes(Vector3 normal, std::int64_t node, const mechanics::Constraints& constraints) {
  const Matrix3 frame = constraints.frame(node);
  Vector3 projected = normal;
  for (int k = 0; k < constraints.n_held(node); ++k) projected -= frame.col(k).dot(normal) * frame.col(k);
  // A normal that is itself held stays what it is.
  return projected.norm() > 0.7 ? Vector3(projected.normalized()) : normal;
}

}  // namespace

SurfaceNormals surface_normals(const std::vector<Facet>& facets, const mechanics::Constraints& constraints) {
  std::unordered_map<std::int64_t, std::vector<Cluster>> clusters;
  std::vector<std::vector<std::size_t>> cluster_of(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Facet& facet = facets[f];
    for (int i = 0; i < facet.n_nodes(); ++i) {
      const Vector3 area_vector = facet.area_vector(facet.element().nodes().row(i).transpose());
      auto& around = clusters[facet.nodes()[static_cast<std::size_t>(i)]];
      std::size_t c = 0;
      while (c < around.size() && around[c].sum.normalized().dot(area_vector.normalized()) < crease_cosine) ++c;
      if (c == around.size()) around.emplace_back();
      around[c].sum += area_vector;
      cluster_of[f].push_back(c);
    }
  }

  SurfaceNormals result;
  result.multiplier_of_corner.resize(facets.size());
  result.normal_of_node.resize(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Facet& facet = facets[f];
    for (int i = 0; i < facet.n_nodes(); ++i) {
      const std::int64_t node = facet.nodes()[static_cast<std::size_t>(i)];
      Cluster& cluster = clusters[node][cluster_of[f][static_cast<std::size_t>(i)]];
      const Vector3 normal = lay_into_symmetry_planes(cluster.sum.normalized(), node, constraints);
      result.normal_of_node[f].push_back(normal);
      if (i >= facet.n_corners()) continue;
      if (cluster.multiplier < 0) {
        cluster.multiplier = static_cast<int>(result.multipliers.size());
        result.multipliers.push_back({node, normal});
      }
      result.multiplier_of_corner[f].push_back(cluster.multiplier);
    }
  }
  return result;
}

}  // namespace creepcontact::contact
