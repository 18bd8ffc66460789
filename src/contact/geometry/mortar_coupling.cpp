#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/geometry/mortar.hpp"

namespace creepcontact::contact {

Eigen::VectorXd MortarCoupling::on_rows(const Eigen::VectorXd& of_nodes) const {
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(n_rows());
  if (type != ContactType::tied) gaps(Eigen::seqN(0, of_nodes.size(), rows_per_node())) = of_nodes;
  return gaps;
}

Eigen::VectorXd MortarCoupling::given_gap(const Function& gap, double t) const {
  if (type == ContactType::tied) return Eigen::VectorXd::Zero(n_rows());
  if (!gap.depends_on_position())
    return on_rows(gap({.t = t}) * Eigen::Map<const Eigen::VectorXd>(area.data(), std::ssize(area)));
  Eigen::VectorXd values(gap_points.size());
  for (std::size_t p = 0; p < gap_points.size(); ++p) {
    const Vector3& x = gap_points[p];
    values[p] = gap({.x = x.x(), .y = x.y(), .z = x.z(), .t = t});
  }
  return on_rows(gap_weights * values);
}

Eigen::VectorXd MortarCoupling::first_rows(const Eigen::Ref<const Eigen::VectorXd>& of_rows) const {
  return of_rows(Eigen::seqN(0, std::ssize(nodes), rows_per_node()));
}

double MortarCoupling::pressure(std::size_t node, const Eigen::Ref<const Eigen::VectorXd>& multiplier) const {
  if (type == ContactType::tied && rows_per_node() == 3) return nodes[node].normal.dot(traction(node, multiplier));
  return multiplier[row(node)];
}

Vector3 MortarCoupling::shear(std::size_t node, const Eigen::Ref<const Eigen::VectorXd>& multiplier) const {
  Vector3 result = Vector3::Zero();
  const Index first = row(node);
  if (has_friction())
    for (Index k = 1; k < rows_per_node(); ++k) result += multiplier[first + k] * tangents[node][k - 1];
  else if (rows_per_node() == 3)
    result = traction(node, multiplier) - pressure(node, multiplier) * nodes[node].normal;
  return result;
}

Vector3 MortarCoupling::traction(std::size_t node, const Eigen::Ref<const Eigen::VectorXd>& multiplier) const {
  if (tractions.rows() > 0) {
    Vector3 sum = Vector3::Zero();
    for (int a = 0; a < 3; ++a)
      for (RowMatrix::InnerIterator part(tractions, 3 * static_cast<Index>(node) + a); part; ++part)
        sum[a] += part.value() * multiplier[part.col()];
    return sum;
  }
  const Vector3 own = multiplier.segment<3>(row(node));
  return axes.empty() ? own : Vector3(axes[node] * own);
}

Vector3 MortarCoupling::nodal_force(std::size_t node, const Eigen::Ref<const Eigen::VectorXd>& multiplier) const {
  const Vector3 own = multiplier.segment<3>(row(node));
  return area[node] * (axes.empty() ? own : Vector3(axes[node] * own));
}

}  // namespace creepcontact::contact
