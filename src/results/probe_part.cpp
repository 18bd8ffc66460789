#include "probe_part.hpp"

#include <fmt/format.h>

#include "creepcontact/base/error.hpp"

namespace creepcontact::results {

bool ProbePart::holds(const Vector3& at) const {
  return !probe_.where || (*probe_.where)({.x = at.x(), .y = at.y(), .z = at.z()}) != 0;
}

void ProbePart::require(bool found, const std::string& of) const {
  if (found) return;
  throw ModelError(
      fmt::format("where: '{}' holds nowhere on {}; the condition is on x, y, z of the undeformed mesh, in its unit of "
                  "length, and a part smaller than an element may hold no point of it",
                  probe_.where ? probe_.where->text() : "", of));
}

}  // namespace creepcontact::results
