#include "creepcontact/plot/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>

#include "axis_range.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "gnuplot_process.hpp"
#include "gnuplot_text.hpp"

namespace creepcontact::plot {
namespace {

struct Look {
  const char* color;
  int marker, dashes;  // gnuplot's numbers
};
constexpr std::array<Look, max_series> looks{{{"#0072B2", 7, 1},
                                              {"#D55E00", 5, 1},
                                              {"#009E73", 9, 1},
                                              {"#CC79A7", 11, 1},
                                              {"#E69F00", 13, 1},
                                              {"#56B4E9", 6, 1},
                                              {"#000000", 4, 1},
                                              {"#0072B2", 8, 2},
                                              {"#D55E00", 12, 2},
                                              {"#009E73", 10, 2},
                                              {"#CC79A7", 14, 2},
                                              {"#E69F00", 1, 2},
                                              {"#56B4E9", 2, 2},
                                              {"#000000", 3, 2}}};

// Pixels, for a font of 13.
constexpr double plot_width = 620, left = 118, lone_panel = 340, stacked_panel = 190, gap = 20, top = 48, bottom = 64;
constexpr double character = 9.6, sample = 78;
constexpr std::size_t longest_name = 48;
constexpr std::size_t markers_a_line = 24;
constexpr int first_mark = 10;  // of gnuplot's numbers of labels: the others are lower

void check(const Figure& figure) {
  if (figure.panels.empty()) throw ConfigError(fmt::format("figure '{}' has nothing to show", figure.title));
  for (const Panel& panel : figure.panels)
    if (panel.series.empty() || panel.series.size() > max_series)
      throw ConfigError(fmt::format("figure '{}': {} series in a panel; allowed: 1 to {}", figure.title,
                                    panel.series.size(), max_series));
}

double legend_width(const Figure& figure) {
  std::size_t longest = 0;
  for (const Panel& panel : figure.panels)
    for (const Series& series : panel.series) longest = std::max(longest, text_width(series.name));
  return sample + character * static_cast<double>(std::min(longest, longest_name));
}

bool has_points(const Series& series, const Axis& x, const Axis& y) {
  for (std::size_t i = 0; i < series.x.size(); ++i)
    if (is_drawn(series.x[i], series.y[i], x, y)) return true;
  return false;
}

bool is_band(const Series& series) {
  return series.style == Series::Style::band || series.style == Series::Style::dark_band;
}

std::string style(const Series& series, std::size_t k) {
  const Look& look = looks[series.look < 0 ? k : static_cast<std::size_t>(series.look)];
  const std::string point = fmt::format("linecolor rgb '{}' pointtype {}", look.color, look.marker);
  if (series.style == Series::Style::points) return fmt::format("with points {} pointsize 0.6", point);
  if (series.style == Series::Style::steps)
    return fmt::format("with fsteps linewidth 2 dashtype {} linecolor rgb '{}'", look.dashes, look.color);
  if (series.style == Series::Style::bare_line)
    return fmt::format("with lines linewidth 2 dashtype {} linecolor rgb '{}'", look.dashes, look.color);
  if (is_band(series))
    return fmt::format("with filledcurves fillcolor rgb '{}' fillstyle transparent solid {} noborder", look.color,
                       series.style == Series::Style::band ? 0.2 : 0.4);
  const std::size_t every = std::max<std::size_t>(1, series.x.size() / markers_a_line);
  return fmt::format("with linespoints linewidth 2 dashtype {} {} pointsize 0.8 pointinterval {}", look.dashes, point,
                     every);
}

/// Ticks with numbers between the decades, where there are few of these.
std::string ticks_between_decades(char name, const Range& range) {
  const std::vector<int> marks =
      range.to < 5 * range.from ? std::vector{1, 2, 3, 4, 5, 6, 7, 8, 9} : std::vector{1, 2, 5};
  std::string text;
  double decade = std::pow(10, std::floor(std::log10(range.from)));
  while (decade <= range.to) {
    for (const int mark : marks)
      if (mark * decade >= range.from && mark * decade <= range.to)
        text += fmt::format("{}'{:g}' {:g}", text.empty() ? "" : ", ", mark * decade, mark * decade);
    decade *= 10;
  }
  return fmt::format("set {}tics ({})\n", name, text);
}

/// Ticks, grid and ends of an axis, 'x' or 'y'.
std::string axis(char name, const Axis& axis, const Range& range) {
  std::string text = fmt::format("unset logscale {0}\nset {0}range [{1:.12g}:{2:.12g}]\nset {0}tics auto\n", name,
                                 range.from, range.to);
  if (axis.logarithmic) {
    text += fmt::format("set logscale {0}\nset m{0}tics 10\nset format {0} '10^{{%T}}'\n", name);
  } else {
    text += fmt::format("unset m{0}tics\nset format {0} '%.5g'\n", name);
    constexpr double few = 9;
    if (axis.whole_numbers && range.to - range.from < few) text += fmt::format("set {}tics 1\n", name);
  }
  return text;
}

std::string terminals(double width, double height, const std::string& stem) {
  const std::string size = fmt::format("size {:.0f},{:.0f} font 'sans-serif,13'", width, height);
  return fmt::format(
      "if (!exists('format')) format = 'svg'\n"
      "if (format eq 'png') set terminal pngcairo enhanced {0} background '#ffffff'; else set terminal svg enhanced "
      "{0} "
      "background '#ffffff'\n"
      "set output '{1}.'.format\n",
      size, stem);
}

/// Lines in all panels; their names, from the first panel on, are in its top.
std::string marks(const Figure& figure, const Range& range) {
  const bool zero = has_zero(figure);
  std::string text;
  int number = first_mark;
  for (const Mark& mark : figure.marks) {
    const double x = zero && mark.x <= 0 ? range.from : mark.x;
    if (!(x >= range.from && x <= range.to)) continue;
    text += fmt::format(
        "set arrow {0} from first {1:.12g}, graph 0 to first {1:.12g}, graph 1 nohead back dashtype 3 linewidth 1.5 "
        "linecolor rgb '#606060'\n"
        "set label {0} {2} noenhanced at first {1:.12g}, graph 0.97 right rotate by 90 offset character -0.6, 0 font "
        "',11' textcolor rgb '#404040'\n",
        number, x, gnuplot_quoted(shortened(mark.name, longest_name)));
    ++number;
  }
  return text;
}

/// The names of marks again: they are to be in one panel only.
std::string without_names(const Figure& figure) {
  std::string text;
  for (std::size_t i = 0; i < figure.marks.size(); ++i) text += fmt::format("unset label {}\n", first_mark + i);
  return text;
}

}  // namespace

std::string gnuplot_script(const Figure& figure, const std::string& stem) {
  check(figure);
  const auto n = static_cast<double>(figure.panels.size());
  const double panel_height = figure.panels.size() == 1 ? lone_panel : stacked_panel;
  const double width = left + plot_width + legend_width(figure),
               height = top + n * panel_height + (n - 1) * gap + bottom;
  const Range x_range = common_range(figure);
  const bool zero = has_zero(figure);
  const std::string x_column = zero ? "($1 > 0 ? $1 : zero)" : "1";

  std::string text = fmt::format(
      "# Draw again with:  gnuplot {0}.gp   and   gnuplot -e \"format='png'\" {0}.gp\nset encoding utf8\n{1}", stem,
      terminals(width, height, stem));
  text +=
      "set grid linetype 1 linecolor rgb '#d8d8d8' linewidth 1\nset tics nomirror\nset border 3 linecolor rgb "
      "'#404040'\n";
  text += fmt::format("set multiplot\nset lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n", left / width,
                      (left + plot_width) / width);
  text += axis('x', figure.x, x_range);
  if (figure.panels.size() == 1 && figure.x.logarithmic && x_range.to < 100 * x_range.from)
    text += ticks_between_decades('x', x_range);
  if (zero) text += fmt::format("zero = {0:.12g}\nset xtics add ('' zero)\n", x_range.from);
  const auto max_characters = static_cast<std::size_t>(width / character);
  text += fmt::format("set label 1 {} noenhanced at screen {:.5f}, screen {:.5f} left font ',14'\n",
                      gnuplot_quoted(shortened(figure.title, max_characters - 4)), left / width, 1 - 22 / height);

  text += marks(figure, x_range);
  std::size_t block = 0;
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    const Panel& panel = figure.panels[p];
    const double from_top = top + static_cast<double>(p) * (panel_height + gap);
    text += fmt::format("\nset tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n", 1 - from_top / height,
                        1 - (from_top + panel_height) / height);
    text += axis('y', panel.y, value_range(panel, figure.x));
    // Labels are left of ticks of any width, and below each other.
    text += fmt::format("set label 2 {} noenhanced at screen {:.5f}, graph 0.5 center rotate by 90\n",
                        gnuplot_quoted(panel.y.label), 16 / width);
    text +=
        fmt::format("set key at screen {:.5f}, screen {:.5f} top left Left reverse noenhanced samplen 2 spacing 1.2\n",
                    (left + plot_width + 8) / width, 1 - from_top / height);
    const bool last = p + 1 == figure.panels.size();
    if (last) {
      text += fmt::format("set xlabel {} noenhanced\n", gnuplot_quoted(figure.x.label));
      if (zero) text += "set xtics add ('0' zero)\n";
    } else {
      text += "set format x ''\n";
    }
    if (last && figure.panels.size() > 1)
      text += figure.x.logarithmic ? "set format x '10^{%T}'\n" : "set format x '%.5g'\n";
    // A series without a point keeps its name in the legend.
    text += "plot NaN notitle";
    for (std::size_t k = 0; k < panel.series.size(); ++k, ++block)
      text += fmt::format(", \\\n     {} {} title {}",
                          has_points(panel.series[k], figure.x, panel.y)
                              ? fmt::format("'{}.dat' index {} using {}:2{}", stem, block, x_column,
                                            is_band(panel.series[k]) ? ":3" : "")
                              : "NaN",
                          style(panel.series[k], k), gnuplot_quoted(shortened(panel.series[k].name, longest_name)));
    text += "\n";
    if (p == 0) text += "unset label 1\n" + without_names(figure);
  }
  return text + "unset multiplot\n";
}

