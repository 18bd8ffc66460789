#pragma once
/// A reference element given by its nodes and its monomials alone: shape functions from the inverse Vandermonde matrix.

#include <array>
#include <vector>

#include "creepcontact/fem/reference_element.hpp"

namespace creepcontact::fem {

/// Largest number of nodes of any element (hex27): bounds the workspace on the stack.
inline constexpr int max_nodes = 27;

using Exponents = std::array<int, 3>;

/// Monomials xi^a eta^b zeta^c, a, b, c <= 2, that span the shape functions of a type; as many as it has nodes.
std::vector<Exponents> monomials(CellType type);

/// N_i(xi) = sum_k C_ik m_k(xi), with C from N_i(node j) = delta_ij.
class PolynomialElement final : public ReferenceElement {
 public:
  /// @throws std::logic_error if the monomials do not interpolate at the nodes
  PolynomialElement(CellType type, Eigen::MatrixX3d nodes, std::vector<Face> faces, QuadratureRule rule,
                    QuadratureRule bulk_rule);

  void shape(const Vector3& xi, Eigen::Ref<Eigen::VectorXd> shape) const override;
  void gradient(const Vector3& xi, Eigen::Ref<Eigen::MatrixX3d> gradient) const override;

 private:
  std::vector<Exponents> monomials_;
  Eigen::MatrixXd coefficients_;  // n_nodes x monomials
};

}  // namespace creepcontact::fem
