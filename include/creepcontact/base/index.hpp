#pragma once
/// The signed integer type for sizes and indices: that of Eigen and of std::ssize.

#include <cstddef>

namespace creepcontact {

/// Converts to and from the sizes of standard containers without a cast (-Wno-sign-conversion). Narrower integers are
/// used only for bulk storage, with a cast where they are made.
using Index = std::ptrdiff_t;

}  // namespace creepcontact
