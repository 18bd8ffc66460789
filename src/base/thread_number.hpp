#pragma once
/// Numbers of threads, to give each its own copy of what threads cannot share.

#include <cstddef>

namespace creepcontact {

/// A small number of the calling thread that no other living thread has, OpenMP's or any other. It may pass on to a
/// later thread when this one has ended. @throws std::length_error beyond 1024 threads at once
std::size_t thread_number();
inline constexpr std::size_t max_threads = 1024;

}  // namespace creepcontact
