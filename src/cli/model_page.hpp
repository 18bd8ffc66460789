#pragma once
/// The page that shows a model before its run.

#include <filesystem>

#include "creepcontact/config/config.hpp"

namespace creepcontact::cli {

/// @param config  complete, or of a mesh or CAD file alone @throws ModelError, Error
void write_model_page(const config::Config& config, const std::filesystem::path& file);

/// A configuration, or one of the mesh or CAD model of this name alone. @param unit  of its lengths; empty: mm
config::Config mesh_alone(const std::filesystem::path& file, const std::string& unit);

}  // namespace creepcontact::cli
