#pragma once
/// Models of yielding bodies with closed forms: a bar under a strain, Hill's cylinder, Bree's strip. E = 1000, yield
/// stress 1.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "verification/cube.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact::test {

inline const std::string inside = "body = \"cube\"\nreduce = \"mean\"";

/// A bar of length 100 under a strain, free to contract.
inline Outcome run_bar(const std::string& material, const std::string& strain, const std::string& time,
                       const std::vector<std::string>& overrides = {}) {
  const std::string toml =
      R"toml(
    [mesh]
    file = "case.geo"
    order = 1
    [bodies.cube]
    region = "cube"
    material = "alloy"
    [materials.alloy]
    young_modulus = 1000
    poisson_ratio = 0.3
  )toml" +
      material + "\n[time]\n" + time + "\n" + probe("stress", "stress_xx", inside) +
      probe("plastic", "plastic_strain_xx", inside) + probe("sideways", "plastic_strain_yy", inside) +
      probe("accumulated", "plastic_strain_equivalent", inside) + probe("strain", "strain_xx", inside) +
      support("x0", "x") + support("y0", "y") + support("z0", "z") + support("x1", "x", strain);
  return run_case(toml, cube_geo, overrides);
}

inline const std::string wall_of_alloy = R"toml(
    [bodies.wall]
    region = "wall"
    material = "alloy"
    [materials.alloy]
    young_modulus = 1000
    poisson_ratio = 0.4999
    plasticity = { yield_stress = 1 }
)toml";

/// Hill's cylinder, b/a = 2, nu near 0.5, both ends held (R. Hill, 1950).
inline std::string cylinder_toml(const std::string& material, const std::string& pressure, const std::string& time) {
  return section_of("axisymmetric") + wall_of_alloy + material + "\n[time]\n" + time +
         "\n[[loads]]\non = \"wall_x0\"\npressure = " + pressure + "\n" + support("wall_y0", "y") +
         support("wall_y1", "y") + probe("bore", "stress_theta", "at = [1, 0.025, 0]\nbody = \"wall\"") +
         probe("outside", "displacement_x", "at = [2, 0.025, 0]\nbody = \"wall\"") +
         probe("flow", "plastic_strain_equivalent", "body = \"wall\"\nreduce = \"max\"");
}

/// A strip of layers under an axial stress and cycles of a linear temperature: J. Bree, J. Strain Anal. 2 (1967) 226.
/// Probe `strain`: the axial strain. @param primary, thermal  X and Y @param time  the table
/// @param material  keys of the material next to elasticity, expansion and yield stress
inline std::string strip_toml(double primary, double thermal, const std::string& time,
                              const std::string& material = "") {
  const std::string toml = fmt::format(
      R"toml({}
        [bodies.strip]
        region = "strip"
        material = "alloy"
        [generalized_plane_strain]
        force = {}
        [materials.alloy]
        young_modulus = 1000
        poisson_ratio = 0
        thermal_expansion = 1e-3
        reference_temperature = 0
        plasticity = {{ yield_stress = 1 }}
        {}
        [temperature]
        value = "{}*(x - 0.5)*(1 - cos(2*_pi*t))/2"
        [time]
        {}
      )toml",
      section_of("generalized_plane_strain"), 0.02 * primary, material, 2 * thermal, time);
  return toml + support("strip_x0", "x") + support("strip_y0", "y") +
         probe("strain", "axial_strain", "body = \"strip\"");
}

inline const std::string strip_geo = regions_geo({{"strip", {0, 1, 40}, {0, 0.02, 1}}});

inline Outcome run_strip(double primary, double thermal, const std::string& time, const std::string& material = "") {
  return run_case(strip_toml(primary, thermal, time, material), strip_geo);
}

}  // namespace creepcontact::test
