#include "creepcontact/model/mesh_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "creepcontact/config/configured.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {

std::string MeshStore::key_of(const config::Config& config) {
  std::string key = fmt::format("{}\n", config.mesh.trust_geometry);
  for (const config::ConfiguredValue& value : config::all_values(config))
    for (const char* table : {"mesh", "surfaces", "bodies", "analysis", "units"})
      if (value.key.starts_with(table)) key += fmt::format("{} = {}\n", value.key, value.text);
  std::error_code none;  // a missing file is told by what reads it
  const auto changed = std::filesystem::last_write_time(config.mesh.file, none).time_since_epoch();
  return fmt::format("{}{} {} {}", key, config.mesh.file.string(), changed.count(),
                     std::filesystem::file_size(config.mesh.file, none));
}

template <typename Item>
std::shared_ptr<const Item> MeshStore::Entries<Item>::find(const std::string& key) {
  const auto found = std::ranges::find(all, key, &Entry<Item>::key);
  if (found == all.end()) return nullptr;
  all.splice(all.end(), all, found);
  return all.back().item;
}

template <typename Item>
std::shared_ptr<const Item> MeshStore::Entries<Item>::add(std::string key, std::shared_ptr<const Item> item,
                                                          std::size_t most) {
  all.push_back({std::move(key), std::move(item)});
  ++n_made;
  if (all.size() > most) all.pop_front();
  return all.back().item;
}

std::shared_ptr<const mesh::Mesh> MeshStore::mesh_of(const config::Config& config) {
  constexpr std::size_t most = 4;
  const std::string key = key_of(config);
  const std::scoped_lock lock(mutex_);
  if (auto found = meshes_.find(key)) return found;
  return meshes_.add(key, std::make_shared<const mesh::Mesh>(read_mesh(config)), most);
}

std::shared_ptr<const contact::MortarCoupling> MeshStore::coupling(
    const std::string& key, const std::function<contact::MortarCoupling()>& make) {
  constexpr std::size_t most = 64;
  {
    const std::scoped_lock lock(mutex_);
    if (auto found = couplings_.find(key)) return found;
  }
  auto made = std::make_shared<const contact::MortarCoupling>(make());
  const std::scoped_lock lock(mutex_);
  return couplings_.add(key, std::move(made), most);
}

std::int64_t MeshStore::n_read() const {
  const std::scoped_lock lock(mutex_);
  return meshes_.n_made;
}

std::int64_t MeshStore::n_coupled() const {
  const std::scoped_lock lock(mutex_);
  return couplings_.n_made;
}

}  // namespace creepcontact::model
