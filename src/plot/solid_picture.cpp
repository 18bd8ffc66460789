#include "creepcontact/plot/solid_picture.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <span>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/platform/private_directory.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "creepcontact/plot/rounded_ticks.hpp"
#include "creepcontact/plot/vtk_process.hpp"
#include "gnuplot_text.hpp"

namespace creepcontact::plot {
namespace {

using Json = nlohmann::json;

constexpr std::size_t longest_title = 90, longest_entry = 52;

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

/// Name, colour as parts of 1, width of lines.
Json entry(const std::string& name, const Color& color, double width) {
  return {shortened(name, longest_entry), {color[0] / 255, color[1] / 255, color[2] / 255}, width};
}

/// The points of all cells, and the cells by their numbers.
class Cells {
 public:
  void add(Json& cells, int body, int mark, const std::vector<Vector3>& corners) {
    Json cell{body, mark};
    for (const Vector3& corner : corners) {
      cell.push_back(points_.size());
      points_.push_back({corner.x(), corner.y(), corner.z()});
      box_.extend(corner);
    }
    cells.push_back(std::move(cell));
  }
  Json take_points() { return std::move(points_); }
  /// Round numbers along an axis that all points lie between.
  std::vector<double> ticks(int axis) const {
    return box_.isEmpty() ? std::vector<double>{0, 1} : rounded_ticks(box_.min()[axis], box_.max()[axis]);
  }

 private:
  Json points_ = Json::array();
  Eigen::AlignedBox3d box_;
};

}  // namespace

std::string picture_job(const SolidPicture& picture, const std::filesystem::path& output) {
  Json job{{"kind", "model"},
           {"output", output.string()},
           {"title", shortened(picture.title, longest_title)},
           {"flat", picture.flat},
           {"length_unit", picture.length_unit},
           {"bodies", Json::array()},
           {"marks", Json::array()},
           {"facets", Json::array()},
           {"lines", Json::array()}};
  for (int body = 0; body < static_cast<int>(picture.bodies.size()); ++body)
    job["bodies"].push_back(entry(picture.bodies[body], color_of_body(body), 1));
  for (int mark = 0; mark < static_cast<int>(picture.marks.size()); ++mark)
    job["marks"].push_back(entry(picture.marks[mark].name, color_of_mark(picture, mark), width_of_mark(picture, mark)));
  Cells cells;
  for (const Facet& facet : picture.facets) cells.add(job["facets"], facet.body, facet.mark, facet.corners);
  for (const MarkedLine& line : picture.lines) cells.add(job["lines"], line.body, line.mark, line.corners);
  job["ticks"] = {cells.ticks(0), cells.ticks(1)};
  job["points"] = cells.take_points();
  return Json::array({job}).dump(-1, ' ', false, Json::error_handler_t::replace);
}

void draw(const SolidPicture& picture, const std::filesystem::path& file) {
  const platform::PrivateDirectory place;
  const std::filesystem::path drawn = place.path() / "picture.png";
  draw_by_vtk(picture_job(picture, drawn), place.path());
  // Not by the process itself, which would follow a link.
  platform::replace_file(file, read_file(drawn).bytes);
}

}  // namespace creepcontact::plot
