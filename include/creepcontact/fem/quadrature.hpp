#pragma once
/// Quadrature rules on reference domains.

#include "creepcontact/base/index.hpp"
#include "creepcontact/base/tensor.hpp"

namespace creepcontact::fem {

/// Points and weights of a rule.
struct QuadratureRule {
  Eigen::MatrixX3d points;  ///< n x 3, unused coordinates zero
  Eigen::VectorXd weights;  ///< n; their sum is the measure of the reference domain
  Index size() const { return weights.size(); }
};

/// Gauss-Legendre rule on [-1, 1] with n = 1..5 points, exact to degree 2n-1.
QuadratureRule gauss_line(int n);
/// Tensor products of it on [-1, 1]^2 and [-1, 1]^3.
QuadratureRule gauss_quadrilateral(int n);
QuadratureRule gauss_hexahedron(int n);
/// Unit triangle, exact to at least `degree` (1..8); positive weights, interior points.
/// @throws std::invalid_argument for another degree
QuadratureRule triangle(int degree);
/// Unit tetrahedron, exact to at least `degree` (1..5). @throws std::invalid_argument for another degree
QuadratureRule tetrahedron(int degree);
/// Triangle rule x Gauss-Legendre rule on the unit triangle x [-1, 1].
QuadratureRule wedge(int triangle_degree, int n_line);

}  // namespace creepcontact::fem
