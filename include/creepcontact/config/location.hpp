#pragma once
/// Where something stands in the configuration, so that errors found later (a group the mesh lacks) can still say so.

#include <string>

namespace creepcontact::config {

struct Location {
  std::string file = {};  ///< or the override, "--set key=value"
  int line = 0;           ///< from 1; 0 if it comes from an override or from nowhere
  int column = 0;
  std::string key = {};  ///< full key: "materials.disc.creep[0].n"

  /// Begin of a message: "shrink_fit.toml:14:3: materials.disc.creep[0].n: ", as far as known.
  std::string prefix() const;
};

/// The name of something that stands elsewhere: a physical group, a body, a material.
struct Reference {
  std::string name;  ///< empty: not given
  Location location = {};
  bool given() const { return !name.empty(); }
};

}  // namespace creepcontact::config
