#pragma once
/// What a .geo says of itself before Gmsh sees it: which constants can be overridden (the library does not tell), and
/// which statements would reach beyond the mesh. Where the system can confine the mesher, the scan gives the better
/// message; where it cannot, nothing else protects the user, so that whatever the scan may misread is `unclear`.

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::io {

struct GeoStatement {
  std::string file;
  int line = 0;
  std::string word;  ///< that it begins with: "SystemCall"
};

struct GeoScan {
  /// Names of the numbers made with DefineConstant: identifiers, not texts.
  std::set<std::string> constants;
  /// Statements that run programs, write files or end Gmsh.
  std::vector<GeoStatement> reaching_out;
  /// What may hide a statement from the scan: includes and merges of files that it does not follow, since their names
  /// are computed or they are too large; commands whose names are computed; words of statements that reach out in
  /// comments and texts, where a Macro may begin; characters and texts that Gmsh ends earlier; plugins and external
  /// fields.
  std::vector<GeoStatement> unclear;
  /// The last statements of files whose last line has several and no line end: Gmsh takes the first of them alone.
  std::vector<GeoStatement> lost;
};

/// Whether it is a letter or an underscore, followed by these and digits: a name that Gmsh's language can give a value.
bool is_identifier(std::string_view name);

/// The .geo and the files it includes. Files that do not exist count as empty (Gmsh itself reports them); those that
/// are larger than 16 MB or no regular files are unclear.
GeoScan scan_geo(const std::filesystem::path& file);

}  // namespace creepcontact::io
