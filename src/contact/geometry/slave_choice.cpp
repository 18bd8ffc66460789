#include <cmath>

#include "continued_surface.hpp"
#include "creepcontact/contact/geometry/mortar.hpp"
#include "segments.hpp"

namespace creepcontact::contact {
namespace {

/// The part of a surface that faces the other one.
struct Facing {
  double diameter = 0;  ///< mean of its facets
  double covered = 0;   ///< part of its facets' area that the other surface covers
};

/// @param n_own  facets of this sector; the others are those of the adjacent ones
Facing facing(const std::vector<Facet>& facets, std::size_t n_own, const std::vector<Facet>& others) {
  const Segmentation segmentation(facets, others);
  Facing result;
  double count = 0, area = 0;
  for (std::size_t f = 0; f < n_own; ++f) {
    const double part = segmentation.covered_part(f);
    if (part <= 0) continue;
    const double own = facets[f].area_vector_at_centre().norm();
    result.diameter += facets[f].diameter();
    result.covered += part * own;
    area += own;
    ++count;
  }
  if (count == 0) return {};
  return {result.diameter / count, result.covered / area};
}

/// True if the supports hold every node of the surface along its normal: such a surface is rigid, and multipliers on it
/// could only act through the other one.
bool is_held(const Surface& surface) {
  for (const mesh::Face& face : surface.faces) {
    const Facet facet(*surface.mesh, face, strip_of(*surface.mesh, {face}));
    for (int i = 0; i < facet.n_nodes(); ++i) {
      const std::int64_t node = facet.nodes()[i];
      const Matrix3 frame = surface.constraints->frame(node);
      const Vector3 normal = facet.area_vector(facet.element().nodes().row(i).transpose()).normalized();
      double free_part = 1;  // square of the normal's part that is not held
      for (int k = 0; k < surface.constraints->n_held(node); ++k) free_part -= std::pow(frame.col(k).dot(normal), 2);
      if (free_part > 1e-6) return false;
    }
  }
  return true;
}

}  // namespace

bool first_is_better_slave(const Surface& first, const Surface& second) {
  constexpr double clearly_softer = 10.0;
  constexpr double sticks_out = 0.5;
  if (const bool first_held = is_held(first); first_held != is_held(second)) return !first_held;
  const Strip strip = strip_of(*first.mesh, first.faces);
  const ContinuedSurface all_first(first), all_second(second);
  const std::vector<Facet> a = make_facets(all_first.mesh(), all_first.faces(), strip);
  const std::vector<Facet> b = make_facets(all_second.mesh(), all_second.faces(), strip);
  const Facing of_first = facing(a, first.faces.size(), b), of_second = facing(b, second.faces.size(), a);
  // Facets that stick out far over the other surface are too coarse to show where it presses.
  if (of_first.covered < sticks_out * of_second.covered) return false;
  if (of_second.covered < sticks_out * of_first.covered) return true;
  if (first.young_modulus * clearly_softer < second.young_modulus) return true;
  if (second.young_modulus * clearly_softer < first.young_modulus) return false;
  return of_first.diameter >= of_second.diameter * (1 - 1e-9);
}

}  // namespace creepcontact::contact
