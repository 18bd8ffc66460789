#pragma once
/// Meshes that outlive the models that they were read for, for further models on the same mesh.

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "creepcontact/config/config.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::model {

/// Several threads may use one store.
class MeshStore {
 public:
  /// The mesh of a configuration. It is read again if a key that it depends on, or the file, has changed since.
  /// @throws ModelError as build_model()
  std::shared_ptr<const mesh::Mesh> mesh_of(const config::Config& config);
  std::int64_t n_read() const;

 private:
  struct Entry {
    std::string key;
    std::shared_ptr<const mesh::Mesh> mesh;
  };
  mutable std::mutex mutex_;
  std::list<Entry> entries_;  // the one used last at the end
  std::int64_t n_read_ = 0;
};

}  // namespace creepcontact::model
