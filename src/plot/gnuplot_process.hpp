#pragma once
/// gnuplot as a process.

#include <filesystem>
#include <string>

namespace creepcontact::plot {

/// Format of the picture that gnuplot draws.
enum class PictureFormat { svg, png };

/// Files of a picture: the script STEM.gp, and STEM.dat if there are data. The script writes STEM.svg, or STEM.png
/// where the variable `format` is 'png'.
struct GnuplotFiles {
  std::string stem, script, data;
};

/// Draws in directories of its own, in which gnuplot is started without the user's settings, so that nothing which lies
/// in a directory of results is executed or written over through a link.
class GnuplotDrawing {
 public:
  /// Writes STEM.gp and STEM.dat into `directory`, for the user to change. @throws Error (exit status 4)
  GnuplotDrawing(GnuplotFiles files, std::filesystem::path directory);
  /// Draws and moves the picture into the directory.
  /// @throws ConfigError if gnuplot is not installed; Error (exit status 4) with its message if it fails
  void draw(PictureFormat format) const;

 private:
  GnuplotFiles files_;
  std::filesystem::path directory_;
};

}  // namespace creepcontact::plot
