#include "creepcontact/fem/cut_rule.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace creepcontact::fem {
namespace {

constexpr int most_halvings = 9;
constexpr double linear_within = 1e-4;  // of the range of the level in the element

struct Vertex {
  Vector3 xi = Vector3::Zero();
  double level = 0;
};
/// dimension + 1 vertices.
using Simplex = std::vector<Vertex>;

/// Corner numbers of the simplices that a reference domain consists of.
std::vector<std::vector<int>> simplices(CellType linear) {
  switch (linear) {
    case CellType::line2:
      return {{0, 1}};
    case CellType::tri3:
      return {{0, 1, 2}};
    case CellType::quad4:
      return {{0, 1, 2}, {0, 2, 3}};
    case CellType::tet4:
      return {{0, 1, 2, 3}};
    case CellType::hex8:  // around the diagonal from 0 to 6
      return {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
    default:  // wedge6
      return {{0, 1, 2, 5}, {0, 1, 5, 4}, {0, 4, 5, 3}};
  }
}

const QuadratureRule& simplex_rule(std::size_t dimension) {
  static const QuadratureRule line = [] {
    QuadratureRule rule = gauss_line(3);
    rule.points.col(0) = (rule.points.col(0).array() + 1) / 2;
    rule.weights /= 2;
    return rule;
  }();
  static const QuadratureRule triangles = triangle(5), tetrahedra = tetrahedron(5);
  return dimension == 1 ? line : dimension == 2 ? triangles : tetrahedra;
}

class Divider {
 public:
  Divider(const ReferenceElement& element, const Eigen::VectorXd& levels)
      : element_(element), levels_(levels), range_(levels.maxCoeff() - levels.minCoeff()), shape_(element.n_nodes()) {}

  void add(const Simplex& simplex, int halvings = 0) {
    double least = simplex[0].level, most = least, bend = 0;
    std::size_t first = 0, second = 1;
    double longest = 0;
    for (std::size_t a = 0; a < simplex.size(); ++a) {
      least = std::min(least, simplex[a].level);
      most = std::max(most, simplex[a].level);
      for (std::size_t b = 0; b < a; ++b) {
        const Vector3 middle = (simplex[a].xi + simplex[b].xi) / 2;
        bend = std::max(bend, std::abs(level(middle) - (simplex[a].level + simplex[b].level) / 2));
        const double length = (simplex[a].xi - simplex[b].xi).norm();
        if (length <= longest) continue;
        longest = length;
        first = b;
        second = a;
      }
    }
    const bool is_linear = bend <= linear_within * range_;
    const double beside = is_linear ? 0 : 2 * bend;  // how far the level may leave the values at the corners
    if (most + beside <= 0) return;
    if (least - beside >= 0) return add_points(simplex);
    if (is_linear || halvings == most_halvings) return clip(simplex);
    const Vector3 middle = (simplex[first].xi + simplex[second].xi) / 2;
    divide(simplex, first, second, {middle, level(middle)}, [&](const Simplex& half) { add(half, halvings + 1); });
  }

  Vertex vertex(const Vector3& xi) { return {xi, level(xi)}; }

  QuadratureRule rule() const {
    QuadratureRule rule{Eigen::MatrixX3d(std::ssize(points_), 3), Eigen::VectorXd(std::ssize(points_))};
    for (Index i = 0; i < rule.size(); ++i) {
      rule.points.row(i) = points_[i].transpose();
      rule.weights[i] = weights_[i];
    }
    return rule;
  }

 private:
  double level(const Vector3& xi) {
    element_.shape(xi, shape_);
    return shape_.dot(levels_);
  }

  template <typename Work>
  static void divide(const Simplex& simplex, std::size_t a, std::size_t b, const Vertex& between, const Work& work) {
    for (const std::size_t replaced : {a, b}) {
      Simplex part = simplex;
      part[replaced] = between;
      work(part);
    }
  }

  /// Cuts edges where the linear level is zero, until no simplex has both signs.
  void clip(const Simplex& simplex) {
    const auto by_level = [](const Vertex& one, const Vertex& other) { return one.level < other.level; };
    const auto [lowest, highest] = std::ranges::minmax_element(simplex, by_level);
    if (highest->level <= 0) return;
    if (lowest->level >= 0) return add_points(simplex);
    const double part = lowest->level / (lowest->level - highest->level);
    const Vertex zero{lowest->xi + part * (highest->xi - lowest->xi), 0};
    divide(simplex, lowest - simplex.begin(), highest - simplex.begin(), zero,
           [&](const Simplex& piece) { clip(piece); });
  }

  void add_points(const Simplex& simplex) {
    const std::size_t dimension = simplex.size() - 1;
    Matrix3 edges = Matrix3::Identity();
    for (std::size_t k = 0; k < dimension; ++k) edges.col(static_cast<Index>(k)) = simplex[k + 1].xi - simplex[0].xi;
    const double measure = std::abs(edges.determinant());
    if (measure == 0) return;
    const QuadratureRule& rule = simplex_rule(dimension);
    for (Index q = 0; q < rule.size(); ++q) {
      Vector3 xi = simplex[0].xi;
      for (std::size_t k = 0; k < dimension; ++k)
        xi += rule.points(q, static_cast<Index>(k)) * (simplex[k + 1].xi - simplex[0].xi);
      points_.push_back(xi);
      weights_.push_back(rule.weights[q] * measure);
    }
  }

  const ReferenceElement& element_;
  const Eigen::VectorXd& levels_;
  double range_;
  Eigen::VectorXd shape_;
  std::vector<Vector3> points_;
  std::vector<double> weights_;
};

}  // namespace

QuadratureRule positive_part_rule(const ReferenceElement& element, const Eigen::VectorXd& levels) {
  Divider divider(element, levels);
  const mesh::CellType linear = element.dimension() == 1 ? CellType::line2 : mesh::linear_type(element.type());
  for (const std::vector<int>& corners : simplices(linear)) {
    Simplex simplex;
    for (const int corner : corners) simplex.push_back(divider.vertex(element.nodes().row(corner).transpose()));
    divider.add(simplex);
  }
  return divider.rule();
}

}  // namespace creepcontact::fem
