#include "creepcontact/contact/geometry/node_ties.hpp"

#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {
namespace {

constexpr double held = 1e-8;  // squared cosine of a direction with what is free

RowMatrix sparse(int rows, std::size_t n_nodes, const std::vector<Eigen::Triplet<double>>& entries) {
  RowMatrix matrix(rows, 3 * n_nodes);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

Matrix3 free_part(const mechanics::Constraints& constraints, std::int64_t node) {
  const Matrix3 frame = constraints.frame(node);
  Matrix3 projector = Matrix3::Zero();
  for (int k = 0; k < 3; ++k)
    if (k >= constraints.n_held(node)) projector += frame.col(k) * frame.col(k).transpose();
  return projector;
}

FreeAxes free_axes(const Matrix3& projectors) {
  Matrix3 off_diagonal = projectors;
  off_diagonal.diagonal().setZero();
  Eigen::Vector3d values = projectors.diagonal();
  FreeAxes result;
  if (!off_diagonal.isZero(0)) {
    const tensor::Principal principal(projectors);
    values = principal.values;
    result.axes = principal.directions;
  }
  for (int k = 0; k < 3; ++k) result.is_free[static_cast<std::size_t>(k)] = values[k] > held;
  return result;
}

MortarCoupling node_ties(const TiedBody& slave, const TiedBody& master, std::span<const NodeTie> ties) {
  MortarCoupling result;
  result.type = ContactType::tied;
  std::vector<Eigen::Triplet<double>> slave_entries, master_entries;
  int row = 0;
  for (const NodeTie& tie : ties) {
    const auto [directions, is_free] =
        free_axes(free_part(*slave.constraints, tie.slave) + free_part(*master.constraints, tie.master));
    for (int k = 0; k < 3; ++k) {
      if (!is_free[static_cast<std::size_t>(k)]) continue;
      for (int a = 0; a < 3; ++a) {
        const double entry = tie.area * directions(a, k);
        if (entry == 0) continue;
        slave_entries.emplace_back(row, 3 * static_cast<int>(tie.slave) + a, -entry);
        master_entries.emplace_back(row, 3 * static_cast<int>(tie.master) + a, entry);
      }
      result.nodes.push_back({tie.slave, directions.col(k)});
      result.area.push_back(tie.area);
      ++row;
    }
  }
  result.slave_rows = sparse(row, slave.mesh->nodes.size(), slave_entries);
  result.master_rows = sparse(row, master.mesh->nodes.size(), master_entries);
  result.geometric_gap = Eigen::VectorXd::Zero(row);
  return result;
}

}  // namespace creepcontact::contact
