#include "stiffness_change.hpp"

#include <algorithm>
#include <limits>

namespace creepcontact::creep {

StiffnessChange stiffness_change(const Assembly& assembly, const contact::CondensedInterface& interface,
                                 const std::vector<mechanics::BodyConditions>& at) {
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  for (std::size_t b = 0; b < at.size(); ++b) {
    const auto [low, high] = interface.factored(b).stiffness_ratio(at[b]);
    least = std::min(least, low);
    largest = std::max(largest, high);
  }
  least = assembly.team().min(least);
  largest = assembly.team().max(largest);
  return {(least + largest) / 2, (largest - least) / (largest + least)};
}

bool stiffness_changes(const Assembly& assembly) {
  return std::ranges::any_of(assembly.bodies(), [](const mechanics::Body& body) { return body.stiffness_changes(); });
}

}  // namespace creepcontact::creep
