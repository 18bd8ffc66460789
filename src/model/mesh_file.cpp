#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/deck/mesh_of_deck.hpp"
#include "creepcontact/io/msh/gmsh_reader.hpp"
#include "creepcontact/io/msh/msh_content.hpp"
#include "creepcontact/settings/mesh_formats.hpp"
#include "model_parts.hpp"
#include "surfaces.hpp"

namespace creepcontact::model {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> meshes_in(const fs::path& directory) {
  std::vector<std::string> names;
  std::error_code failure;
  for (fs::directory_iterator entry(directory, failure), end; !failure && entry != end; entry.increment(failure)) {
    const fs::path name = entry->path().filename();
    if (settings::is_mesh_file(name.extension().string())) names.push_back(name.string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// What there is instead of a file that is missing.
std::string instead_of(const fs::path& file) {
  const fs::path directory = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code failure;
  if (!fs::is_directory(directory, failure))
    return fmt::format("there is no directory '{}'; a path is relative to the file that names it", directory.string());
  const std::vector<std::string> names = meshes_in(directory);
  if (names.empty()) return fmt::format("there is no mesh file in '{}'", directory.string());
  if (const std::string nearest = creepcontact::nearest(file.filename().string(), names); !nearest.empty())
    return fmt::format("did you mean '{}'?", nearest);
  constexpr std::size_t told = 5;
  const std::string more = names.size() > told ? fmt::format(" and {} more", names.size() - told) : "";
  return fmt::format(
      "'{}' contains {}{}", directory.string(),
      fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(told, names.size())), ", "), more);
}

}  // namespace

mesh::Mesh read_mesh(const config::Config& config) {
  const config::Mesh& mesh = config.mesh;
  std::error_code failure;
  const fs::file_status status = fs::status(mesh.file, failure);
  const std::string position = mesh.location.prefix();
  if (status.type() == fs::file_type::not_found)
    throw ModelError(fmt::format("{}no such file '{}'; {}", position, mesh.file.string(), instead_of(mesh.file)));
  if (failure) throw ModelError(fmt::format("{}cannot read '{}': {}", position, mesh.file.string(), failure.message()));
  if (!fs::is_regular_file(status))
    throw ModelError(fmt::format("{}'{}' is not a regular file; name {}", position, mesh.file.string(),
                                 settings::mesh_files_in_words));
  if (settings::is_cad_file(mesh.file.extension().string())) return read_cad_mesh(config);
  const mesh::Section section{config.analysis, mesh.thickness};
  mesh::Mesh result = mesh.file.extension() == ".inp"
                          ? io::import_msh(deck::mesh_of_deck(mesh.file), mesh.file.string(), section)
                          : io::read_mesh(mesh.file, {.order = mesh.order,
                                                      .parameters = mesh.parameters,
                                                      .time_limit = mesh.time_limit,
                                                      .memory_limit_mb = mesh.memory_limit_mb,
                                                      .trusted = mesh.trust_geometry,
                                                      .section = section});
  add_surfaces(config, result);
  return result;
}

}  // namespace creepcontact::model
