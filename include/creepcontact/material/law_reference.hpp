#pragma once
/// The creep laws and their keys for the documentation.

#include <string>

namespace creepcontact::material {

/// Markdown: a heading and a table of keys for every law of the registry.
std::string law_reference();

}  // namespace creepcontact::material
