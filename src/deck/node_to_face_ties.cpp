#include "node_to_face_ties.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/mesh/point_tree.hpp"
#include "element_faces.hpp"

namespace creepcontact::deck {
namespace {

/// The point of a face nearest to a position.
struct Projection {
  double distance = std::numeric_limits<double>::infinity();
  Eigen::VectorXd shape;
};

Vector3 clamped(Vector3 xi, mesh::CellType cell) {
  const bool is_triangle = mesh::n_corners(cell) == 3;
  xi = is_triangle ? xi.cwiseMax(0.0).eval() : xi.cwiseMax(-1.0).cwiseMin(1.0).eval();
  if (is_triangle && xi[0] + xi[1] > 1) xi /= xi[0] + xi[1];
  return xi;
}

Projection project(const Vector3& position, const Eigen::Matrix3Xd& nodes, mesh::CellType cell) {
  constexpr int most_iterations = 30;
  const fem::ReferenceElement& element = fem::reference_element(cell);
  const int d = element.dimension();
  Vector3 xi = mesh::n_corners(cell) == 3 ? Vector3(1.0 / 3, 1.0 / 3, 0) : Vector3(0, 0, 0);
  Eigen::VectorXd shape(element.n_nodes());
  Eigen::MatrixX3d gradient(element.n_nodes(), 3);
  for (int i = 0; i < most_iterations; ++i) {
    element.shape(xi, shape);
    element.gradient(xi, gradient);
    const Eigen::MatrixXd tangents = nodes * gradient.leftCols(d);
    Vector3 step = Vector3::Zero();
    step.head(d) = (tangents.transpose() * tangents).ldlt().solve(tangents.transpose() * (position - nodes * shape));
    const Vector3 next = clamped(xi + step, cell);
    const double change = (next - xi).norm();
    xi = next;
    if (change < 1e-13) break;
  }
  element.shape(xi, shape);
  return {(position - nodes * shape).norm(), shape};
}

/// The nearest points of a surface.
class NearestFace {
 public:
  NearestFace(const Deck& deck, const std::vector<ElementFace>& faces) : deck_(deck), faces_(faces) {
    std::vector<Vector3> centres;
    for (const ElementFace& face : faces) {
      const Numbers nodes = face_nodes(deck, face);
      Eigen::Matrix3Xd x(3, std::ssize(nodes));
      for (std::size_t i = 0; i < nodes.size(); ++i) x.col(static_cast<Eigen::Index>(i)) = position(nodes[i]);
      centres.emplace_back(x.rowwise().mean());
      positions_.push_back(std::move(x));
    }
    tree_.emplace(centres);
  }

  /// Returns the positions of the nodes of a face, as columns.
  const Eigen::Matrix3Xd& positions(std::size_t face) const { return positions_[face]; }

  struct Found {
    std::size_t face = 0;
    Projection projection;
    double size = 0;  // of the face
  };
  Found operator()(std::int64_t node) const {
    constexpr std::size_t candidates = 9;
    Found best;
    for (const mesh::Neighbour& near : tree_->nearest(position(node), candidates)) {
      const mesh::CellType cell =
          face_cell(element_cell(deck_, faces_[near.point].element), positions_[near.point].cols());
      if (Projection found = project(position(node), positions_[near.point], cell);
          found.distance < best.projection.distance)
        best = {near.point, std::move(found), 0};
    }
    const Eigen::Matrix3Xd& x = positions_[best.face];
    best.size = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).norm();
    return best;
  }

 private:
  const Vector3& position(std::int64_t node) const { return deck_.positions[deck_.node_of_number.at(node)]; }

  const Deck& deck_;
  const std::vector<ElementFace>& faces_;
  std::vector<Eigen::Matrix3Xd> positions_;
  std::optional<mesh::PointTree> tree_;
};

std::set<std::int64_t> nodes_of(const Deck& deck, const std::vector<ElementFace>& faces) {
  std::set<std::int64_t> nodes;
  for (const ElementFace& face : faces)
    for (const std::int64_t node : face_nodes(deck, face)) nodes.insert(node);
  return nodes;
}

Vector3 total_normal(const Deck& deck, const std::vector<ElementFace>& faces) {
  Vector3 sum = Vector3::Zero();
  for (const ElementFace& face : faces) sum += outward_area(deck, face);
  return sum;
}

}  // namespace

bool face_alike(const Deck& deck, const std::vector<ElementFace>& slave, const std::vector<ElementFace>& master) {
  return total_normal(deck, slave).dot(total_normal(deck, master)) > 0;
}

std::map<std::int64_t, NearestPoint> nearest_points(const Deck& deck, const std::vector<ElementFace>& slave,
                                                    const std::vector<ElementFace>& master) {
  const NearestFace nearest(deck, master);
  std::map<std::int64_t, NearestPoint> result;
  for (const std::int64_t node : nodes_of(deck, slave)) {
    const NearestFace::Found best = nearest(node);
    if (best.projection.shape.size() > 0)
      result[node] = {best.projection.distance, nearest.positions(best.face) * best.projection.shape};
  }
  return result;
}

std::vector<DeckEquation> tie_nodes_to_faces(const Deck& deck, const std::vector<ElementFace>& slave,
                                             const std::vector<ElementFace>& master, std::optional<double> tolerance,
                                             int n_components, const Place& place) {
  constexpr double default_tolerance = 0.025;  // of the size of a face
  const NearestFace nearest(deck, master);
  std::vector<DeckEquation> equations;
  for (const std::int64_t node : nodes_of(deck, slave)) {
    const NearestFace::Found best = nearest(node);
    if (best.projection.shape.size() == 0 ||
        best.projection.distance > tolerance.value_or(default_tolerance * best.size))
      continue;
    const Numbers nodes = face_nodes(deck, master[best.face]);
    for (int k = 0; k < n_components; ++k) {
      DeckEquation equation{{{{node, k}, 1.0}}, {}, place, "TIE"};
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (const double part = best.projection.shape[static_cast<Eigen::Index>(i)]; std::abs(part) > 1e-12)
          equation.terms[{nodes[i], k}] -= part;
      equations.push_back(std::move(equation));
    }
  }
  return equations;
}

}  // namespace creepcontact::deck
