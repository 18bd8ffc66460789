#include "face_points.hpp"

#include "creepcontact/fem/tangents.hpp"

namespace creepcontact::results {

std::vector<FacePoint> face_points(const mesh::Mesh& mesh, const mesh::Face& face) {
  const fem::ReferenceElement& element = fem::reference_element(face.type);
  const fem::QuadratureRule& rule = element.rule();
  Eigen::MatrixX3d gradient(element.n_nodes(), 3);
  Eigen::Matrix3Xd x(3, element.n_nodes());
  for (int i = 0; i < element.n_nodes(); ++i) x.col(i) = mesh.nodes[face.nodes[i]];
  std::vector<FacePoint> points;
  for (int q = 0; q < rule.size(); ++q) {
    const Vector3 xi = rule.points.row(q).transpose();
    Eigen::VectorXd shape(element.n_nodes());
    element.shape(xi, shape);
    element.gradient(xi, gradient);
    const Vector3 position = x * shape;
    const double area = rule.weights[q] * mesh.section.depth(position) * fem::area_vector(element, x, gradient).norm();
    points.push_back({position, area, std::move(shape)});
  }
  return points;
}

std::map<std::int64_t, FaceArea> areas_around(const std::vector<mesh::Face>& faces,
                                              const std::function<FaceArea(const mesh::Face&)>& area) {
  std::map<std::int64_t, FaceArea> around;
  for (const mesh::Face& face : faces) {
    const FaceArea own = area(face);
    for (const std::int64_t node : face.nodes) {
      around[node].part += own.part;
      around[node].whole += own.whole;
    }
  }
  return around;
}

std::map<std::int64_t, double> node_shares(const std::vector<mesh::Face>& faces,
                                           const std::function<FaceArea(const mesh::Face&)>& area) {
  std::map<std::int64_t, double> shares;
  for (const auto& [node, sum] : areas_around(faces, area)) shares[node] = sum.whole > 0 ? sum.part / sum.whole : 0;
  return shares;
}

}  // namespace creepcontact::results
