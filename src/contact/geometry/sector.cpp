#include "creepcontact/contact/geometry/sector.hpp"

namespace creepcontact::contact {

Matrix3 Sector::turns(int sectors) const {
  Matrix3 result = Matrix3::Identity();
  if (sectors == count - 1 && sectors > 1) return rotation.transpose();
  for (int k = 0; k < sectors; ++k) result = rotation * result;
  return result;
}

std::vector<int> Sector::neighbours() const {
  if (count < 2) return {};
  if (count == 2) return {1};
  return {1, count - 1};
}

}  // namespace creepcontact::contact
