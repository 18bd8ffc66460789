#include <fmt/format.h>

#include <Eigen/Geometry>
#include <unordered_map>

#include "creepcontact/base/error.hpp"
#include "creepcontact/fem/tangents.hpp"
#include "creepcontact/mechanics/loads.hpp"

namespace creepcontact::mechanics {

namespace {

Eigen::Matrix3Xd face_coordinates(const mesh::Mesh& mesh, const mesh::Face& face) {
  Eigen::Matrix3Xd x(3, face.nodes.size());
  for (std::size_t a = 0; a < face.nodes.size(); ++a) x.col(a) = mesh.nodes[face.nodes[a]];
  return x;
}

Vector3 area_vector(const fem::ReferenceElement& reference, const Eigen::Matrix3Xd& x, const Vector3& xi) {
  Eigen::MatrixX3d gradient(reference.n_nodes(), 3);
  reference.gradient(xi, gradient);
  return fem::area_vector(reference, x, gradient);
}

}  // namespace

std::vector<Vector3> nodal_normals(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces,
                                   const std::vector<std::int64_t>& nodes) {
  std::unordered_map<std::int64_t, Vector3> sums;
  std::unordered_map<std::int64_t, double> areas;
  for (const mesh::Face& face : faces) {
    const auto& reference = fem::reference_element(face.type);
    const Eigen::Matrix3Xd x = face_coordinates(mesh, face);
    double area = 0;
    for (int p = 0; p < reference.rule().size(); ++p) {
      const Vector3 xi = reference.rule().points.row(p).transpose();
      area += reference.rule().weights[p] * area_vector(reference, x, xi).norm();
    }
    for (std::size_t a = 0; a < face.nodes.size(); ++a) {
      const Vector3 xi = reference.nodes().row(a).transpose();
      sums.try_emplace(face.nodes[a], Vector3::Zero()).first->second +=
          area * area_vector(reference, x, xi).normalized();
      areas[face.nodes[a]] += area;
    }
  }
  std::vector<Vector3> normals;
  for (const std::int64_t node : nodes) {
    const auto sum = sums.find(node);
    if (sum == sums.end() || sum->second.norm() < 1e-6 * areas[node]) {
      const Vector3& x = mesh.nodes[node];
      throw ModelError(fmt::format("the node ({:.6g}, {:.6g}, {:.6g}) has no normal: {}", x[0], x[1], x[2],
                                   sum == sums.end() ? "it lies on no face of the surface"
                                                     : "the faces around it point in opposite directions"));
    }
    normals.push_back(sum->second.normalized());
  }
  return normals;
}

}  // namespace creepcontact::mechanics
