#pragma once
/// Meshes that outlive the models that they were read for, and couplings of their surfaces, for further models on the
/// same mesh.

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "creepcontact/config/config.hpp"
#include "creepcontact/contact/geometry/mortar.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::model {

/// Several threads may use one store.
class MeshStore {
 public:
  /// The mesh of a configuration. It is read again if a key that it depends on, or the file, has changed since.
  /// @throws ModelError as build_model()
  std::shared_ptr<const mesh::Mesh> mesh_of(const config::Config& config);
  std::int64_t n_read() const;
  /// All that a mesh is made of: keys, and the state of the file.
  static std::string key_of(const config::Config& config);
  /// The coupling of this key, made if it is not here yet. @param key  all that it is made of @throws as `make`
  std::shared_ptr<const contact::MortarCoupling> coupling(const std::string& key,
                                                          const std::function<contact::MortarCoupling()>& make);
  std::int64_t n_coupled() const;

 private:
  template <typename Item>
  struct Entry {
    std::string key;
    std::shared_ptr<const Item> item;
  };
  /// Those of one kind, the one used last at the end.
  template <typename Item>
  struct Entries {
    std::shared_ptr<const Item> find(const std::string& key);
    std::shared_ptr<const Item> add(std::string key, std::shared_ptr<const Item> item, std::size_t most);

    std::list<Entry<Item>> all;
    std::int64_t n_made = 0;
  };
  mutable std::mutex mutex_;
  Entries<mesh::Mesh> meshes_;
  Entries<contact::MortarCoupling> couplings_;
};

}  // namespace creepcontact::model
