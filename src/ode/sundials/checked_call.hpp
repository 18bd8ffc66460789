#pragma once
/// Flags of SUNDIALS that mean a mistake of ours.

#include <fmt/format.h>

#include <stdexcept>

namespace creepcontact::ode {

/// @throws std::runtime_error if the flag is negative
inline void require_success(int flag, const char* function) {
  if (flag < 0) throw std::runtime_error(fmt::format("{} failed with flag {}", function, flag));
}

}  // namespace creepcontact::ode
