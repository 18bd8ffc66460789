#include "model_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <limits>
#include <map>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/units.hpp"
#include "creepcontact/model/model_faces.hpp"
#include "creepcontact/report/model_page.hpp"
#include "creepcontact/run/faces.hpp"
#include "creepcontact/settings/mesh_formats.hpp"

namespace creepcontact::cli {
namespace {

std::string in_words(const std::array<std::optional<Function>, 3>& components) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < 3; ++k)
    if (components[k]) words.push_back(fmt::format("{} = {}", "xyz"[k], components[k] -> text()));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// What the configuration does with each group, by its name.
std::map<std::string, std::vector<std::string>> uses_of(const config::Config& config) {
  std::map<std::string, std::vector<std::string>> uses;
  for (const config::Support& support : config.supports) {
    std::string what = in_words(support.displacement);
    if (support.normal) what += (what.empty() ? "" : ", ") + fmt::format("normal = {}", support.normal->text());
    if (support.along)
      what += (what.empty() ? "" : ", ") + fmt::format("along a direction = {}", support.along->text());
    uses[support.on.name].push_back("support" + (what.empty() ? "" : ": " + what));
  }
  for (const config::Load& load : config.loads)
    if (load.on.given()) {
      const auto* const pressure = std::get_if<config::Pressure>(&load.kind);
      uses[load.on.name].push_back(pressure != nullptr ? "load: pressure = " + pressure->value.text()
                                                       : "load: traction");
    }
  for (const config::Contact& contact : config.contacts)
    for (const config::Reference& side : contact.between)
      uses[side.name].push_back(fmt::format("contact '{}'", contact.name));
  for (const config::Rigid& rigid : config.rigid)
    for (const config::Reference& on : rigid.on) uses[on.name].push_back("rigid");
  for (const config::Rigid& coupling : config.coupling)
    for (const config::Reference& on : coupling.on) uses[on.name].push_back("coupling");
  for (const config::Cyclic& cyclic : config.cyclic)
    for (const config::Reference& side : cyclic.between) uses[side.name].push_back("cyclic symmetry");
  if (config.heat)
    for (const config::HeatFilm& film : config.heat->films) uses[film.on.name].push_back("film");
  return uses;
}

/// Each triangle has points of its own: a face has one colour.
class Geometry {
 public:
  Geometry(const model::ModelFaces& faces, report::ModelPage& page) : faces_(faces), page_(page) {}

  void add_body(std::size_t body, const std::string& region, const std::vector<run::FaceWords>& words,
                const std::map<std::size_t, double>& distances) {
    report::ModelPage::Body made{region, page_.triangles.size() / 3, 0, page_.edges.size() / 2, 0};
    if (page_.flat) add_area(faces_.areas[body]);
    for (std::size_t p = 0; p < faces_.patches.size(); ++p) {
      const mesh::SurfacePatch& patch = faces_.patches[p];
      if (patch.body != region) continue;
      report::ModelPage::Face face{patch.number,
                                   body,
                                   words[p].kind,
                                   words[p].measures,
                                   faces_.names[p],
                                   words[p].next_to,
                                   page_.triangles.size() / 3,
                                   0};
      const auto found = distances.find(p);
      const float distance = found == distances.end() ? no_distance : static_cast<float>(found->second);
      if (page_.flat)
        add_band(patch, distance);
      else
        add_patch(patch, distance);
      face.n_triangles = page_.triangles.size() / 3 - face.first_triangle;
      page_.faces.push_back(std::move(face));
    }
    made.n_triangles = page_.triangles.size() / 3 - made.first_triangle;
    made.n_edges = page_.edges.size() / 2 - made.first_edge;
    page_.bodies.push_back(std::move(made));
  }

 private:
  static constexpr float no_distance = std::numeric_limits<float>::quiet_NaN();
  static constexpr double band = 0.008, lift = 1e-4;  // of the size of the model

  std::uint32_t add_point(const Vector3& x, float distance) {
    for (Eigen::Index k = 0; k < 3; ++k) page_.positions.push_back(static_cast<float>(x[k]));
    page_.distances.push_back(distance);
    return static_cast<std::uint32_t>(page_.positions.size() / 3 - 1);
  }

  /// The cells of a section, whose faces are lines.
  void add_area(const std::vector<mesh::Face>& cells) {
    mesh::SurfacePatch area;
    area.faces = cells;
    add_patch(area, no_distance);
  }

