/// What is read of CAD models besides their meshes: the unit of a STEP file, the facts that the mesher tells, and
/// shapes fitted to any triangles.
#include <cstdint>
#include <string_view>
#include <vector>

#include "creepcontact/io/msh/cad_reader.hpp"
#include "creepcontact/mesh/surface_shape.hpp"
#include "fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  io::unit_of_step(text);
  fuzz::may_refuse([&] { io::CadFacts::from(text); });
  constexpr std::size_t most = 60;  // of a fit, whose cost grows with them
  std::vector<mesh::Facet> facets;
  for (std::size_t at = 0; at + 9 <= size && facets.size() < most; at += 9) {
    mesh::Facet& facet = facets.emplace_back();
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (std::size_t k = 0; k < 3; ++k)
        facet.corners[corner][static_cast<Eigen::Index>(k)] =
            static_cast<double>(static_cast<std::int8_t>(data[at + 3 * corner + k]));
  }
  if (facets.empty()) return 0;
  const mesh::SurfaceShape shape = mesh::fit_shape(facets);
  fuzz::require(shape.kind == mesh::ShapeKind::other || shape.center.allFinite(), "shapes have finite places");
  return 0;
}
