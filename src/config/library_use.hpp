#pragma once
/// Materials that `use` the library: their tables get the blocks that the library has for them.

#include <toml++/toml.h>

#include "creepcontact/config/vocabulary.hpp"
#include "value.hpp"

namespace creepcontact::config {

/// Replaces `use` and `override` in [materials.<name>] by the data, in the units of the configuration.
void insert_library_data(toml::table& document, const std::string& file, const Vocabulary& vocabulary,
                         Context& context);

/// What `use` takes, in words.
const char* library_use_type();

/// The keys that [properties] of a library file may have.
std::vector<std::string> library_properties();

}  // namespace creepcontact::config
