#pragma once
/// Geometry and configuration text for boxes that touch each other.

#include <array>
#include <string>
#include <vector>

namespace creepcontact::test {

struct Box {
  std::string name;
  std::array<double, 3> origin, lengths;
  std::array<int, 3> divisions;  ///< along z an even number
  bool hexahedra = true;         ///< else tetrahedra
};

/// Groups: volumes <name>; surfaces <name>_x0, <name>_x1 (least and largest x), <name>_y0, ... <name>_z1;
/// <name>_middle (halfway between z0 and z1, inside the body).
std::string boxes_geo(const std::vector<Box>& boxes);

/// @param value  TOML: a number, an expression in quotation marks, or a table
std::string support(const std::string& surface, const std::string& component, const std::string& value = "0");

/// @param more  further keys
std::string contact_table(const std::string& first, const std::string& second, const std::string& more = "");

}  // namespace creepcontact::test
