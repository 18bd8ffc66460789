#include "creepcontact/fem/bubble.hpp"

#include <stdexcept>

namespace creepcontact::fem {

using mesh::CellType;

bool has_bubble(CellType type) {
  return type == CellType::tet10 || type == CellType::wedge15 || type == CellType::tri6;
}

double bubble_value(CellType type, const Vector3& xi) {
  const double x = xi[0], y = xi[1], z = xi[2];
  switch (type) {
    case CellType::tet10:
      return 256 * x * y * z * (1 - x - y - z);
    case CellType::wedge15:
      return 27 * x * y * (1 - x - y) * (1 - z * z);
    case CellType::tri6:
      return 27 * x * y * (1 - x - y);
    default:
      throw std::invalid_argument("only tet10, wedge15 and tri6 have an inner displacement");
  }
}

Vector3 bubble_gradient(CellType type, const Vector3& xi) {
  const double x = xi[0], y = xi[1], z = xi[2];
  if (type == CellType::tet10) {
    const double rest = 1 - x - y - z;
    return 256 * Vector3(y * z * (rest - x), x * z * (rest - y), x * y * (rest - z));
  }
  if (type == CellType::wedge15) {
    const double rest = 1 - x - y, along = 1 - z * z;
    return 27 * Vector3(y * (rest - x) * along, x * (rest - y) * along, -2 * x * y * rest * z);
  }
  if (type == CellType::tri6) {
    const double rest = 1 - x - y;
    return 27 * Vector3(y * (rest - x), x * (rest - y), 0);
  }
  throw std::invalid_argument("only tet10, wedge15 and tri6 have an inner displacement");
}

}  // namespace creepcontact::fem
