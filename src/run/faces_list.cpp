#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "creepcontact/run/faces.hpp"

namespace creepcontact::run {
namespace {

using model::ModelFaces;
using Json = nlohmann::ordered_json;

double without_noise(double value, double size) {
  constexpr double noise = 1e-9;
  return std::abs(value) < noise * size ? 0 : value;
}

std::string position(const Vector3& x, double size) {
  return fmt::format("({:.5g}, {:.5g}, {:.5g})", without_noise(x[0], size), without_noise(x[1], size),
                     without_noise(x[2], size));
}

/// "z", "-x", or the components.
std::string direction(const Vector3& axis) {
  constexpr double same = 1e-6;
  for (Eigen::Index k = 0; k < 3; ++k)
    if (std::abs(std::abs(axis[k]) - 1) < same) return fmt::format("{}{}", axis[k] < 0 ? "-" : "", "xyz"[k]);
  return position(axis, 1000);  // components below 1e-6 are 0
}

std::string kind_of(const mesh::SurfaceShape& shape) {
  using enum mesh::ShapeKind;
  const std::string name(mesh::name_of(shape.kind));
  return shape.is_hollow && shape.kind != plane && shape.kind != other ? name + ", hollow" : name;
}

std::string measures_of(const mesh::SurfacePatch& patch, double size) {
  using enum mesh::ShapeKind;
  const mesh::SurfaceShape& shape = patch.shape;
  switch (shape.kind) {
    case plane:
      return fmt::format("normal {}, at {}", direction(shape.axis), position(patch.center, size));
    case cylinder:
      return fmt::format("radius {:.6g}, axis {} through {}", shape.radius, direction(shape.axis),
                         position(shape.center, size));
    case cone:
      return fmt::format("radii {:.6g} to {:.6g}, axis {} through {}", shape.minor_radius, shape.radius,
                         direction(shape.axis), position(shape.center, size));
    case sphere:
      return fmt::format("radius {:.6g}, centre {}", shape.radius, position(shape.center, size));
    case torus:
      return fmt::format("radii {:.6g} and {:.6g}, axis {} through {}", shape.radius, shape.minor_radius,
                         direction(shape.axis), position(shape.center, size));
    case other:
      break;
  }
  return fmt::format("at {}", position(patch.center, size));
}

const char* word_of(model::Fit fit) {
  return fit == model::Fit::touching ? "touching" : fit == model::Fit::gap ? "gap" : "interference";
}

std::string distance_of(const mesh::FacingPatches& pair, model::Fit fit) {
  if (fit == model::Fit::touching) return "touches";
  const double sign = fit == model::Fit::gap ? 1 : -1;
  if (pair.is_exact && pair.least == pair.largest) return fmt::format("{} {:.4g}", word_of(fit), sign * pair.mean);
  return fmt::format("{} about {:.2g}", word_of(fit), sign * pair.mean);
}

std::map<std::size_t, std::vector<std::string>> neighbours(const ModelFaces& faces) {
  std::map<std::size_t, std::vector<std::string>> result;
  for (const mesh::FacingPatches& pair : faces.pairs) {
    const std::string words = distance_of(pair, model::fit_of(pair, faces.size));
    for (const auto& [one, other] : {std::pair{pair.first, pair.second}, {pair.second, pair.first}})
      result[one].push_back(
          fmt::format("{}: {} of '{}'", words, faces.patches[other].number, faces.patches[other].body));
  }
  return result;
}

Json point(const Vector3& x) {
  return Json::array({x[0], x[1], x[2]});
}

}  // namespace

std::vector<FaceWords> face_words(const ModelFaces& faces) {
  std::map<std::size_t, std::vector<std::string>> next_to = neighbours(faces);
  std::vector<FaceWords> result;
  for (std::size_t p = 0; p < faces.patches.size(); ++p) {
    const mesh::SurfacePatch& patch = faces.patches[p];
    const bool is_line = mesh::dimension(patch.faces.front().type) == 1;
    result.push_back(
        {kind_of(patch.shape),
         fmt::format("{}; {} {:.4g}", measures_of(patch, faces.size), is_line ? "length" : "area", patch.area),
         std::move(next_to[p])});
  }
  return result;
}

std::string faces_text(const ModelFaces& faces, const std::string& file, std::size_t most) {
  std::string text = fmt::format("{}: {} bodies, {} faces", file, faces.regions.size(), faces.patches.size());
  if (!faces.unit.empty())
    text += fmt::format("; lengths in {}{}", faces.unit,
                        faces.unit_of_file.empty() ? "" : fmt::format(" (in the file: {})", faces.unit_of_file));
  text += '\n';
  if (faces.n_loose > 0) text += fmt::format("{} faces belong to no solid and are left out\n", faces.n_loose);
  const std::vector<FaceWords> words = face_words(faces);
  std::size_t told = 0, left_out = 0;
  for (const std::string& region : faces.regions) {
    text += fmt::format("\nbody '{}'\n", region);
    for (std::size_t p = 0; p < faces.patches.size(); ++p) {
      const mesh::SurfacePatch& patch = faces.patches[p];
      if (patch.body != region) continue;
      if (told++ >= most) {
        ++left_out;
        continue;
      }
      text += fmt::format("  {:>4}  {:<16} {}", patch.number, words[p].kind, words[p].measures);
      if (!faces.names[p].empty()) text += fmt::format("; named {}", fmt::join(faces.names[p], ", "));
      if (!words[p].next_to.empty()) text += fmt::format("; {}", fmt::join(words[p].next_to, ", "));
      text += '\n';
    }
  }
  if (left_out > 0) text += fmt::format("{} more faces are left out here; --all or --json list them\n", left_out);
  text += fmt::format("\nFaces of different bodies within {:.4g}: {} pairs\n", faces.distance, faces.pairs.size());
  const std::vector<std::size_t> narrow = model::narrow_faces(faces);
  constexpr std::size_t most_narrow = 20;
  if (!narrow.empty()) {
    text += fmt::format(
        "{} {} narrower than 0.2 % of the model, which makes many small elements; without a purpose {} "
        "better removed in the CAD program:\n",
        narrow.size(), narrow.size() == 1 ? "face is" : "faces are", narrow.size() == 1 ? "it is" : "they are");
    for (std::size_t i = 0; i < std::min(most_narrow, narrow.size()); ++i) {
      const mesh::SurfacePatch& patch = faces.patches[narrow[i]];
      text += fmt::format("  {:>4}  of '{}', {:.3g} wide, at {}\n", patch.number, patch.body,
                          2 * patch.area / patch.perimeter, position(patch.center, faces.size));
    }
    if (narrow.size() > most_narrow) text += fmt::format("  and {} more\n", narrow.size() - most_narrow);
  }
  return text;
}

std::string faces_json(const ModelFaces& faces, const std::string& file) {
  Json json{{"file", file},
            {"unit", faces.unit},
            {"unit_of_file", faces.unit_of_file},
            {"loose_faces", faces.n_loose},
            {"distance", faces.distance}};
  Json& solids = json["solids"] = Json::array();
  for (const std::string& region : faces.regions) {
    Json numbers = Json::array();
    for (const mesh::SurfacePatch& patch : faces.patches)
      if (patch.body == region) numbers.push_back(patch.number);
    solids.push_back({{"name", region}, {"faces", numbers}});
  }
  std::vector<Json> next_to(faces.patches.size(), Json::array());
  Json pairs = Json::array();
  for (const mesh::FacingPatches& pair : faces.pairs) {
    const char* const state = word_of(model::fit_of(pair, faces.size));
    const Json facts{{"state", state},          {"distance", pair.mean}, {"least", pair.least},
                     {"largest", pair.largest}, {"area", pair.area},     {"angle", pair.angle * 180 / std::numbers::pi},
                     {"exact", pair.is_exact}};
    const mesh::SurfacePatch &a = faces.patches[pair.first], &b = faces.patches[pair.second];
    Json one{{"faces", {a.number, b.number}}, {"bodies", {a.body, b.body}}};
    one.update(facts);
    one["doubt"] = model::doubt(pair, faces);
    pairs.push_back(one);
    for (const auto& [from, to] : {std::pair{pair.first, pair.second}, {pair.second, pair.first}}) {
      Json entry{{"face", faces.patches[to].number}, {"body", faces.patches[to].body}};
      entry.update(facts);
      next_to[from].push_back(entry);
    }
  }
  Json& all = json["faces"] = Json::array();
  for (std::size_t p = 0; p < faces.patches.size(); ++p) {
    const mesh::SurfacePatch& patch = faces.patches[p];
    all.push_back({{"number", patch.number},
                   {"body", patch.body},
                   {"kind", mesh::name_of(patch.shape.kind)},
                   {"hollow", patch.shape.is_hollow},
                   {"radius", patch.shape.radius},
                   {"minor_radius", patch.shape.minor_radius},
                   {"axis", point(patch.shape.axis)},
                   {"center", point(patch.shape.kind == mesh::ShapeKind::other ? patch.center : patch.shape.center)},
                   {"normal", point(patch.normal)},
                   {"area", patch.area},
                   {"box", {point(patch.box.min()), point(patch.box.max())}},
                   {"names", faces.names[p]},
                   {"next_to", next_to[p]}});
  }
  json["pairs"] = pairs;
  Json& narrow = json["narrow"] = Json::array();
  for (const std::size_t p : model::narrow_faces(faces)) narrow.push_back(faces.patches[p].number);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace creepcontact::run
