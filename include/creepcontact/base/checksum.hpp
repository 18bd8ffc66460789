#pragma once
/// Whether data are the same as before, without keeping them.

#include <cstddef>
#include <cstdint>

namespace creepcontact {

/// FNV-1a, 64 bit.
class Checksum {
 public:
  template <typename T>
  void add(const T* data, std::size_t n) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < n * sizeof(T); ++i) value_ = (value_ ^ bytes[i]) * 0x100000001b3ULL;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace creepcontact
