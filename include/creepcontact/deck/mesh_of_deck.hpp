#pragma once
/// The mesh of a deck alone: nodes, elements, sets and surfaces, without its materials and steps.

#include <filesystem>

#include "creepcontact/io/msh/msh_content.hpp"

namespace creepcontact::deck {

/// Each set of elements becomes a group of volumes, or of surfaces if its elements are those of sections, each surface
/// one of faces, each set of nodes one of points; they have the names of the deck. Elements of other kinds are left
/// out, with a warning that counts them. @throws ConfigError for mistakes of the nodes, elements and sets
io::MshContent mesh_of_deck(const std::filesystem::path& path);

}  // namespace creepcontact::deck
