#pragma once
/// Keys of so many parts that reading them would exhaust the stack: toml++ goes down tables by recursion.

#include <optional>
#include <string_view>

namespace creepcontact::config {

/// Offset of the first dot in a document that is one too many for a key; nullopt: there is none.
std::optional<std::size_t> find_long_key(std::string_view document);

inline constexpr const char* long_key_mistake = "a key of more than 20 parts; no key of a configuration has so many";

}  // namespace creepcontact::config
