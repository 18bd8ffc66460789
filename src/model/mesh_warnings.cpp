#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/mechanics/mesh_quality.hpp"
#include "creepcontact/model/model.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {
namespace {

std::vector<mesh::CellBlock> locking_blocks(const mesh::Mesh& mesh) {
  std::vector<mesh::CellBlock> result;
  if (mesh.section.analysis == settings::Analysis::plane_stress) return result;  // the third direction is free
  for (const mesh::CellBlock& block : mesh.blocks)
    if (mesh.is_bulk(block.type) && fem::reference_element(block.type).locks() && block.size() > 0)
      result.push_back(block);
  return result;
}

constexpr double almost_incompressible = 0.4999, rounding_of_ratio = 1e-9;

/// The largest ratio of all integration points at t = 0.
double largest_poisson_ratio(const mechanics::Body& body) {
  double largest = 0;
  const mechanics::BodyConditions at = body.at(0);
  for (std::size_t p = 0; p < body.discretization().n_points(); ++p) {
    const material::Moduli& moduli = at.elastic().at(p);
    largest = std::max(largest, moduli.lambda / (2 * (moduli.lambda + moduli.mu)));
  }
  return largest;
}

}  // namespace

std::vector<std::string> mesh_warnings(const mechanics::Body& body) {
  std::vector<std::string> warnings;
  if (body.n_parts() > 1)
    warnings.push_back(
        fmt::format("body '{}': its mesh consists of {} parts that share no faces and can move apart; if they are one "
                    "part, let their volumes share surfaces (BooleanFragments or Coherence in the .geo file), or make "
                    "them separate bodies with tied contact",
                    body.name(), body.n_parts()));
  if (const auto folded = mechanics::folded_elements(body.mesh()); !folded.empty())
    warnings.push_back(fmt::format(
        "body '{}': {} quadratic elements are folded at a corner, the first around ({:.6g}, {:.6g}, {:.6g}); "
        "the stress there is wrong: refine the mesh, or let Gmsh straighten it (Mesh.HighOrderOptimize = 2)",
        body.name(), folded.size(), folded[0][0], folded[0][1], folded[0][2]));
  const bool is_plane_stress = body.mesh().section.analysis == settings::Analysis::plane_stress;
  if (const double ratio = largest_poisson_ratio(body);
      ratio > almost_incompressible + rounding_of_ratio && !is_plane_stress)
    warnings.push_back(
        fmt::format("body '{}': Poisson's ratio is {:.8g}; above {:g} the mean stress loses digits to rounding; {:g} "
                    "is close enough to incompressible for any purpose",
                    body.name(), ratio, almost_incompressible, almost_incompressible));
  if (!body.material().creeps()) return warnings;
  for (const mesh::CellBlock& block : locking_blocks(body.mesh()))
    warnings.push_back(
        fmt::format("body '{}' has {} {} elements, which are too stiff under creep (mesh.allow_locking = true): its "
                    "stresses will be wrong",
                    body.name(), block.size(), mesh::name(block.type)));
  return warnings;
}

void refuse_locking(const std::string& body, const mesh::Mesh& mesh) {
  for (const mesh::CellBlock& block : locking_blocks(mesh))
    throw ModelError(fmt::format(
        "body '{}' has {} {} elements, which are too stiff under creep (volumetric locking); use quadratic elements "
        "(mesh.order = 2, or 'gmsh -order 2') or {}, or accept wrong stresses with mesh.allow_locking = true",
        body, block.size(), mesh::name(block.type),
        mesh.section.dimension() == 3 ? "hexahedra" : "quadrilaterals (Recombine Surface)"));
}

}  // namespace creepcontact::model
