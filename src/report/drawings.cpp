#include "drawings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "creepcontact/base/base64.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/plot/vtk_process.hpp"
#include "creepcontact/report/picture.hpp"
#include "engineering.hpp"
#include "thinning.hpp"

namespace creepcontact::report {
namespace {

constexpr std::size_t max_bodies = 8;  // with a mesh figure of their own

}  // namespace

void Drawings::note(const std::string& sentence) {
  if (std::ranges::find(notes_, sentence) == notes_.end()) notes_.push_back(sentence);
}

namespace {

/// The unit at the end of the label of an axis: "N" of "force (N)"; empty if there is none.
std::string unit_of_label(const std::string& label) {
  if (label.empty() || (label.back() != ')' && label.back() != ']')) return "";
  const std::size_t open = label.rfind(label.back() == ')' ? '(' : '[');
  return open == std::string::npos ? "" : label.substr(open + 1, label.size() - open - 2);
}

double largest_of(const plot::Panel& panel) {
  double largest = 0;
  for (const plot::Series& series : panel.series)
    for (const double value : series.y)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Gives the values of each panel with a unit the prefix that fits them. What is noise next to the other panels of this
/// unit becomes 0, with their prefix.
void scale(std::vector<plot::Panel>& panels) {
  constexpr double noise = 1e-9;
  std::map<std::string, double> largest_by_unit;
  for (const plot::Panel& panel : panels) {
    double& largest = largest_by_unit[unit_of_label(panel.y.label)];
    largest = std::max(largest, largest_of(panel));
  }
  for (plot::Panel& panel : panels) {
    const std::string unit = unit_of_label(panel.y.label);
    const double largest = largest_of(panel), of_unit = largest_by_unit[unit];
    if (unit.empty()) continue;
    const bool is_noise = largest < noise * of_unit;
    const Scale found(unit, std::array{is_noise ? of_unit : largest});
    if (!is_noise && found.factor() == 1) continue;
    std::string& label = panel.y.label;
    label.replace(label.size() - 1 - unit.size(), unit.size(), found.unit());
    for (plot::Series& series : panel.series)
      for (double& value : series.y) value = is_noise ? 0 : value * found.factor();
  }
}

}  // namespace

void Drawings::add(plot::Figure figure, const std::string& caption, Html& page) {
  figure.title.clear();
  scale(figure.panels);
  for (plot::Panel& panel : figure.panels)
    for (plot::Series& series : panel.series) series = thinned(series, figure.x.logarithmic);
  try {
    page.figure(data_url("image/svg+xml", plot::svg(figure, directory_.path())), caption, caption);
  } catch (const ConfigError& error) {
    note(fmt::format("There are no plots: {}.", error.what()));
  }
}

void Drawings::add(const io::RecordedPlot& given, Html& page) {
  plot::Figure figure;
  figure.x = {.label = given.x_label, .logarithmic = given.log_x};
  figure.panels.push_back({{given.y_label, given.log_y}, {}});
  for (const io::RecordedCurve& curve : given.curves)
    if (figure.panels[0].series.size() < plot::max_series && !curve.x.empty()) {
      figure.panels[0].series.push_back({curve.name, curve.x, curve.y});
      if (begins_fast(curve.x, curve.y)) figure.x.logarithmic = figure.x.zero_at_left = true;
    }
  if (!figure.panels[0].series.empty())
    add(std::move(figure), fmt::format("{}: {} over {}", given.title, given.y_label, given.x_label), page);
}

std::vector<Drawings::Still> Drawings::stills(const RunData& run, const std::vector<Picture>& pictures) {
  std::vector<Still> result;
  try {
    for (const DrawnPicture& drawn : draw_pictures(run.directory, pictures))
      result.push_back({data_url("image/png", read_file(drawn.file).bytes), drawn.title});
  } catch (const Error& error) {
    note(fmt::format("There are no still pictures of the bodies: {}.", error.what()));
    result.clear();
  }
  return result;
}

std::vector<Drawings::Still> Drawings::model(const RunData& run) {
  constexpr std::size_t longest = std::size_t{64} << 20;
  const std::filesystem::path file = run.directory / "model_view.json";
  if (!path_exists(file)) return {};
  // Whose directory this is, is not known: of the job that it has, only data are taken.
  const FileBytes found = read_file(file, longest);
  nlohmann::json jobs = nlohmann::json::parse(found.bytes, nullptr, false);
  if (!jobs.is_array() || jobs.size() != 1 || !jobs[0].is_object()) return {};
  const std::filesystem::path picture = directory_.path() / "model.png";
  jobs[0]["kind"] = "model";
  jobs[0]["output"] = picture.string();
  try {
    plot::draw_by_vtk(jobs.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), directory_.path());
    return {{data_url("image/png", read_file(picture).bytes), "Model with its supports, loads and contacts"}};
  } catch (const Error& error) {
    note(fmt::format("There is no picture of the model: {}.", error.what()));
    return {};
  }
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

namespace {

bool has_field(const RunData& run, const std::string& name) {
  const auto is_it = [&](const Field& field) { return field.name == name; };
  return std::ranges::any_of(run.record.fields, is_it) || (run.scene && std::ranges::any_of(run.scene->fields, is_it));
}

std::string main_field(const RunData& run) {
  return has_field(run, "von_mises") ? "von_mises" : run.scene->fields.front().name;
}

}  // namespace

std::vector<Drawings::Still> Drawings::fields(const RunData& run) {
  if (!run.scene || run.scene->fields.empty()) return {};
  const Scene& scene = *run.scene;
  const double warp = suggested_warp(scene);
  std::vector<Picture> pictures;
  const auto add = [&](const std::string& field, double time, double factor) -> Picture& {
    return pictures.emplace_back(Picture{.field = field,
                                         .time = time,
                                         .warp = factor,
                                         .titled = false,
                                         .width = 1000,
                                         .height = 700,
                                         .output = directory_.path() / fmt::format("field_{}.png", ++n_drawn_)});
  };
  for (const io::RecordedPicture& wanted : run.record.report.pictures) {
    if (wanted.field != "mesh" && !has_field(run, wanted.field)) {
      note(fmt::format("The results have no field '{}', of which the configuration wants a picture.", wanted.field));
      continue;
    }
    const bool on_contact = std::ranges::any_of(
        run.record.fields, [&](const Field& field) { return field.name == wanted.field && field.is_on_contact; });
    Picture& picture =
        add(wanted.field, wanted.time.value_or(scene.times.back()), on_contact || wanted.field == "mesh" ? 0 : warp);
    picture.section = wanted.section;
    picture.range = wanted.range;
    if (std::ranges::count(views(), wanted.view) > 0) picture.view = wanted.view;
  }
  if (!run.record.report.pictures.empty()) return stills(run, pictures);
  add(main_field(run), scene.times.front(), warp);
  if (scene.times.size() > 1) add(main_field(run), scene.times.back(), warp);
  if (path_exists(run.directory / "contact.pvd") && has_field(run, "contact_pressure"))
    add("contact_pressure", scene.times.back(), 0);
  return stills(run, pictures);
}

std::vector<Drawings::Still> Drawings::compared(const std::vector<RunData>& runs) {
  const auto has_scene = [](const RunData& run) { return run.scene && !run.scene->fields.empty(); };
  const auto first = std::ranges::find_if(runs, has_scene);
  if (first == runs.end()) return {};
  const std::string field = main_field(*first);
  std::optional<std::pair<double, double>> range;
  for (const RunData& run : runs) {
    if (!has_scene(run)) continue;
    const auto shown = std::ranges::find(run.scene->fields, field, &Field::name);
    if (shown == run.scene->fields.end()) continue;
    for (const float value : run.scene->values[static_cast<std::size_t>(shown - run.scene->fields.begin())].back()) {
      if (!std::isfinite(value)) continue;
      const double v = value;
      range = range ? std::pair(std::min(range->first, v), std::max(range->second, v)) : std::pair(v, v);
    }
  }
  if (!range || !(range->first < range->second)) return {};
  std::vector<Still> all;
  for (const RunData& run : runs) {
    if (!has_scene(run) || !has_field(run, field)) continue;
    for (Still& still : stills(run, {{.field = field,
                                    .time = run.scene->times.back(),
                                    .warp = suggested_warp(*first->scene),
                                    .range = range,
                                    .titled = false,
                                    .width = 700,
                                    .height = 560,
                                    .output = directory_.path() / fmt::format("field_{}.png", ++n_drawn_)}})) {
      still.title = fmt::format("{}: {}", run.label, still.title);
      all.push_back(std::move(still));
    }
  }
  return all;
}

}  // namespace creepcontact::report
