#include "element_block.hpp"

#include <fmt/format.h>

#include "creepcontact/base/error.hpp"
#include "element_loops.hpp"

namespace creepcontact::mechanics {

namespace {

using mesh::CellType;

CellType linear_type(CellType type) {
  switch (mesh::n_corners(type)) {
    case 4:
      return CellType::tet4;
    case 6:
      return CellType::wedge6;
    default:
      return CellType::hex8;
  }
}

Eigen::MatrixXd extrapolation_matrix(const fem::ReferenceElement& reference) {
  const Eigen::MatrixX3d& points = reference.rule().points;
  const bool complete = points.rows() >= reference.n_nodes();
  const auto& basis = fem::reference_element(complete ? reference.type() : linear_type(reference.type()));
  const auto values_at = [&](const Eigen::MatrixX3d& places) {
    Eigen::MatrixXd values(places.rows(), basis.n_nodes());
    Eigen::VectorXd shape(basis.n_nodes());
    for (Eigen::Index i = 0; i < places.rows(); ++i) {
      basis.shape(places.row(i).transpose(), shape);
      values.row(i) = shape.transpose();
    }
    return values;
  };
  // One point alone (tet4): the solution of least norm is the constant.
  return values_at(reference.nodes()) * values_at(points).completeOrthogonalDecomposition().pseudoInverse();
}

}  // namespace

std::unique_ptr<const ElementBlock> ElementBlock::make(const mesh::CellBlock& cells, const std::vector<Vector3>& nodes,
                                                       BlockStart start) {
  switch (cells.type) {
    case CellType::tet4:
      return std::make_unique<ElementLoops<4, 1, false>>(cells, nodes, start);
    case CellType::tet10:
      return std::make_unique<ElementLoops<10, 4, false>>(cells, nodes, start);
    case CellType::hex8:
      return std::make_unique<ElementLoops<8, 8, true>>(cells, nodes, start);
    case CellType::hex20:
      return std::make_unique<ElementLoops<20, 8, false>>(cells, nodes, start);
    case CellType::hex27:
      return std::make_unique<ElementLoops<27, 27, false>>(cells, nodes, start);
    case CellType::wedge6:
      return std::make_unique<ElementLoops<6, 6, true>>(cells, nodes, start);
    case CellType::wedge15:
      return std::make_unique<ElementLoops<15, 9, false>>(cells, nodes, start);
    default:
      throw ModelError(fmt::format("cells of type {} are no volume elements", mesh::name(cells.type)));
  }
}

ElementBlock::ElementBlock(const mesh::CellBlock& cells, const std::vector<Vector3>& nodes, BlockStart start)
    : reference_(fem::reference_element(cells.type)),
      start_(start),
      n_nodes_(static_cast<std::size_t>(reference_.n_nodes())),
      n_points_(static_cast<std::size_t>(reference_.rule().size())),
      connectivity_(cells.connectivity),
      extrapolation_(extrapolation_matrix(reference_)) {
  tabulate();
  measure(nodes);
}

void ElementBlock::tabulate() {
  shape_.resize(static_cast<Eigen::Index>(n_nodes_), static_cast<Eigen::Index>(n_points_));
  derivatives_.resize(n_points_ * n_nodes_ * 3);
  Eigen::MatrixX3d gradient(n_nodes_, 3);
  for (std::size_t p = 0; p < n_points_; ++p) {
    const Vector3 xi = reference_.rule().points.row(static_cast<Eigen::Index>(p)).transpose();
    reference_.shape(xi, shape_.col(static_cast<Eigen::Index>(p)));
    reference_.gradient(xi, gradient);
    for (std::size_t a = 0; a < n_nodes_; ++a)
      for (std::size_t k = 0; k < 3; ++k)
        derivatives_[(p * n_nodes_ + a) * 3 + k] = gradient(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(k));
  }
}

void ElementBlock::measure(const std::vector<Vector3>& nodes) {
  geometry_.resize(n_elements() * n_points_);
  for (std::size_t e = 0; e < n_elements(); ++e) {
    const auto cell = this->nodes(e);
    for (std::size_t p = 0; p < n_points_; ++p) {
      Matrix3 jacobian = Matrix3::Zero();  // d x_i / d xi_k
      for (std::size_t a = 0; a < n_nodes_; ++a) {
        const Eigen::Map<const Vector3> derivative(&derivatives_[(p * n_nodes_ + a) * 3]);
        jacobian += nodes[static_cast<std::size_t>(cell[a])] * derivative.transpose();
      }
      const double determinant = jacobian.determinant();
      if (!(determinant > 0)) {
        const Vector3 x = point(e, p, nodes);
        throw ModelError(
            fmt::format("element {} ({}) at ({:.6g}, {:.6g}, {:.6g}) is inverted or has no volume: "
                        "Jacobian {:.3g}; mend the mesh there",
                        start_.element + e, mesh::name(type()), x[0], x[1], x[2], determinant));
      }
      PointGeometry& at = geometry_[e * n_points_ + p];
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(at.inverse) = jacobian.inverse();
      at.weight = determinant * reference_.rule().weights[static_cast<Eigen::Index>(p)];
    }
  }
}

Vector3 ElementBlock::point(std::size_t e, std::size_t p, const std::vector<Vector3>& nodes) const {
  Vector3 x = Vector3::Zero();
  const auto cell = this->nodes(e);
  for (std::size_t a = 0; a < n_nodes_; ++a)
    x += shape_(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(p)) * nodes[static_cast<std::size_t>(cell[a])];
  return x;
}

void ElementBlock::body_force(std::span<const Vector3> force_density, std::span<double> element_forces) const {
  for (std::size_t e = 0; e < n_elements(); ++e) {
    Eigen::Map<Eigen::Matrix3Xd> forces(&element_forces[3 * (start_.entry + e * n_nodes_)], 3,
                                        static_cast<Eigen::Index>(n_nodes_));
    forces.setZero();
    for (std::size_t p = 0; p < n_points_; ++p) {
      const std::size_t q = e * n_points_ + p;
      forces +=
          geometry_[q].weight * force_density[start_.point + q] * shape_.col(static_cast<Eigen::Index>(p)).transpose();
    }
  }
}

}  // namespace creepcontact::mechanics
