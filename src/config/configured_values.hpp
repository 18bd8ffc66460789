#pragma once
/// The values of a document that identify the model.

#include <toml++/toml.h>

#include <vector>

#include "creepcontact/config/configured.hpp"
#include "creepcontact/config/schema.hpp"

namespace creepcontact::config {

/// In the order of the schema, lists and names in the order of the document. A key that is not given has its default,
/// if the table around it is given and there is a default to be written.
/// @param document  without mistakes
std::vector<ConfiguredValue> configured_values(const toml::table& document, const std::vector<KeyInfo>& schema);

}  // namespace creepcontact::config
