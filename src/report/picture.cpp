#include "creepcontact/report/picture.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "assets.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/base/units.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/platform/private_directory.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "creepcontact/plot/rounded_ticks.hpp"
#include "creepcontact/plot/vtk_process.hpp"
#include "creepcontact/settings/views.hpp"
#include "engineering.hpp"
#include "fields.hpp"
#include "run_directory.hpp"
#include "surfaces.hpp"

namespace creepcontact::report {
namespace {

using Json = nlohmann::json;

/// What all pictures of a run have in common.
class Run {
 public:
  explicit Run(const std::filesystem::path& directory) : directory_(directory) {
    require_run(directory, "picture");
    if (!path_exists(directory / "fields.pvd"))
      throw ConfigError(
          fmt::format("no fields.pvd in '{}': the run wrote no fields; set output.fields = true in its "
                      "configuration and run it again",
                      directory.string()));
    entries_ = io::read_field_list(directory / "fields.pvd");
    std::erase_if(entries_, [](const io::FieldEntry& entry) { return !path_exists(entry.file); });
    if (entries_.empty()) throw ConfigError(fmt::format("'{}' has no field files yet", directory.string()));
    if (path_exists(directory / "contact.pvd")) contact_ = io::read_field_list(directory / "contact.pvd");
    if (path_exists(directory / "model.json")) record_ = io::read_model_record(directory / "model.json");
    if (path_exists(directory / "summary.json")) units_ = io::read_summary_heading(directory / "summary.json").units;
    const io::FieldFile first(entries_.front().file);
    const io::FieldMesh mesh = first.mesh();
    flat_ = is_flat(mesh);
    for (const io::TextArray& text : mesh.texts)
      if (text.name == "bodies") bodies_ = text.values;
    fields_ = fields_of(first, record_.fields);
    displacement_ = displacement_array(first);
  }

  DrawnPicture describe(const Picture& picture, Json& job) const {
    if (std::ranges::count(views(), picture.view) == 0)
      throw ConfigError(fmt::format("--view: unknown view '{}'{} (allowed: {})", picture.view,
                                    did_you_mean(picture.view, views()), fmt::join(views(), ", ")));
    const io::FieldEntry& entry = nearest(entries_, picture.time);
    DrawnPicture drawn{picture.output, "", entry.time};
    const bool is_mesh = picture.field == "mesh";
    const Field field = is_mesh ? Field{} : field_named(picture.field, fields_);
    drawn.title = is_mesh ? "Mesh" : capitalized(field.label);
    if (!is_mesh || picture.warp != 0) drawn.title += " at t = " + time_text(entry.time, time_unit());
    if (picture.warp != 0) drawn.title += ", deformation x " + engineering(picture.warp);
    const bool on_contact = field.is_on_contact && !contact_.empty();
    const std::filesystem::path& coloured = on_contact ? nearest(contact_, entry.time).file : entry.file;
    job = {{"kind", is_mesh ? "mesh" : "field"},
           {"file", std::filesystem::absolute(entry.file).string()},
           {"contact_file", on_contact ? std::filesystem::absolute(coloured).string() : ""},
           {"width", picture.width},
           {"height", picture.height},
           {"title", picture.titled ? with_plain_spaces(drawn.title) : ""},
           {"unit", field.unit},
           {"array", field.array},
           {"component", field.component},
           {"ticks", is_mesh ? Json() : Json(ticks(picture, field, coloured))},
           {"displacement", displacement_},
           {"warp", picture.warp},
           {"bodies", Json::array()},
           {"colours", Json::parse(colours())},
           {"flat", flat_},
           {"view", picture.view},
           {"section", picture.section ? Json(*picture.section) : Json()}};
    if (picture.section) drawn.title += ", cut";
    for (const std::string& name : picture.bodies) {
      const auto found = std::ranges::find(bodies_, name);
      if (found == bodies_.end())
        throw ConfigError(fmt::format("no body '{}' in the results{} (there are: {})", name,
                                      did_you_mean(name, bodies_), fmt::join(bodies_, ", ")));
      job["bodies"].push_back(found - bodies_.begin());
    }
    return drawn;
  }

 private:
  static std::string capitalized(std::string text) {
    // "von Mises" has its own capitals.
    if (!text.empty() && !text.starts_with("von ")) text[0] = static_cast<char>(std::toupper(text[0]));
    return text;
  }

  /// The font of VTK has no others.
  static std::string with_plain_spaces(std::string text) {
    for (const std::string_view space : {"\u202F", "\u00A0"})
      for (std::size_t at = 0; (at = text.find(space, at)) != std::string::npos;) text.replace(at, space.size(), " ");
    return text;
  }

  /// Round numbers over the range of the colours, whose ends are the first and the last.
  static std::vector<double> ticks(const Picture& picture, const Field& field, const std::filesystem::path& file) {
    if (picture.range) return plot::rounded_ticks(picture.range->first, picture.range->second);
    std::vector<double> values = values_of(field, io::FieldFile(file));
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) return plot::rounded_ticks(0, 1);
    const auto [low, high] = std::ranges::minmax(values);
    return plot::rounded_ticks(low, high);
  }

  static const io::FieldEntry& nearest(const std::vector<io::FieldEntry>& entries, std::optional<double> time) {
    if (!time) return entries.back();
    return *std::ranges::min_element(entries, {},
                                     [&](const io::FieldEntry& entry) { return std::abs(entry.time - *time); });
  }

  std::string time_unit() const { return unit_of(Dimension::time, units_); }

  std::filesystem::path directory_;
  std::vector<io::FieldEntry> entries_, contact_;
  io::ModelRecord record_;
  std::string units_;
  bool flat_ = false;
  std::vector<std::string> bodies_{"body"};
  std::vector<Field> fields_;
  std::string displacement_;
};

}  // namespace

const std::vector<std::string>& views() {
  static const std::vector<std::string> all(settings::views.begin(), settings::views.end());
  return all;
}

std::vector<DrawnPicture> draw_pictures(const std::filesystem::path& directory, const std::vector<Picture>& pictures) {
  const Run run(directory);
  const platform::PrivateDirectory place;
  std::vector<DrawnPicture> drawn;
  Json jobs = Json::array();
  const auto drawn_at = [&](std::size_t i) { return place.path() / fmt::format("{}.png", i); };
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    Json job;
    drawn.push_back(run.describe(pictures[i], job));
    job["output"] = drawn_at(i).string();
    jobs.push_back(std::move(job));
    const std::filesystem::path parent = pictures[i].output.parent_path();
    std::error_code failure;
    if (!parent.empty()) std::filesystem::create_directories(parent, failure);
    if (failure) throw ConfigError(fmt::format("directory {}: {}", parent.string(), failure.message()));
  }
  if (!pictures.empty()) plot::draw_by_vtk(jobs.dump(), place.path());
  // Not by the process itself, which would follow a link.
  for (std::size_t i = 0; i < pictures.size(); ++i)
    platform::replace_file(pictures[i].output, read_file(drawn_at(i)).bytes);
  return drawn;
}

}  // namespace creepcontact::report
