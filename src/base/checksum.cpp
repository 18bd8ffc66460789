#include "creepcontact/base/checksum.hpp"

#include <xxhash.h>

#include <new>

namespace creepcontact {

Checksum::Checksum() : state_(XXH3_createState()) {
  if (!state_) throw std::bad_alloc();
  XXH3_64bits_reset(state_.get());
}

void Checksum::Free::operator()(XXH3_state_s* state) const {
  XXH3_freeState(state);
}

void Checksum::add_bytes(const void* bytes, std::size_t n) {
  XXH3_64bits_update(state_.get(), bytes, n);
}

std::uint64_t Checksum::value() const {
  return XXH3_64bits_digest(state_.get());
}

}  // namespace creepcontact
