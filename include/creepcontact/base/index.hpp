#pragma once
/// The signed type of sizes, subscripts and numbers of things: that of Eigen and of std::ssize.

#include <cstddef>

namespace creepcontact {

/// Converts to and from the sizes of standard containers without a cast (-Wno-sign-conversion); narrower integers stay
/// for what is stored in bulk, with a cast where they are made.
using Index = std::ptrdiff_t;

}  // namespace creepcontact
