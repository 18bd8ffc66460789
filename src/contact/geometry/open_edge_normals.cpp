#include "open_edge_normals.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "creepcontact/linalg/dense.hpp"
#include "symmetry.hpp"

namespace creepcontact::contact {
namespace {

/// A multiplier node of the surface.
struct Vertex {
  Vector3 position;
  int n_faces = 0;
  bool is_known = true;  // not on an open edge, or corrected
  bool is_at_kink = false;
  std::set<int> neighbours;  // on the faces around, across quadrilaterals too
};

/// Number of faces at each edge: two inside the surface, one at an open edge.
using Edges = std::map<std::pair<int, int>, int>;

constexpr double min_break = 0.02;  // of a condition at a kink; about a degree
constexpr double break_of_turn = 0.35;
// Squared sine: a component that the conditions see less than this is not determined by them.
constexpr double well_seen = 0.05, barely_seen = 0.003;

class OpenEdges {
 public:
  OpenEdges(const std::vector<Facet>& facets, const SymmetryPlanes& symmetry, SurfaceNormals& normals)
      : symmetry_(symmetry), normals_(normals), vertices_(normals.multipliers.size()) {
    Edges count;
    for (std::size_t f = 0; f < facets.size(); ++f) {
      if (facets[f].n_nodes() != facets[f].n_corners()) continue;
      for_each_edge(facets[f], normals.multiplier_of_corner[f], [&](int a, int b, const Vector3&) {
        ++vertices_[a].n_faces;
        ++count[std::minmax(a, b)];
      });
      for (const int a : normals.multiplier_of_corner[f])
        for (const int b : normals.multiplier_of_corner[f])
          if (a != b) vertices_[a].neighbours.insert(b);
      for (int i = 0; i < facets[f].n_corners(); ++i) vertex(f, i).position = facets[f].node_position(i);
    }
    for (std::size_t f = 0; f < facets.size(); ++f) {
      if (facets[f].n_nodes() != facets[f].n_corners()) continue;
      for_each_edge(facets[f], normals.multiplier_of_corner[f], [&](int a, int b, const Vector3& outward) {
        if (count[std::minmax(a, b)] > 1 || (is_mirrored(a, outward) && is_mirrored(b, outward))) return;
        vertices_[a].is_known = vertices_[b].is_known = false;
      });
    }
  }

  void correct() {
    mark_kinks();
    // Well-determined nodes first: they help the corners. In long faces all chords have much the same direction.
    do {
      while (correct_from_known(2, well_seen) || correct_from_known(2, barely_seen)) {
      }
    } while (correct_from_known(1, well_seen));
    // A strip one face wide has no inner nodes, but those along it are right at least in its direction.
    for (Vertex& at : vertices_) at.is_known = at.is_known || at.n_faces > 1;
    correct_from_known(1, well_seen);
  }

 private:
  Vertex& vertex(std::size_t f, int corner) { return vertices_[normals_.multiplier_of_corner[f][corner]]; }

  /// @param work  gets both vertices and the direction that points out of the face across the edge
  template <typename Work>
  static void for_each_edge(const Facet& facet, const std::vector<int>& corners, const Work& work) {
    const Vector3 normal = facet.area_vector_at_centre().normalized();
    for (int i = 0; i < facet.n_corners(); ++i) {
      const int next = (i + 1) % facet.n_corners();
      const Vector3 outward = (facet.node_position(next) - facet.node_position(i)).cross(normal).normalized();
      work(corners[i], corners[next], outward);
    }
  }

  /// Where inner normals break the conditions the surface has a kink, or its curvature jumps: no way to go on from
  /// there.
  void mark_kinks() {
    for (std::size_t v = 0; v < vertices_.size(); ++v)
      for (const int j : vertices_[v].neighbours) {
        const std::size_t neighbour = j;
        if (!vertices_[v].is_known || !vertices_[neighbour].is_known) continue;
        const Vector3 chord = (vertices_[neighbour].position - vertices_[v].position).normalized();
        const double here = chord.dot(normals_.multipliers[v].normal);
        const double there = chord.dot(normals_.multipliers[neighbour].normal);
        if (std::abs(here + there) > std::max(min_break, break_of_turn * std::abs(there - here)))
          vertices_[v].is_at_kink = true;
      }
  }

  bool is_mirrored(int v, const Vector3& outward) const {
    const MultiplierNode& at = normals_.multipliers[v];
    return symmetry_.held_part(outward, at.node) > 0.8 && symmetry_.held_part(at.normal, at.node) < 0.7;
  }

  /// One pass, from what is known before it. @returns false if there was nothing to do
  bool correct_from_known(int min_rank, double min_seen) {
    std::vector<std::pair<std::size_t, Vector3>> corrected;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      Vector3 normal = normals_.multipliers[v].normal;
      if (!vertices_[v].is_known && fit(vertices_[v], min_seen, normal) >= min_rank) corrected.emplace_back(v, normal);
    }
    for (const auto& [v, normal] : corrected) {
      MultiplierNode& at = normals_.multipliers[v];
      at.normal = symmetry_.lay(normal, at.node);
      vertices_[v].is_known = true;
    }
    return !corrected.empty();
  }

  /// Least change of a normal that fulfils the conditions to its known neighbours in the mean.
  /// @returns how many of the two components across the normal they determine
  int fit(const Vertex& at, double min_seen, Vector3& normal) const {
    int rank = 0;
    for (int iteration = 0; iteration < 20; ++iteration) {  // the normal's length is not in the conditions
      const Vector3 axis1 = normal.unitOrthogonal();
      const Vector3 axis2 = normal.cross(axis1);
      Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
      Eigen::Vector2d right = Eigen::Vector2d::Zero();
      for (const int j : at.neighbours) {
        const std::size_t neighbour = j;
        if (!vertices_[neighbour].is_known || vertices_[neighbour].is_at_kink) continue;
        const Vector3 chord = (vertices_[neighbour].position - at.position).normalized();
        const Eigen::Vector2d c(axis1.dot(chord), axis2.dot(chord));
        square += c * c.transpose();
        right -= chord.dot(normal + normals_.multipliers[neighbour].normal) * c;
      }
      const linalg::SymmetricEigen modes = linalg::symmetric_eigen(square);
      Eigen::Vector2d step = Eigen::Vector2d::Zero();
      rank = 0;
      for (int k = 0; k < 2; ++k) {
        if (modes.values[k] < min_seen) continue;
        step += modes.vectors.col(k) * (modes.vectors.col(k).dot(right) / modes.values[k]);
        ++rank;
      }
      normal = (normal + step.x() * axis1 + step.y() * axis2).normalized();
      if (step.norm() < 1e-14) break;
    }
    return rank;
  }

  const SymmetryPlanes& symmetry_;
  SurfaceNormals& normals_;
  std::vector<Vertex> vertices_;
};

}  // namespace

void correct_open_edges(const std::vector<Facet>& facets, const SymmetryPlanes& symmetry, SurfaceNormals& normals) {
  OpenEdges(facets, symmetry, normals).correct();
  for (std::size_t f = 0; f < facets.size(); ++f)
    if (facets[f].n_nodes() == facets[f].n_corners())
      for (std::size_t i = 0; i < normals.normal_of_node[f].size(); ++i)
        normals.normal_of_node[f][i] = normals.multipliers[normals.multiplier_of_corner[f][i]].normal;
}

}  // namespace creepcontact::contact
