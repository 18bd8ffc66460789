#include "verification/cube.hpp"

#include <utility>
#include <vector>

namespace creepcontact::test {

std::string cube_toml(const std::string& material, const std::string& loading, const std::string& time) {
  std::string toml = R"(
    [mesh]
    file = "case.geo"
    order = 1
    [bodies.cube]
    region = "cube"
    material = "steel"
    [materials.steel]
    young_modulus = 200e3
    poisson_ratio = 0.3
    )" + material + R"(
  )" + support("x0", "x") +
                     support("y0", "y") + support("z0", "z") + loading + "\n[time]\n" + time;
  const std::vector<std::pair<std::string, std::string>> probes{
      {"sxx", "stress_xx"},       {"szz", "stress_zz"}, {"exx", "strain_xx"},     {"cxx", "creep_strain_xx"},
      {"cyy", "creep_strain_yy"}, {"damage", "damage"}, {"life", "life_fraction"}};
  for (const auto& [name, quantity] : probes)
    toml += "\n[[probes]]\nname = \"" + name + "\"\nquantity = \"" + quantity + "\"\nbody = \"cube\"\n";
  return toml;
}

Outcome run_cube(const std::string& material, const std::string& loading, const std::string& time) {
  return run_case(cube_toml(material, loading, time), cube_geo);
}

std::string pulled(const std::string& stress) {
  return "\n[[loads]]\non = \"x1\"\ntraction = [" + stress + ", 0, 0]\n";
}

std::string creep_law_table(const std::string& law, const std::string& keys) {
  return "\n[[materials.steel.creep]]\nlaw = \"" + law + "\"\n" + keys + "\n";
}

}  // namespace creepcontact::test