std::string gnuplot_data(const Figure& figure) {
  std::string text;
  for (const Panel& panel : figure.panels)
    for (const Series& series : panel.series) {
      text += fmt::format("# {}\n", gnuplot_quoted(series.name));
      for (std::size_t i = 0; i < series.x.size(); ++i)
        if (is_drawn(series.x[i], series.y[i], {}, {}))
          fmt::format_to(std::back_inserter(text), "{} {}{}\n", series.x[i], series.y[i],
                         is_band(series) ? fmt::format(" {}", series.upper[i]) : "");
      text += "# end\n\n\n";
    }
  return text;
}

namespace {

GnuplotDrawing drawing_of(const Figure& figure, const std::filesystem::path& directory, const std::string& stem) {
  std::error_code failure;
  std::filesystem::create_directories(directory, failure);
  if (failure) throw ConfigError(fmt::format("directory for pictures '{}': {}", directory.string(), failure.message()));
  return {{stem, gnuplot_script(figure, stem), gnuplot_data(figure)}, directory};
}

}  // namespace

void draw(const Figure& figure, const std::filesystem::path& directory, const std::string& stem) {
  const GnuplotDrawing drawing = drawing_of(figure, directory, stem);
  drawing.draw(PictureFormat::svg);
  drawing.draw(PictureFormat::png);
}

std::string svg(const Figure& figure, const std::filesystem::path& directory) {
  drawing_of(figure, directory, "figure").draw(PictureFormat::svg);
  return read_file(directory / "figure.svg").bytes;
}

std::string file_stem(std::string text) {
  constexpr std::size_t longest = 80;  // names of files are bounded
  text.resize(std::min(text.size(), longest));
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return text;
}

std::vector<std::size_t> even_parts(std::size_t items, std::size_t most) {
  const std::size_t parts = (items + most - 1) / most;
  std::vector<std::size_t> sizes;
  for (std::size_t p = 0; p < parts; ++p) sizes.push_back(items / parts + (p < items % parts ? 1 : 0));
  return sizes;
}

}  // namespace creepcontact::plot
