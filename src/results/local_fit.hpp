#pragma once
/// Value of a field at a place from its values at the integration points around.

#include <span>
#include <utility>
#include <vector>

#include "creepcontact/mechanics/discretization.hpp"
#include "point_location.hpp"

namespace creepcontact::results {

/// Weights of integration points whose weighted sum is the value, at the place, of the quadratic polynomial that fits
/// the points best in the least-squares sense, near ones counting most. The points are those of the elements that hold
/// the place and of all their neighbours; where they do not determine a quadratic polynomial (a single layer of
/// elements), the terms that they do not determine are left out. Stresses are most accurate at the points of reduced
/// integration and in the middle of linear elements, so this is an order better than extrapolating in one element.
/// Source: Zienkiewicz and Zhu (1992), patch recovery; Lancaster and Salkauskas (1981), moving least squares.
/// @param elements  that hold the place: one, or several on a face, an edge or a node
std::vector<std::pair<std::size_t, double>> local_fit(const mechanics::Discretization& discretization,
                                                      const mesh::Mesh& mesh, std::span<const std::size_t> elements,
                                                      const Vector3& at);

/// All elements that hold a place that was found in one of them. Cost: a pass over the elements
std::vector<std::size_t> elements_at(const mechanics::Discretization& discretization, const PointLocation& place);

}  // namespace creepcontact::results
