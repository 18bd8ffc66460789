#pragma once
/// What Gmsh prints while it meshes, taken apart.

#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::io {

/// Warnings go to the program's log as they come, so many of them; errors and the last words are kept.
class MesherLog {
 public:
  explicit MesherLog(std::string file) : file_(std::move(file)) {}

  /// The next bytes, cut anywhere.
  void add(std::string_view bytes);
  void end();

  /// Gmsh's errors, a line each, indented, the first ones; empty without errors
  std::string errors() const;
  /// Gmsh found no memory, whatever it did afterwards.
  bool lacks_memory() const { return lacks_memory_; }
  /// What the mesher itself said, a line each, indented.
  std::string own_words() const;
  /// The last lines of Gmsh, indented, with what introduces them in a message; empty if it said nothing.
  std::string last_words() const;

 private:
  void take(const std::string& line);

  std::string file_, unfinished_;
  std::vector<std::string> errors_, own_, last_;
  std::size_t n_errors_ = 0, n_warnings_ = 0;
  bool extrusions_touch_ = false, lacks_memory_ = false, lacks_descriptors_ = false;
};

}  // namespace creepcontact::io
