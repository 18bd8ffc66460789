#pragma once
/// Position of an entry in the configuration, so that errors found later (e.g. a group missing in the mesh) can name
/// it.

#include <string>

namespace creepcontact::config {

/// Where an entry is written.
struct Location {
  std::string file = {};  ///< name of the file, or the override "--set key=value"
  int line = 0;           ///< from 1; 0 for an override, or if unknown
  int column = 0;
  std::string key = {};  ///< full key: "materials.disc.creep[0].n"

  /// Beginning of a message: "shrink_fit.toml:14:3: materials.disc.creep[0].n: ", as far as known.
  std::string prefix() const;
};

/// The name of something defined elsewhere: a physical group, a body, a material.
struct Reference {
  std::string name;  ///< empty: not given
  Location location = {};
  bool given() const { return !name.empty(); }
};

}  // namespace creepcontact::config
