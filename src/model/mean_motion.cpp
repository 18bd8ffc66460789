#include "mean_motion.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/mechanics/loads.hpp"

namespace creepcontact::model {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double unknown_motion = 1e-9;  // of the largest eigenvalue, with rotations times the size of the nodes

/// Components of the motion of a rigid body in a section.
std::array<bool, 6> components_of(const mesh::Section& section) {
  if (section.dimension() == 3) return {true, true, true, true, true, true};
  if (section.is_axisymmetric()) return {false, true, false, false, false, false};
  return {true, true, false, false, false, true};
}

Matrix3 cross_matrix(const Vector3& r) {
  Matrix3 matrix;
  matrix << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  return matrix;
}

}  // namespace

WeightedNodes weighted_nodes(std::size_t body, const mesh::Mesh& mesh, const std::string& group) {
  if (mesh.group(group).dimension < mesh.section.dimension() - 1)
    return equally_weighted(body, mesh::group_nodes(mesh, group));
  std::vector<double> integrals(3 * mesh.nodes.size(), 0.0);
  mechanics::traction_load(mesh, mesh::boundary_faces(mesh, group), {1.0, 0.0, 0.0})->add(0, integrals);
  WeightedNodes result{body, {}, {}};
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    if (integrals[3 * i] == 0) continue;
    result.nodes.push_back(static_cast<std::int64_t>(i));
    result.weights.push_back(integrals[3 * i]);
  }
  return result;
}

WeightedNodes equally_weighted(std::size_t body, std::vector<std::int64_t> nodes) {
  WeightedNodes result{body, std::move(nodes), {}};
  result.weights.assign(result.nodes.size(), 1.0);
  return result;
}

MeanMotion::MeanMotion(const std::vector<WeightedNodes>& parts, const std::vector<mesh::Mesh>& meshes,
                       const Vector3& origin) {
  const std::array<bool, 6> counts = components_of(meshes[parts.front().body].section);
  double size = 0;
  for (const WeightedNodes& part : parts) {
    if (std::ranges::find(bodies_, part.body) == bodies_.end()) bodies_.push_back(part.body);
    for (const std::int64_t node : part.nodes)
      size = std::max(size, (meshes[part.body].nodes[static_cast<std::size_t>(node)] - origin).norm());
  }
  std::ranges::sort(bodies_);
  if (size == 0) size = 1;
  // In terms of the rotation times the size all entries are alike.
  const auto motion_of = [&](std::size_t body, std::int64_t node) {
    Eigen::Matrix<double, 3, 6> result;
    result << Matrix3::Identity(), -cross_matrix(meshes[body].nodes[static_cast<std::size_t>(node)] - origin) / size;
    for (int k = 0; k < 6; ++k)
      if (!counts[static_cast<std::size_t>(k)]) result.col(k).setZero();
    return result;
  };
  Matrix6 normal = Matrix6::Zero();
  for (const WeightedNodes& part : parts)
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
      const Eigen::Matrix<double, 3, 6> motion = motion_of(part.body, part.nodes[i]);
      normal += part.weights[i] * motion.transpose() * motion;
    }
  const linalg::SymmetricEigen eigen = linalg::symmetric_eigen(normal);
  const double least = unknown_motion * eigen.values.cwiseAbs().maxCoeff();
  Matrix6 inverse = Matrix6::Zero(), projection = Matrix6::Zero();
  for (int k = 0; k < 6; ++k) {
    if (!(eigen.values[k] > least)) continue;
    const Eigen::Matrix<double, 6, 1> v = eigen.vectors.col(k);
    inverse += v * v.transpose() / eigen.values[k];
    projection += v * v.transpose();
  }
  constexpr double whole = 1 - 1e-6;
  for (int k = 0; k < 6; ++k)
    known_[static_cast<std::size_t>(k)] = counts[static_cast<std::size_t>(k)] && projection(k, k) > whole;
  Eigen::Matrix<double, 6, 1> unscaled = Eigen::Matrix<double, 6, 1>::Ones();
  unscaled.tail<3>() /= size;
  for (const WeightedNodes& part : parts)
    for (std::size_t i = 0; i < part.nodes.size(); ++i)
      parts_.push_back(
          {part.body, part.nodes[i],
           unscaled.asDiagonal() * inverse * motion_of(part.body, part.nodes[i]).transpose() * part.weights[i]});
}

std::vector<contact::EquationTerm> MeanMotion::terms(std::size_t body, int component, double factor) const {
  std::map<std::int64_t, Vector3> all;  // a node may be on several surfaces
  for (const Part& part : parts_) {
    if (part.body != body) continue;
    const auto [found, is_new] = all.emplace(part.node, Vector3::Zero());
    found->second += factor * part.motion.row(component).transpose();
  }
  std::vector<contact::EquationTerm> result;
  for (const auto& [node, coefficient] : all)
    if (!coefficient.isZero(0)) result.push_back({node, coefficient});
  return result;
}

void MeanMotion::add_loads(const std::array<Function, 3>& force, const std::array<Function, 3>& moment,
                           Bodies& bodies) const {
  for (const std::size_t b : bodies_)
    for (int k = 0; k < 6; ++k) {
      const Function& value = k < 3 ? force[static_cast<std::size_t>(k)] : moment[static_cast<std::size_t>(k - 3)];
      if (value.is_zero()) continue;
      std::vector<std::int64_t> nodes;
      std::vector<Vector3> forces;
      for (const contact::EquationTerm& term : terms(b, k, 1)) {
        nodes.push_back(term.node);
        forces.push_back(term.coefficient);
      }
      bodies[b].add_load(mechanics::nodal_load(std::move(nodes), std::move(forces), value));
    }
}

}  // namespace creepcontact::model
