#pragma once
/// Figures: panels with a common horizontal axis, drawn by gnuplot into SVG and PNG.

#include <filesystem>
#include <string>
#include <vector>

namespace creepcontact::plot {

struct Series {
  /// Steps: a value holds from the point before up to its own.
  enum class Style { line, steps, points };
  std::string name;  ///< any text; it is shown as it is
  std::vector<double> x, y;
  Style style = Style::line;
  int look = -1;  ///< colour and marker, below max_series; not given: that of the place in the panel
};

struct Axis {
  std::string label;
  bool logarithmic = false;
  bool zero_at_left = false;   ///< logarithmic horizontal axis: points at 0 stand at its left end, where it says 0
  bool whole_numbers = false;  ///< no ticks between them
};

struct Panel {
  Axis y;
  std::vector<Series> series;  ///< at most max_series, so that colours and markers differ
};

struct Figure {
  std::string title;
  Axis x;
  std::vector<Panel> panels;  ///< from top to bottom
};

/// Colours of Okabe and Ito (2008) that stand out from white.
inline constexpr std::size_t max_colors = 7;
/// Each has its own marker; beyond max_colors the colours come again, with dashes.
inline constexpr std::size_t max_series = 2 * max_colors;

/// The commands for gnuplot: `<stem>.svg` or, with format='png', `<stem>.png` from `<stem>.dat`.
/// @throws ConfigError if a figure has no panel, or a panel no series or too many
std::string gnuplot_script(const Figure& figure, const std::string& stem);
/// A block `x y` a series. Values that are no finite numbers are left out.
std::string gnuplot_data(const Figure& figure);

/// Writes `<stem>.gp` and `<stem>.dat`, which a user may change, and draws `<stem>.svg` and `<stem>.png` from them.
/// The directory is made if need be. Cost: two processes, some tenths of a second.
/// @param stem  a file name of letters, digits, '_' and '-'
/// @throws ConfigError if there is no gnuplot or the directory cannot be made; Error with what gnuplot says
void draw(const Figure& figure, const std::filesystem::path& directory, const std::string& stem);

/// Cuts `items` things into as few parts as hold at most `most` each, as equal as can be. @returns their sizes
std::vector<std::size_t> even_parts(std::size_t items, std::size_t most);

}  // namespace creepcontact::plot
