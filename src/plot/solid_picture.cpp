#include "creepcontact/plot/solid_picture.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <span>

#include "creepcontact/base/error.hpp"
#include "gnuplot_process.hpp"
#include "gnuplot_text.hpp"

namespace creepcontact::plot {
namespace {

// Pixels, for a font of 13.
constexpr double view_width = 430, view_height = 360, flat_width = 720, flat_height = 800, edge = 84, page_top = 48,
                 between_views = 12;
constexpr double letter = 9.8, width_of_number = 64, symbol = 44, legend_line = 20;
constexpr std::size_t longest_entry = 52;
constexpr int alone = 4;                  // bodies that have views of their own
constexpr std::size_t with_mesh = 6'000;  // facets in a view: with more, their outlines would cover them
constexpr double air = 0.06;              // around the bodies, of their size

using Color = std::array<double, 3>;  // 0 to 255
constexpr std::array<Color, 6> of_bodies{
    {{198, 212, 232}, {238, 218, 184}, {208, 208, 208}, {226, 202, 220}, {214, 230, 202}, {240, 228, 160}}};
/// Blue supports, red loads; contacts green, and further pairs in other colours.
constexpr std::array<Color, 4> of_supports{{{40, 96, 200}, {90, 160, 235}, {10, 50, 130}, {110, 120, 220}}};
constexpr std::array<Color, 4> of_loads{{{205, 30, 30}, {240, 110, 70}, {140, 10, 60}, {250, 150, 130}}};
constexpr std::array<Color, 8> of_contacts{{{20, 140, 60},
                                            {130, 200, 90},
                                            {10, 100, 100},
                                            {80, 200, 170},
                                            {150, 100, 10},
                                            {230, 180, 50},
                                            {120, 40, 140},
                                            {195, 130, 215}}};

std::span<const Color> family_of(SolidMark::Kind kind) {
  if (kind == SolidMark::Kind::support) return of_supports;
  if (kind == SolidMark::Kind::load) return of_loads;
  return of_contacts;
}

std::string text_of(const Color& color, double brightness = 1) {
  const auto part = [&](std::size_t i) {
    return static_cast<int>(std::lround(std::clamp(color[i] * brightness, 0.0, 255.0)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
}

Color color_of_body(int body) {
  return of_bodies[static_cast<std::size_t>(body) % of_bodies.size()];
}

/// Marks of one kind have colours of one family, in turn.
Color color_of_mark(const SolidPicture& picture, int mark) {
  const SolidMark::Kind kind = picture.marks[mark].kind;
  const auto before = std::count_if(picture.marks.begin(), picture.marks.begin() + mark,
                                    [&](const SolidMark& other) { return other.kind == kind; });
  const std::span<const Color> family = family_of(kind);
  return family[static_cast<std::size_t>(before) % family.size()];
}

/// Two surfaces in contact lie on each other: the second one is drawn within the first.
double width_of_mark(const SolidPicture& picture, int mark) {
  if (picture.marks[mark].kind != SolidMark::Kind::contact) return 5;
  const auto before = std::count_if(picture.marks.begin(), picture.marks.begin() + mark,
                                    [](const SolidMark& other) { return other.kind == SolidMark::Kind::contact; });
  return before % 2 == 0 ? 8 : 3;
}

/// Parallel projection.
struct Camera {
  Vector3 eye, right, up;
  bool shades = true;

  static Camera from(const Vector3& direction) {
    const Vector3 eye = direction.normalized(), right = Vector3::UnitZ().cross(eye).normalized();
    return {eye, right, eye.cross(right)};
  }
  static Camera along_z() { return {Vector3::UnitZ(), Vector3::UnitX(), Vector3::UnitY(), false}; }
  double x(const Vector3& point) const { return right.dot(point); }
  double y(const Vector3& point) const { return up.dot(point); }
  double brightness(const Vector3& normal) const {
    return shades ? 0.6 + 0.4 * std::max(0.0, normal.dot((eye + 0.6 * up - 0.3 * right).normalized())) : 1.0;
  }
};

/// Area vector by Newell's method: also of polygons that are not quite plane.
Vector3 normal_of(const std::vector<Vector3>& corners) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) sum += corners[i].cross(corners[(i + 1) % corners.size()]);
  return sum.norm() > 0 ? sum.normalized() : sum;
}

Vector3 middle_of(const std::vector<Vector3>& corners) {
  return std::accumulate(corners.begin(), corners.end(), Vector3(Vector3::Zero())) /
         static_cast<double>(corners.size());
}

/// The least of 1, 2, 5, 10, ... that is at least this.
double step_for(double least) {
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * decade >= least) return step * decade;
  return 10 * decade;
}

/// Where a view stands in the picture [pixels from the upper left], and what it shows.
struct View {
  Camera camera;
  int body = -1;  // -1: all
  double left = 0, from_top = 0, width = 0, height = 0;

