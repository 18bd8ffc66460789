#include "creepcontact/model/mesh_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "creepcontact/config/configured.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {
namespace {

/// All that a mesh is made of: keys, and the state of the file.
std::string key_of(const config::Config& config) {
  std::string key = fmt::format("{}\n", config.mesh.trust_geometry);
  for (const config::ConfiguredValue& value : config::all_values(config))
    for (const char* table : {"mesh", "surfaces", "bodies", "analysis", "units"})
      if (value.key.starts_with(table)) key += fmt::format("{} = {}\n", value.key, value.text);
  std::error_code none;  // a missing file is told by what reads it
  const auto changed = std::filesystem::last_write_time(config.mesh.file, none).time_since_epoch();
  return fmt::format("{}{} {} {}", key, config.mesh.file.string(), changed.count(),
                     std::filesystem::file_size(config.mesh.file, none));
}

}  // namespace

std::shared_ptr<const mesh::Mesh> MeshStore::mesh_of(const config::Config& config) {
  constexpr std::size_t most = 4;
  const std::string key = key_of(config);
  const std::scoped_lock lock(mutex_);
  const auto found = std::ranges::find(entries_, key, &Entry::key);
  if (found != entries_.end()) {
    entries_.splice(entries_.end(), entries_, found);
    return entries_.back().mesh;
  }
  entries_.push_back({key, std::make_shared<const mesh::Mesh>(read_mesh(config))});
  ++n_read_;
  if (entries_.size() > most) entries_.pop_front();
  return entries_.back().mesh;
}

std::int64_t MeshStore::n_read() const {
  const std::scoped_lock lock(mutex_);
  return n_read_;
}

}  // namespace creepcontact::model
