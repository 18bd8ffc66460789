#pragma once
/// Documentation of the creep laws and their keys.

#include <string>

namespace creepcontact::material {

/// Markdown: a heading and a table of keys per law of the registry.
std::string law_reference();

}  // namespace creepcontact::material