  /// A line of a section as a band along it, on its inner side and before the area.
  void add_band(const mesh::SurfacePatch& patch, float distance) {
    for (const mesh::Face& edge : patch.faces) {
      const Vector3 lifted = lift * faces_.size * Vector3::UnitZ();
      const Vector3 a = faces_.nodes[static_cast<std::size_t>(edge.nodes[0])] + lifted;
      const Vector3 b = faces_.nodes[static_cast<std::size_t>(edge.nodes[1])] + lifted;
      const Vector3 inward = band * faces_.size * Vector3(a.y() - b.y(), b.x() - a.x(), 0).normalized();
      const std::array corners{add_point(a, distance), add_point(b, distance), add_point(b + inward, distance),
                               add_point(a + inward, distance)};
      for (const std::size_t k : {0, 1, 2, 0, 2, 3}) page_.triangles.push_back(corners[k]);
    }
  }

  void add_patch(const mesh::SurfacePatch& patch, float distance) {
    std::map<std::int64_t, std::uint32_t> points;
    const auto number = [&](std::int64_t node) {
      const auto found = points.find(node);
      if (found != points.end()) return found->second;
      return points.emplace(node, add_point(faces_.nodes[static_cast<std::size_t>(node)], distance)).first->second;
    };
    for (const mesh::Face& face : patch.faces) {
      const auto n = static_cast<std::size_t>(mesh::n_corners(face.type));
      for (std::size_t i = 1; i + 1 < n; ++i)
        for (const std::size_t k : {std::size_t{0}, i, i + 1}) page_.triangles.push_back(number(face.nodes[k]));
      for (std::size_t i = 0; i < n; ++i)
        if (face.nodes[i] < face.nodes[(i + 1) % n] || n == 2) {
          page_.edges.push_back(number(face.nodes[i]));
          page_.edges.push_back(number(face.nodes[(i + 1) % n]));
        }
    }
  }

  const model::ModelFaces& faces_;
  report::ModelPage& page_;
};

}  // namespace

void write_model_page(const config::Config& config, const std::filesystem::path& file) {
  const model::ModelFaces faces = model::model_faces(config, 0);
  report::ModelPage page;
  page.flat = config.analysis != settings::Analysis::solid;
  page.title = config.title.empty() ? config.mesh.file.filename().string() : config.title;
  page.length_unit = faces.unit.empty() ? unit_of(Dimension::length, config.units) : faces.unit;
  std::map<std::size_t, double> distances;
  for (const mesh::FacingPatches& pair : faces.pairs)
    for (const std::size_t p : {pair.first, pair.second}) {
      const auto [known, is_new] = distances.emplace(p, pair.mean);
      if (!is_new && std::abs(pair.mean) < std::abs(known->second)) known->second = pair.mean;
    }
  const std::vector<run::FaceWords> words = run::face_words(faces);
  Geometry geometry(faces, page);
  for (std::size_t b = 0; b < faces.regions.size(); ++b) geometry.add_body(b, faces.regions[b], words, distances);
  if (faces.pairs.empty()) page.distances.clear();
  std::map<std::string, std::vector<std::string>> uses = uses_of(config);
  std::map<std::string, std::vector<int>> groups;
  for (std::size_t p = 0; p < faces.patches.size(); ++p)
    for (const std::string& name : faces.names[p]) groups[name].push_back(faces.patches[p].number);
  for (const auto& [name, of] : uses) groups.try_emplace(name);
  for (auto& [name, numbers] : groups) page.groups.push_back({name, uses[name], numbers});
  page.notes.push_back(fmt::format(
      "{} bodies, {} faces. Faces of different bodies are next to each other within {:.4g}{}.", faces.regions.size(),
      faces.patches.size(), faces.distance, page.length_unit.empty() ? "" : " " + page.length_unit));
  if (settings::is_cad_file(config.mesh.file.extension().string()))
    page.notes.emplace_back("The mesh here is coarse and of the surfaces alone: that of the run follows from [mesh].");
  if (faces.n_loose > 0) page.notes.push_back(fmt::format("{} faces of no solid are left out.", faces.n_loose));
  report::write_model_page(page, file);
}

config::Config mesh_alone(const std::filesystem::path& file, const std::string& unit) {
  if (!settings::is_mesh_file(file.extension().string()))
    throw ConfigError(
        fmt::format("{}: neither {} nor a configuration (.toml)", file.string(), settings::mesh_files_in_words));
  config::Config config;
  config.file = file;
  config.mesh.file = file;
  config.units = run::units_with_length(unit.empty() ? "mm" : unit);
  return config;
}

}  // namespace creepcontact::cli
