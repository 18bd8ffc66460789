#pragma once
/// Settings of the solution with the elastic stiffness.

#include "creepcontact/settings/enum_names.hpp"

namespace creepcontact::settings {

/// automatic: direct if there is memory for the factors, else multigrid.
enum class StiffnessMethod { automatic, direct, multigrid };
constexpr auto names_of(StiffnessMethod) {
  return std::to_array<EnumName<StiffnessMethod>>({{"auto", StiffnessMethod::automatic},
                                                   {"direct", StiffnessMethod::direct},
                                                   {"multigrid", StiffnessMethod::multigrid}});
}

struct StiffnessSettings {
  StiffnessMethod method = StiffnessMethod::automatic;
};

}  // namespace creepcontact::settings
