#pragma once
/// Points of one surface with the points of another one that lie opposite, for integrals over both.

#include <optional>
#include <vector>

#include "creepcontact/contact/geometry/facet.hpp"
#include "creepcontact/contact/geometry/sector.hpp"

namespace creepcontact::contact {

/// What one face sees of another one.
struct FacingFaces {
  struct Point {
    Vector3 position;           ///< on the first face; in sections in their plane
    double area = 0;            ///< of the first body's surface that belongs to it
    ShapeValues first, second;  ///< shape functions of the faces there, one per node below
    ShapeValues hats;           ///< linear functions of the corners of the first face, which come first among its nodes
  };
  /// Nodes of the meshes. In sections those of strips: each node of an edge twice.
  std::vector<std::int64_t> first_nodes, second_nodes;
  double size = 0;  ///< of the larger face: its diameter
  std::vector<Point> points;
};

/// Faces that see each other, with quadrature points that are exact for products of two shape functions on
/// plane faces with straight edges. @param sector  the second surface continues into the adjacent sectors
std::vector<FacingFaces> facing_faces(const mesh::Mesh& first, const std::vector<mesh::Face>& first_faces,
                                      const mesh::Mesh& second, const std::vector<mesh::Face>& second_faces,
                                      const std::optional<Sector>& sector);

}  // namespace creepcontact::contact
