#include "creepcontact/mechanics/free_motions.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::mechanics {
namespace {

using Nodes = std::vector<std::int64_t>;

constexpr double not_held = 1e-9;  // singular value of the conditions on a motion

Vector3 position(const mesh::Mesh& mesh, std::int64_t node) {
  return mesh.nodes[node];
}

Vector3 centre_of(const mesh::Mesh& mesh, const Nodes& nodes) {
  Vector3 centre = Vector3::Zero();
  for (const std::int64_t node : nodes) centre += position(mesh, node) / static_cast<double>(nodes.size());
  return centre;
}

/// @returns the length by which the displacement was divided
double normalize(Eigen::VectorXd& displacement) {
  double largest = 0;
  for (Index i = 0; i < displacement.size(); i += 3) largest = std::max(largest, displacement.segment<3>(i).norm());
  displacement /= largest;
  return largest;
}

FreeMotion motion_of_nodes(const mesh::Mesh& mesh, const Nodes& nodes, const RigidMotion& rigid) {
  FreeMotion motion;
  motion.displacement.setZero(3 * mesh.nodes.size());
  for (const std::int64_t node : nodes)
    motion.displacement.segment<3>(3 * node) = rigid.displacement(position(mesh, node));
  const double length = normalize(motion.displacement);
  motion.description = rigid.describe();
  motion.rigid = RigidMotion{rigid.translation / length, rigid.rotation / length, rigid.centre};
  return motion;
}

/// Parts that share nodes with others: all their rigid-body modes, tied together at the shared nodes and by the
/// supports.
std::vector<FreeMotion> motions_of_hinged_parts(const mesh::Mesh& mesh, const Constraints& constraints,
                                                const std::vector<Nodes>& parts) {
  Nodes all;
  for (const Nodes& part : parts) all.insert(all.end(), part.begin(), part.end());
  const Vector3 centre = centre_of(mesh, all);
  double size = 0;
  for (const std::int64_t node : all) size = std::max(size, (position(mesh, node) - centre).norm());
  // Displacement of a node by the six unknowns (t, size w) of its part.
  const auto motion_at = [&](std::int64_t node) {
    const Vector3 r = (position(mesh, node) - centre) / size;
    Eigen::Matrix<double, 3, 6> m;
    m << Matrix3::Identity(), Vector3::UnitX().cross(r), Vector3::UnitY().cross(r), Vector3::UnitZ().cross(r);
    return m;
  };
  const Index n_unknowns = 6 * parts.size();
  std::vector<Eigen::RowVectorXd> rows;
  std::map<std::int64_t, std::size_t> first_part;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const std::int64_t node : parts[p]) {
      const auto [found, is_new] = first_part.emplace(node, p);
      const Eigen::Matrix<double, 3, 6> own = motion_at(node);
      const std::vector<Vector3> directions =
          is_new ? resisted_directions(mesh, constraints, node)
                 : std::vector<Vector3>{Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
      for (const Vector3& direction : directions) {
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(n_unknowns);
        row.segment<6>(6 * p) = direction.transpose() * own;
        if (!is_new) row.segment<6>(6 * found->second) -= direction.transpose() * own;
        rows.push_back(std::move(row));
      }
    }
  Eigen::MatrixXd conditions(rows.size(), n_unknowns);
  for (std::size_t r = 0; r < rows.size(); ++r) conditions.row(r) = rows[r];
  const Eigen::MatrixXd free = linalg::null_space(conditions, not_held);

  std::vector<FreeMotion> motions;
  for (Index j = 0; j < free.cols(); ++j) {
    FreeMotion motion;
    motion.displacement.setZero(3 * mesh.nodes.size());
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (const std::int64_t node : parts[p])
        motion.displacement.segment<3>(3 * node) = motion_at(node) * free.block<6, 1>(6 * p, j);
    normalize(motion.displacement);
    motion.description =
        fmt::format("a mechanism of parts joined at single edges or nodes near ({:.6g}, {:.6g}, {:.6g})", centre[0],
                    centre[1], centre[2]);
    motions.push_back(std::move(motion));
  }
  return motions;
}

/// Groups of parts that hang together by shared nodes.
std::vector<std::vector<Nodes>> clusters(std::vector<Nodes> parts) {
  std::vector<std::vector<Nodes>> result;
  for (Nodes& part : parts) {
    std::vector<Nodes> cluster{std::move(part)};
    for (auto other = result.begin(); other != result.end();) {
      const bool touches = std::any_of(other->begin(), other->end(), [&](const Nodes& nodes) {
        Nodes shared;
        std::set_intersection(nodes.begin(), nodes.end(), cluster.front().begin(), cluster.front().end(),
                              std::back_inserter(shared));
        return !shared.empty();
      });
      if (!touches) {
        ++other;
        continue;
      }
      std::move(other->begin(), other->end(), std::back_inserter(cluster));
      other = result.erase(other);
    }
    result.push_back(std::move(cluster));
  }
  return result;
}

}  // namespace

std::vector<FreeMotion> free_motions(const mesh::Mesh& mesh, const MeshParts& parts, const Constraints& constraints) {
  const std::vector<std::vector<Nodes>> pieces = clusters(parts);
  std::vector<FreeMotion> motions;
  for (const std::vector<Nodes>& cluster : pieces) {
    if (cluster.size() > 1) {
      for (FreeMotion& motion : motions_of_hinged_parts(mesh, constraints, cluster))
        motions.push_back(std::move(motion));
      continue;
    }
    for (const RigidMotion& rigid : free_rigid_motions(mesh, constraints, cluster.front())) {
      FreeMotion motion = motion_of_nodes(mesh, cluster.front(), rigid);
      if (pieces.size() > 1) {
        const Vector3 x = centre_of(mesh, cluster.front());
        motion.description += fmt::format(" of the part around ({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
        motion.rigid.reset();
      }
      motions.push_back(std::move(motion));
    }
  }
  return motions;
}

std::vector<std::int64_t> determinate_fixing_dofs(const std::vector<FreeMotion>& motions,
                                                  const Constraints& constraints) {
  if (motions.empty()) return {};
  const Index n = motions.size();
  Eigen::MatrixXd rows(n, constraints.n_free());
  std::vector<double> free(constraints.n_free());
  for (Index i = 0; i < n; ++i) {
    const Eigen::VectorXd& displacement = motions[i].displacement;
    constraints.restrict_to_free({displacement.data(), static_cast<std::size_t>(displacement.size())}, free);
    rows.row(i) = Eigen::Map<const Eigen::RowVectorXd>(free.data(), constraints.n_free());
  }
  const Eigen::VectorXi pivots = linalg::column_pivots(rows);
  return {pivots.begin(), pivots.begin() + n};
}

}  // namespace creepcontact::mechanics
