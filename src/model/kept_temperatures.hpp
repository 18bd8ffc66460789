#pragma once
/// Computed temperatures on disk, for runs that differ in their mechanics alone.

#include <filesystem>
#include <optional>
#include <string>

#include "creepcontact/heat/history.hpp"

namespace creepcontact::model {

/// Lines of item and value, separated by a tabulator: all that the temperatures follow from, and the version of the
/// program. Meshes and places are in it by checksums, functions by their texts.
/// @param rest  further lines
std::string heat_fingerprint(const heat::Definition& definition, const std::string& rest);

/// What a file keeps, if its fingerprint is this one; the log tells why it does not fit. nullopt without a file.
/// @throws ModelError if it is a file of another kind
std::optional<heat::History> read_kept(const std::filesystem::path& path, const std::string& fingerprint,
                                       std::size_t n_unknowns);
/// A warning if the disk does not take it.
void write_kept(const std::filesystem::path& path, const std::string& fingerprint, const heat::History& history);

}  // namespace creepcontact::model
