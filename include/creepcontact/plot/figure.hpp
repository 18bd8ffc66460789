#pragma once
/// Figures: panels with a common horizontal axis, drawn by gnuplot as SVG and PNG.

#include <filesystem>
#include <string>
#include <vector>

namespace creepcontact::plot {

/// One curve of a panel.
struct Series {
  /// Style `steps`: a value holds from the previous point up to its own. `bare_line`: no markers, as through points
  /// that another series has. `band`, `dark_band`: the area from y to `upper`, light or darker.
  enum class Style { line, steps, points, bare_line, band, dark_band };
  std::string name;  ///< any text; shown literally
  std::vector<double> x, y;
  Style style = Style::line;
  int look = -1;                   ///< colour and marker, less than max_series; -1: by the position in the panel
  std::vector<double> upper = {};  ///< of a band, as many as y
};

/// Labels and scale of an axis.
struct Axis {
  std::string label;
  bool logarithmic = false;
  bool zero_at_left = false;   ///< logarithmic x axis: points at 0 are shown at its left end, labelled 0
  bool whole_numbers = false;  ///< ticks at whole numbers only
};

/// Curves with a common vertical axis.
struct Panel {
  Axis y;
  std::vector<Series> series;  ///< at most max_series, so that colours and markers differ
};

/// A vertical line through all panels, with its name.
struct Mark {
  double x = 0;
  std::string name;
};

/// Panels with a common horizontal axis.
struct Figure {
  std::string title;
  Axis x;
  std::vector<Panel> panels;  ///< from top to bottom
  std::vector<Mark> marks = {};
};

/// Number of colours, those of Okabe and Ito (2008) that are distinct from white.
inline constexpr std::size_t max_colors = 7;
/// Each curve has its own marker; beyond max_colors the colours are repeated with dashed lines.
inline constexpr std::size_t max_series = 2 * max_colors;

/// The gnuplot commands that draw `<stem>.svg`, or `<stem>.png` with format='png', from `<stem>.dat`.
/// @throws ConfigError if a figure has no panels, or a panel has no series or too many
std::string gnuplot_script(const Figure& figure, const std::string& stem);
/// The data for gnuplot: one block `x y` per series. Values that are not finite are left out.
std::string gnuplot_data(const Figure& figure);

/// Writes `<stem>.gp` and `<stem>.dat`, which a user may edit, and draws `<stem>.svg` and `<stem>.png` from them. Makes
/// the directory if necessary. Cost: two processes, some tenths of a second.
/// @param stem  file name of letters, digits, '_' and '-'
/// @throws ConfigError if gnuplot is not found or the directory cannot be made; Error with the output of gnuplot if it
/// fails
void draw(const Figure& figure, const std::filesystem::path& directory, const std::string& stem);

/// The figure as SVG. @param directory  for the files of gnuplot, made if necessary @throws as draw()
std::string svg(const Figure& figure, const std::filesystem::path& directory);

/// A stem for names of files: of letters, digits and '_', with other characters replaced.
std::string file_stem(std::string text);

/// Divides `items` things into the smallest number of parts with at most `most` each, as evenly as possible.
/// @returns the sizes of the parts
std::vector<std::size_t> even_parts(std::size_t items, std::size_t most);

}  // namespace creepcontact::plot
