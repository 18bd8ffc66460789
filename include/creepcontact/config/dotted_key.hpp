#pragma once
/// Keys of a configuration as text.

#include <string>
#include <vector>

namespace creepcontact::config {

/// "materials.steel.creep[0].A", as messages and --set have it, as "materials.steel.creep.0.A", a key of TOML. Names in
/// double quotes stay as they are.
std::string with_dots(const std::string& key);

/// Its names and indices: {"materials", "steel", "creep", "0", "A"}. Keys of the same parts are the same, whatever
/// spaces, quotes and leading zeros they are written with. A text that cannot be read as a key is
/// its only part.
std::vector<std::string> parts_of(const std::string& key);

/// True if the key is the other one, or lies in its value. @param inner, outer  parts_of()
bool is_within(const std::vector<std::string>& inner, const std::vector<std::string>& outer);

}  // namespace creepcontact::config
