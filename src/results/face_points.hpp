#pragma once
/// Integration over faces of a mesh, and shares of their nodes in a part of them.

#include <functional>
#include <map>
#include <vector>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::results {

struct FacePoint {
  Vector3 position = Vector3::Zero();
  double area = 0;  ///< times the depth of sections
  Eigen::VectorXd shape;
};

/// The points of the rule for loads on faces.
std::vector<FacePoint> face_points(const mesh::Mesh& mesh, const mesh::Face& face);

struct FaceArea {
  double part = 0, whole = 0;
};

/// For every node of the faces, the sum over the faces around it.
std::map<std::int64_t, FaceArea> areas_around(const std::vector<mesh::Face>& faces,
                                              const std::function<FaceArea(const mesh::Face&)>& area);

/// The part of these areas over the whole, 0 to 1.
std::map<std::int64_t, double> node_shares(const std::vector<mesh::Face>& faces,
                                           const std::function<FaceArea(const mesh::Face&)>& area);

}  // namespace creepcontact::results