  bool shows(int other) const { return body < 0 || body == other; }
};

class Script {
 public:
  Script(const SolidPicture& picture, const std::string& stem) : picture_(picture) {
    const std::vector<View> views = picture.flat ? flat_view() : solid_views();
    double right = 0, below = 0;
    for (const View& view : views) {
      right = std::max(right, view.left + view.width);
      below = std::max(below, view.from_top + view.height);
    }
    const double entries = static_cast<double>(picture.bodies.size() + picture.marks.size());
    width_ = right + between_views + legend_width();
    height_ = std::max(below + (picture.flat ? edge : between_views), page_top + legend_line * (entries + 1));
    legend_left_ = right + between_views;
    text_ = fmt::format(
        "# Draw again with:  gnuplot {0}.gp   and   gnuplot -e \"format='png'\" {0}.gp\nset encoding utf8\n"
        "if (!exists('format')) format = 'svg'\n"
        "if (format eq 'png') set terminal pngcairo enhanced size {1:.0f},{2:.0f} font 'sans-serif,13' background "
        "'#ffffff'; else set terminal svg enhanced size {1:.0f},{2:.0f} font 'sans-serif,13' background '#ffffff'\n"
        "set output '{0}.'.format\nset multiplot\n",
        stem, width_, height_);
    add("set label 1 {} noenhanced at screen {:.5f}, screen {:.5f} left font ',14'\n",
        gnuplot_quoted(shortened(picture.title, static_cast<std::size_t>(width_ / letter) - 4)), between_views / width_,
        1 - 22 / height_);
    for (const View& view : views) draw(view);
    legend();
    text_ += "unset multiplot\n";
  }
  std::string take() { return std::move(text_); }

 private:
  template <typename... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  double legend_width() const {
    std::size_t longest = 0;
    for (const std::string& body : picture_.bodies) longest = std::max(longest, text_width(body));
    for (const SolidMark& mark : picture_.marks) longest = std::max(longest, text_width(mark.name));
    return symbol + letter * static_cast<double>(std::min(longest, longest_entry));
  }

  std::vector<View> solid_views() const {
    const Vector3 front(1.0, -1.4, 0.9);
    const int n = static_cast<int>(picture_.bodies.size());
    std::vector<View> views;
    for (int row = 0; row <= (n > 1 ? std::min(n, alone) : 0); ++row)
      for (int column = 0; column < 2; ++column)
        views.push_back({Camera::from(column == 0 ? front : Vector3(-front)), row - 1,
                         between_views + column * (view_width + between_views),
                         page_top + row * (view_height + between_views), view_width, view_height});
    return views;
  }

  std::vector<View> flat_view() const {
    const auto [low, high] = box(View{Camera::along_z()});
    const double ratio = (high.y() - low.y()) / std::max(high.x() - low.x(), 1e-300);
    const double width = std::clamp(flat_height / std::max(ratio, 1e-6), 160.0, flat_width);
    return {
        {Camera::along_z(), -1, edge + between_views, page_top, width, std::clamp(width * ratio, 120.0, flat_height)}};
  }

  std::pair<Eigen::Vector2d, Eigen::Vector2d> box(const View& view) const {
    Eigen::AlignedBox2d all;
    for (const Facet& facet : picture_.facets)
      if (view.shows(facet.body))
        for (const Vector3& corner : facet.corners)
          all.extend(Eigen::Vector2d(view.camera.x(corner), view.camera.y(corner)));
    if (all.isEmpty()) return {{0, 0}, {1, 1}};
    const double margin = air * std::max(all.diagonal().norm(), 1e-300);
    return {all.min().array() - margin, all.max().array() + margin};
  }

  void draw(const View& view) {
    auto [low, high] = box(view);
    // The same scale along both axes.
    const double scale = std::max((high.x() - low.x()) / view.width, (high.y() - low.y()) / view.height);
    const Eigen::Vector2d middle = (low + high) / 2, half(scale * view.width / 2, scale * view.height / 2);
    low = middle - half;
    high = middle + half;
    add("\nset lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\nset bmargin at "
        "screen {:.5f}\nset xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\nunset object\nunset arrow\n",
        view.left / width_, (view.left + view.width) / width_, 1 - view.from_top / height_,
        1 - (view.from_top + view.height) / height_, low.x(), high.x(), low.y(), high.y());
    if (picture_.flat) {
      const std::string unit = picture_.length_unit.empty() ? "" : " (" + picture_.length_unit + ")";
      add("set border 3 linecolor rgb '#404040'\nset tics nomirror\nset xtics {:g}\nset xlabel {}\nset ylabel {}\n",
          step_for(scale * width_of_number), gnuplot_quoted("x" + unit), gnuplot_quoted("y" + unit));
    } else {
      text_ += "unset border\nunset tics\n";
      axes(view.camera, low, high);
    }
    facets(view);
    const std::string lines = marked_lines(view);
    text_ += "plot NaN notitle";
    text_ += lines;
    text_ += "\nunset label\n";
  }

