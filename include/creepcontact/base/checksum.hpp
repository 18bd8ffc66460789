#pragma once
/// Checksums, to tell whether data have changed without keeping a copy.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

struct XXH3_state_s;  // of xxHash

namespace creepcontact {

/// XXH3 of xxHash, 64 bit: the same on all machines of one byte order. Detects accidental changes, not forgery.
class Checksum {
 public:
  Checksum();

  /// Adds n values. The result does not depend on how the data are divided into calls. Cost: several GB/s.
  template <typename T>
  void add(const T* data, std::size_t n) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>, "bytes between members have any value");
    add_bytes(data, n * sizeof(T));
  }
  /// Checksum of all data added so far.
  std::uint64_t value() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };

  void add_bytes(const void* bytes, std::size_t n);

  std::unique_ptr<XXH3_state_s, Free> state_;
};

}  // namespace creepcontact
