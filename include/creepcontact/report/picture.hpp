#pragma once
/// Still pictures of the fields of a run, drawn by VTK in a process of Python.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace creepcontact::report {

struct Picture {
  /// A scalar of the field files ("von_mises"), or "mesh": the bodies in one colour each.
  std::string field = "von_mises";
  std::optional<double> time = {};       ///< the nearest one of the field files is drawn; nullopt: the last
  double warp = 0;                       ///< factor on the displacements
  std::vector<std::string> bodies = {};  ///< shown; empty: all
  std::optional<std::pair<double, double>> range = {};  ///< of the colours; nullopt: that of the values shown
  /// A point of a plane and its normal: what the normal points to is cut away.
  std::optional<std::array<double, 6>> section = {};
  std::string view = "iso";           ///< one of views(); of a section always "z"
  bool titled = true;                 ///< write the title into the picture
  int width = 1200, height = 900;     ///< pixels
  std::filesystem::path output = {};  ///< PNG file
};

/// Directions from which solids are seen: "iso", "x", "-x", "y", "-y", "z", "-z".
const std::vector<std::string>& views();

/// A picture that was drawn.
struct DrawnPicture {
  std::filesystem::path file;
  std::string title;  ///< "von Mises stress at t = 1 000 000 h, deformation x 20"
  double time = 0;
};

/// Fields of contact surfaces are drawn on these, the bodies as glass. Makes the directories of the files.
/// @param run  the output directory of a run.
/// @throws ConfigError if there are no field files, if a field, body or view is unknown (naming the nearest), or if
/// Python, VTK or a virtual display is missing (naming the package). Error (exit status 4) with the message of the
/// process if it fails.
/// Cost: one process for all pictures, two seconds or more.
std::vector<DrawnPicture> draw_pictures(const std::filesystem::path& run, const std::vector<Picture>& pictures);

}  // namespace creepcontact::report
