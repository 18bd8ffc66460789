#pragma once
/// What a .geo says of itself before Gmsh sees it: which constants can be overridden (the library does not tell), and
/// which statements would reach beyond the mesh.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace creepcontact::io {

struct GeoStatement {
  std::string file;
  int line = 0;
  std::string word;  ///< that it begins with: "SystemCall"
};

struct GeoScan {
  /// Names of the numbers made with DefineConstant.
  std::set<std::string> constants;
  /// Statements that run programs, write files or end Gmsh.
  std::vector<GeoStatement> reaching_out;
  /// Includes and merges of files whose names are computed, which the scan does not follow.
  std::vector<GeoStatement> computed_files;
  /// The last statements of files whose last line has several and no line end: Gmsh takes the first of them alone.
  std::vector<GeoStatement> lost;
};

/// The .geo and the files it includes. Files that cannot be read count as empty (Gmsh itself reports them), as do those
/// larger than 16 MB.
GeoScan scan_geo(const std::filesystem::path& file);

}  // namespace creepcontact::io
