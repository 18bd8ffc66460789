#pragma once
/// What a mesh represents.

#include "creepcontact/settings/enum_names.hpp"

namespace creepcontact::settings {

/// solid: a mesh in three dimensions. The others: sections in the plane z = 0; axisymmetric: x is the radius, y the
/// axis.
enum class Analysis { solid, axisymmetric, plane_strain, generalized_plane_strain, plane_stress };
constexpr auto names_of(Analysis) {
  return std::to_array<EnumName<Analysis>>({{"solid", Analysis::solid},
                                            {"axisymmetric", Analysis::axisymmetric},
                                            {"plane_strain", Analysis::plane_strain},
                                            {"generalized_plane_strain", Analysis::generalized_plane_strain},
                                            {"plane_stress", Analysis::plane_stress}});
}

}  // namespace creepcontact::settings