  /// The directions of x, y and z in the lower left corner.
  void axes(const Camera& camera, const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    const double length = 0.09 * (high.y() - low.y());
    const Eigen::Vector2d origin = low + Eigen::Vector2d(1.3 * length, 1.3 * length);
    const std::array<const char*, 3> names{"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
      const Vector3 axis = Vector3::Unit(i);
      const Eigen::Vector2d along(camera.x(axis), camera.y(axis));
      const Eigen::Vector2d tip = origin + length * along, name = origin + 1.3 * length * along;
      add("set arrow from {:.9g},{:.9g} to {:.9g},{:.9g} size screen 0.008,20 filled linecolor rgb '#404040'\n",
          origin.x(), origin.y(), tip.x(), tip.y());
      add("set label {} '{}' at {:.9g},{:.9g} center font ',11'\n", 10 + i, names[i], name.x(), name.y());
    }
  }

  void facets(const View& view) {
    struct Seen {
      const Facet* facet;
      double depth, brightness;
    };
    std::vector<Seen> seen;
    for (const Facet& facet : picture_.facets) {
      if (!view.shows(facet.body)) continue;
      const Vector3 normal = normal_of(facet.corners);
      if (!picture_.flat && normal.dot(view.camera.eye) <= 0) continue;
      seen.push_back({&facet, view.camera.eye.dot(middle_of(facet.corners)), view.camera.brightness(normal)});
    }
    std::ranges::stable_sort(seen, {}, &Seen::depth);
    for (const auto& [facet, depth, brightness] : seen) {
      const Color color = facet->mark >= 0 ? color_of_mark(picture_, facet->mark) : color_of_body(facet->body);
      const std::string fill = text_of(color, brightness);
      text_ += "set object polygon from ";
      for (const Vector3& corner : facet->corners)
        add("{:.7g},{:.7g} to ", view.camera.x(corner), view.camera.y(corner));
      add("{:.7g},{:.7g} fillstyle solid border linecolor rgb '{}' linewidth 0.4 fillcolor rgb '{}'\n",
          view.camera.x(facet->corners.front()), view.camera.y(facet->corners.front()),
          seen.size() <= with_mesh ? text_of(color, 0.62 * brightness) : fill, fill);
    }
  }

  /// Their data, and the parts of the plot command.
  std::string marked_lines(const View& view) {
    std::string parts;
    for (int mark = 0; mark < static_cast<int>(picture_.marks.size()); ++mark) {
      std::string segments, points;
      for (const MarkedLine& line : picture_.lines) {
        if (line.mark != mark || !view.shows(line.body)) continue;
        std::string& into = line.corners.size() > 1 ? segments : points;
        for (const Vector3& corner : line.corners)
          into += fmt::format("{:.9g} {:.9g}\n", view.camera.x(corner), view.camera.y(corner));
        if (line.corners.size() > 1) into += "\n";
      }
      const std::string color = text_of(color_of_mark(picture_, mark));
      if (!segments.empty()) {
        add("$lines{} << EOD\n{}EOD\n", mark, segments);
        parts += fmt::format(", $lines{} using 1:2 with lines linewidth {} linecolor rgb '{}' notitle", mark,
                             width_of_mark(picture_, mark), color);
      }
      if (!points.empty()) {
        add("$points{} << EOD\n{}EOD\n", mark, points);
        parts += fmt::format(", $points{} using 1:2 with points pointtype 7 pointsize 1.2 linecolor rgb '{}' notitle",
                             mark, color);
      }
    }
    return parts;
  }

  /// In a plot of its own, which has the height of the page.
  void legend() {
    add("\nset lmargin at screen 0\nset rmargin at screen 1\nset tmargin at screen 1\nset bmargin at screen 0\nunset "
        "object\nunset arrow\nunset border\nunset tics\nunset xlabel\nunset ylabel\nset key at screen {:.5f}, screen "
        "{:.5f} top left Left reverse noenhanced samplen 1 spacing 1.2\nplot NaN notitle",
        legend_left_ / width_, 1 - page_top / height_);
    const auto entry = [&](const std::string& name, const Color& color) {
      add(", NaN with points pointtype 5 pointsize 2 linecolor rgb '{}' title {}", text_of(color),
          gnuplot_quoted(shortened(name, longest_entry)));
    };
    for (int body = 0; body < static_cast<int>(picture_.bodies.size()); ++body)
      entry(picture_.bodies[body], color_of_body(body));
    for (int mark = 0; mark < static_cast<int>(picture_.marks.size()); ++mark)
      entry(picture_.marks[mark].name, color_of_mark(picture_, mark));
    text_ += "\n";
  }

  const SolidPicture& picture_;
  double width_ = 0, height_ = 0, legend_left_ = 0;
  std::string text_;
};

}  // namespace

std::string gnuplot_script(const SolidPicture& picture, const std::string& stem) {
  return Script(picture, stem).take();
}

void draw(const SolidPicture& picture, const std::filesystem::path& directory, const std::string& stem) {
  std::error_code failure;
  std::filesystem::create_directories(directory, failure);
  if (failure) throw ConfigError(fmt::format("directory for pictures '{}': {}", directory.string(), failure.message()));
  const GnuplotDrawing drawing({stem, gnuplot_script(picture, stem), ""}, directory);
  drawing.draw(PictureFormat::svg);
  drawing.draw(PictureFormat::png);
}

}  // namespace creepcontact::plot
