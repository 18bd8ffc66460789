#include "drawings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base64.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/report/picture.hpp"

namespace creepcontact::report {
namespace {

constexpr std::size_t max_bodies = 8;  // with a mesh figure of their own

}  // namespace

void Drawings::note(const std::string& sentence) {
  if (std::ranges::find(notes_, sentence) == notes_.end()) notes_.push_back(sentence);
}

void Drawings::add(const plot::Figure& figure, const std::string& alternative, Html& page) {
  try {
    page.image(data_url("image/svg+xml", plot::svg(figure, directory_.path())), alternative);
  } catch (const ConfigError& error) {
    note(fmt::format("There are no plots: {}.", error.what()));
  }
}

void Drawings::add(const io::RecordedPlot& given, Html& page) {
  plot::Figure figure;
  figure.title = given.title;
  figure.x = {given.x_label, given.log_x};
  figure.panels.push_back({{given.y_label, given.log_y}, {}});
  for (const io::RecordedCurve& curve : given.curves)
    if (figure.panels[0].series.size() < plot::max_series && !curve.x.empty())
      figure.panels[0].series.push_back({curve.name, curve.x, curve.y});
  if (!figure.panels[0].series.empty())
    add(figure, fmt::format("{}: {} over {}", given.title, given.y_label, given.x_label), page);
}

std::vector<Drawings::Still> Drawings::stills(const RunData& run, const std::vector<Picture>& pictures) {
  std::vector<Still> result;
  try {
    const std::vector<DrawnPicture> drawn = draw_pictures(run.directory, pictures);
    for (std::size_t i = 0; i < drawn.size(); ++i)
      result.push_back({data_url("image/png", read_file(drawn[i].file).bytes), drawn[i].title,
                        pictures[i].field == "contact_pressure"});
  } catch (const Error& error) {
    note(fmt::format("There are no still pictures of the bodies: {}.", error.what()));
    result.clear();
  }
  return result;
}

std::vector<Drawings::Still> Drawings::meshes(const RunData& run) {
  if (!run.scene) return {};
  std::vector<Picture> pictures;
  std::vector<std::string> names;
  const auto add = [&](const std::vector<std::string>& bodies, const std::string& name) {
    pictures.push_back({.field = "mesh",
                        .time = run.scene->times.front(),
                        .bodies = bodies,
                        .titled = false,
                        .width = 800,
                        .height = 600,
                        .output = directory_.path() / fmt::format("mesh_{}.png", ++n_drawn_)});
    names.push_back(name);
  };
  if (run.scene->bodies.size() != 1) add({}, "Mesh of all bodies");
  for (const SceneBody& body : run.scene->bodies)
    if (names.size() < max_bodies) add({body.name}, fmt::format("Mesh of body {}", body.name));
  std::vector<Still> result = stills(run, pictures);
  for (std::size_t i = 0; i < result.size(); ++i) result[i].title = names[i];
  return result;
}

std::vector<Drawings::Still> Drawings::fields(const RunData& run) {
  if (!run.scene || run.scene->fields.empty()) return {};
  const Scene& scene = *run.scene;
  const auto known = [&](const char* name) {
    return std::ranges::any_of(run.record.fields, [&](const Field& field) { return field.name == name; }) ||
           std::ranges::any_of(scene.fields, [&](const Field& field) { return field.name == name; });
  };
  std::vector<Picture> pictures;
  const auto add = [&](const std::string& field, double time, double warp) {
    pictures.push_back({.field = field,
                        .time = time,
                        .warp = warp,
                        .titled = false,
                        .width = 1000,
                        .height = 700,
                        .output = directory_.path() / fmt::format("field_{}.png", ++n_drawn_)});
  };
  const std::string main = known("von_mises") ? "von_mises" : scene.fields.front().name;
  const double warp = suggested_warp(scene);
  add(main, scene.times.front(), warp);
  if (scene.times.size() > 1) add(main, scene.times.back(), warp);
  if (path_exists(run.directory / "contact.pvd") && known("contact_pressure"))
    add("contact_pressure", scene.times.back(), 0);
  return stills(run, pictures);
}

}  // namespace creepcontact::report
