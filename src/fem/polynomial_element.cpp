#include "polynomial_element.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>

#include "creepcontact/base/index.hpp"

namespace creepcontact::fem {

namespace {

using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_nodes, 1>;

/// 1, x, x^2 and their derivatives
using Powers = std::array<double, 3>;
Powers powers(double x) {
  return {1, x, x * x};
}
Powers derivatives(double x) {
  return {0, 1, 2 * x};
}

void evaluate(const std::vector<Exponents>& monomials, const Powers& x, const Powers& y, const Powers& z,
              Values& values) {
  for (Index k = 0; k < values.size(); ++k) {
    const auto [a, b, c] = monomials[k];
    values[k] = x[a] * y[b] * z[c];
  }
}

bool in_space(CellType type, const Exponents& e) {
  const auto [a, b, c] = e;
  const int highest = std::max({a, b, c});
  const auto squares = std::count(e.begin(), e.end(), 2);
  switch (type) {
    case CellType::line2:
    case CellType::quad4:
    case CellType::hex8:
      return highest <= 1;
    case CellType::line3:
    case CellType::quad9:
    case CellType::hex27:
      return true;
    case CellType::quad8:
    case CellType::hex20:
      return squares <= 1;  // serendipity: superlinear degree 2
    case CellType::tri3:
    case CellType::tet4:
      return a + b + c <= 1;
    case CellType::tri6:
    case CellType::tet10:
      return a + b + c <= 2;
    case CellType::wedge6:
      return a + b <= 1 && c <= 1;
    case CellType::wedge15:
      return (a + b <= 2 && c <= 1) || (a + b <= 1 && c == 2);
    case CellType::point1:
      break;
  }
  throw std::invalid_argument("no shape functions for a point");
}

}  // namespace

std::vector<Exponents> monomials(CellType type) {
  const int dimension = mesh::dimension(type);
  std::vector<Exponents> result;
  for (int c = 0; c <= (dimension > 2 ? 2 : 0); ++c) {
    for (int b = 0; b <= (dimension > 1 ? 2 : 0); ++b) {
      for (int a = 0; a <= 2; ++a) {
        if (in_space(type, {a, b, c})) result.push_back({a, b, c});
      }
    }
  }
  return result;
}

PolynomialElement::PolynomialElement(CellType type, Eigen::MatrixX3d nodes, std::vector<Face> faces,
                                     QuadratureRule rule, QuadratureRule bulk_rule)
    : ReferenceElement(type, std::move(nodes), std::move(faces), std::move(rule), std::move(bulk_rule)),
      monomials_(fem::monomials(type)) {
  const Index n = monomials_.size();
  if (n != this->nodes().rows() || n > max_nodes) throw std::logic_error("monomials and nodes differ in number");
  Eigen::MatrixXd vandermonde(n, n);  // (k, j): monomial k at node j
  Values values(n);
  for (Index j = 0; j < n; ++j) {
    const auto xi = this->nodes().row(j);
    evaluate(monomials_, powers(xi[0]), powers(xi[1]), powers(xi[2]), values);
    vandermonde.col(j) = values;
  }
  // On these nodes every coefficient is a multiple of 1/8: rounding makes the shape functions exact.
  coefficients_ = (8 * vandermonde.partialPivLu().inverse()).array().round() / 8;
  if (!(coefficients_ * vandermonde).isApprox(Eigen::MatrixXd::Identity(n, n)))
    throw std::logic_error("the nodes do not determine the shape functions");
}

void PolynomialElement::shape(const Vector3& xi, Eigen::Ref<Eigen::VectorXd> shape) const {
  Values values(coefficients_.cols());
  evaluate(monomials_, powers(xi[0]), powers(xi[1]), powers(xi[2]), values);
  shape.noalias() = coefficients_ * values;
}

void PolynomialElement::gradient(const Vector3& xi, Eigen::Ref<Eigen::MatrixX3d> gradient) const {
  Values values(coefficients_.cols());
  const Powers x = powers(xi[0]), y = powers(xi[1]), z = powers(xi[2]);
  evaluate(monomials_, derivatives(xi[0]), y, z, values);
  gradient.col(0).noalias() = coefficients_ * values;
  gradient.rightCols<2>().setZero();
  if (dimension() > 1) {
    evaluate(monomials_, x, derivatives(xi[1]), z, values);
    gradient.col(1).noalias() = coefficients_ * values;
  }
  if (dimension() > 2) {
    evaluate(monomials_, x, y, derivatives(xi[2]), values);
    gradient.col(2).noalias() = coefficients_ * values;
  }
}

}  // namespace creepcontact::fem
