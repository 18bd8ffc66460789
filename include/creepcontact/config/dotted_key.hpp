#pragma once
/// Keys of a configuration as text.

#include <string>

namespace creepcontact::config {

/// "materials.steel.creep[0].A", as messages and --set have it, as "materials.steel.creep.0.A", a key of TOML. Names in
/// double quotes stay as they are. Keys that are equal so are the same.
std::string with_dots(const std::string& key);

}  // namespace creepcontact::config
