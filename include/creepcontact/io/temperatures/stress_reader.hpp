#pragma once
/// Reads stresses at points: CSV tables, or .vtu files with an array of stresses as this program and ParaView write.

#include <filesystem>
#include <vector>

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

struct PointStresses {
  std::vector<Vector3> points;    ///< at least one, no two equal
  std::vector<Tensor6> stresses;  ///< one per point, Mandel
};

/// Columns of a table: x, y, z and xx, yy, zz, xy, yz, zx, also as stress_xx, sxx or s11, in any case and with a unit
/// in brackets; in a section without z, yz and zx. Array of a .vtu: named stress (with a unit or not), of six
/// components in the order of VTK (XX, YY, ZZ, XY, YZ, XZ) or nine. Nodes at the same place count as one with their
/// mean.
/// @param dimension  3 for solids, 2 for sections
/// @throws Error naming the file and the line or array: not readable, no such columns or array, numbers not finite
PointStresses read_stresses(const std::filesystem::path& file, int dimension);

}  // namespace creepcontact::io
