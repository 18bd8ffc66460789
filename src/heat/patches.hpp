#pragma once
/// Parts of the equations of heat conduction: cells, faces and pairs of faces, each with the temperatures of its nodes.

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "creepcontact/heat/conduction.hpp"

namespace creepcontact::heat {

/// Where and when a part is evaluated.
struct Moment {
  double t = 0;
  /// Parts of the matrix: those of temperatures times `conduction`, those of rates times `capacity`.
  double conduction = 1, capacity = 0;
  ContactAtNodes contact = {};
};

/// One part. Its nodes are unknowns, and may repeat.
class Patch {
 public:
  virtual ~Patch() = default;
  /// What flows out of the nodes: capacity times rate + conduction - what is supplied.
  /// @param T, rate  of its nodes @param matrix  if not null: its symmetric part
  virtual void evaluate(const Moment& at, const Eigen::VectorXd& T, const Eigen::VectorXd& rate,
                        Eigen::VectorXd& residual, Eigen::MatrixXd* matrix) const = 0;
  /// The part of the matrix that belongs to the rates. @return false: there is none
  virtual bool capacities(const Eigen::VectorXd& /*T*/, Eigen::MatrixXd& /*matrix*/) const { return false; }
  std::vector<int> nodes;
};

/// The volume of a cell, or the area of a face; of sections times the thickness or the circumference.
double size_of(const mesh::Mesh& mesh, mesh::CellType type, std::span<const std::int64_t> nodes);
/// The conductivity of a body at a place.
Matrix3 conductivity(const Conductor& body, double T, const Vector3& place);
/// The conductance at a point of two faces of an interface. @param bodies  the first and the second one @param T  mean
/// temperature there
/// @throws ModelError if it is not a number, or negative
double conductance(const Interface& interface, const contact::FacingFaces& faces,
                   const contact::FacingFaces::Point& point, const std::array<const Conductor*, 2>& bodies,
                   const Moment& at, double T);

using Patches = std::vector<std::unique_ptr<Patch>>;

/// Which unknown a node has.
using UnknownOf = std::vector<std::vector<int>>;  // [body][node]

/// @param time_unit  capacities are divided by it
Patches cell_patches(const Conductor& body, const std::vector<int>& unknown_of, double time_unit);
Patches source_patches(const Source& source, const Conductor& body, const std::vector<int>& unknown_of);
Patches flow_patches(const SurfaceFlow& flow, const Conductor& body, const std::vector<int>& unknown_of,
                     double absolute_zero);
Patches point_patches(const PointFlow& flow, const Definition& definition, const UnknownOf& unknown_of);
Patches interface_patches(const Interface& interface, const Definition& definition, const UnknownOf& unknown_of);

}  // namespace creepcontact::heat
