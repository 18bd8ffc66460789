#pragma once
/// What Gmsh prints while it meshes, taken apart.

#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::io {

class MesherLog {
 public:
  /// The next bytes, cut anywhere.
  void add(std::string_view bytes);
  void end();

  /// Gmsh's errors, a line each, indented, the first ones; empty without errors
  std::string errors() const;
  /// Gmsh's warnings, those that differ in numbers alone once with their number; the first ones.
  std::vector<std::string> warnings() const;
  /// Gmsh found no memory, whatever it did afterwards.
  bool lacks_memory() const { return lacks_memory_; }
  /// What the mesher itself said, a line each, indented.
  std::string own_words() const;
  /// The last lines of Gmsh, indented, with what introduces them in a message; empty if it said nothing.
  std::string last_words() const;

 private:
  void take(const std::string& line);

  struct Warning {
    std::string text;  // of the first one
    std::string kind;  // without its numbers
    std::size_t count = 1;
  };
  std::string unfinished_;
  std::vector<std::string> errors_, own_, last_;
  std::vector<Warning> warnings_;
  std::size_t n_errors_ = 0, n_other_warnings_ = 0;
  bool extrusions_touch_ = false, lacks_memory_ = false, lacks_descriptors_ = false;
};

}  // namespace creepcontact::io
