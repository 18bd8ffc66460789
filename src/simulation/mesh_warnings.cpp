#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/mechanics/mesh_quality.hpp"
#include "creepcontact/simulation/model.hpp"

namespace creepcontact::simulation {
namespace {

constexpr double almost_incompressible = 0.4999;

/// Of all integration points at the set time.
double largest_poisson_ratio(const mechanics::Body& body) {
  double largest = 0;
  for (std::size_t p = 0; p < body.discretization().n_points(); ++p) {
    const material::Moduli& moduli = body.elastic().at(p);
    largest = std::max(largest, moduli.lambda / (2 * (moduli.lambda + moduli.mu)));
  }
  return largest;
}

}  // namespace

std::vector<std::string> mesh_warnings(const mechanics::Body& body) {
  std::vector<std::string> warnings;
  if (body.n_parts() > 1)
    warnings.push_back(fmt::format(
        "body '{}': its mesh is in {} parts that share no faces and move apart from each other; if they are meant as "
        "one, "
        "let their volumes share surfaces (BooleanFragments or Coherence in the .geo file), or name them as bodies of "
        "their own with tied contact",
        body.name(), body.n_parts()));
  if (const auto folded = mechanics::folded_elements(body.mesh()); !folded.empty())
    warnings.push_back(fmt::format(
        "body '{}': {} quadratic elements are folded at a corner, the first around ({:.6g}, {:.6g}, {:.6g}); "
        "the stress there is wrong: refine the mesh, or let Gmsh straighten it (Mesh.HighOrderOptimize = 2)",
        body.name(), folded.size(), folded[0][0], folded[0][1], folded[0][2]));
  if (const double ratio = largest_poisson_ratio(body); ratio > almost_incompressible)
    warnings.push_back(fmt::format(
        "body '{}': Poisson's ratio is {:.8g}; above {:g} the mean stress loses digits to round-off, and {:g} is "
        "incompressible enough for any purpose",
        body.name(), ratio, almost_incompressible, almost_incompressible));
  if (!body.material().creeps()) return warnings;
  // Linear tetrahedra, and linear wedges despite B-bar, are too stiff in incompressible deformation.
  for (const mesh::CellBlock& block : body.mesh().blocks)
    if ((block.type == mesh::CellType::tet4 || block.type == mesh::CellType::wedge6) && block.size() > 0)
      warnings.push_back(fmt::format(
          "body '{}' has {} linear elements {}, which lock under creep: stresses will be wrong; mesh it with quadratic "
          "ones (mesh.order = 2) or hexahedra",
          body.name(), block.size(), mesh::name(block.type)));
  return warnings;
}

}  // namespace creepcontact::simulation
