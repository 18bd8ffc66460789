/// The configuration that `creepcontact faces --propose` writes.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "creepcontact/config/writer.hpp"
#include "creepcontact/run/faces.hpp"
#include "creepcontact/settings/mesh_formats.hpp"

namespace creepcontact::run {
namespace {

using model::ModelFaces;

/// Pairs of faces that make one contact: of the same two bodies and about the same shape.
struct ProposedContact {
  std::array<std::string, 2> bodies;
  std::string suffix;  // of names: "_2"
  std::array<std::set<int>, 2> faces;
  std::vector<const mesh::FacingPatches*> pairs;
  std::string doubt;  // empty if one of the pairs has none

  std::string name() const { return fmt::format("{}_{}{}", bodies[0], bodies[1], suffix); }
};

bool is_one_shape(const mesh::SurfaceShape& a, const mesh::SurfaceShape& b, double size) {
  constexpr double same = 1e-4;
  if (a.kind != b.kind || a.is_hollow != b.is_hollow) return false;
  if (a.kind == mesh::ShapeKind::other) return false;
  if (std::abs(a.radius - b.radius) > same * size || a.axis.cross(b.axis).norm() > same) return false;
  const Vector3 arm = b.center - a.center;
  if (a.kind == mesh::ShapeKind::plane) return a.axis.dot(b.axis) > 0 && std::abs(a.axis.dot(arm)) <= same * size;
  if (a.kind == mesh::ShapeKind::sphere || a.kind == mesh::ShapeKind::torus) return arm.norm() <= same * size;
  return (arm - a.axis.dot(arm) * a.axis).norm() <= same * size;
}

std::vector<ProposedContact> contacts_of(const ModelFaces& faces) {
  std::vector<ProposedContact> result;
  std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> of_bodies;
  std::set<std::string> names;
  for (const mesh::FacingPatches& pair : faces.pairs) {
    const mesh::SurfacePatch &a = faces.patches[pair.first], &b = faces.patches[pair.second];
    const bool is_forth = std::ranges::find(faces.regions, a.body) < std::ranges::find(faces.regions, b.body);
    const mesh::SurfacePatch &first = is_forth ? a : b, &second = is_forth ? b : a;
    std::vector<std::size_t>& known = of_bodies[{first.body, second.body}];
    const std::string doubt = model::doubt(pair, faces);
    const auto same = std::ranges::find_if(known, [&](std::size_t i) {
      const mesh::FacingPatches& other = *result[i].pairs.front();
      const mesh::SurfacePatch &c = faces.patches[other.first], &d = faces.patches[other.second];
      const mesh::SurfacePatch &of_first = c.body == first.body ? c : d, &of_second = c.body == first.body ? d : c;
      return (of_first.number == first.number || is_one_shape(of_first.shape, first.shape, faces.size)) &&
             (of_second.number == second.number || is_one_shape(of_second.shape, second.shape, faces.size)) &&
             result[i].doubt.empty() == doubt.empty();
    });
    const std::size_t index = same == known.end() ? result.size() : *same;
    if (index == result.size()) {
      known.push_back(index);
      ProposedContact& made = result.emplace_back();
      made.bodies = {first.body, second.body};
      for (int i = 2; !names.insert(made.name()).second; ++i) made.suffix = fmt::format("_{}", i);
      made.doubt = doubt;
    }
    ProposedContact& contact = result[index];
    contact.faces[0].insert(first.number);
    contact.faces[1].insert(second.number);
    contact.pairs.push_back(&pair);
  }
  return result;
}

std::string described(const ProposedContact& contact, const ModelFaces& faces) {
  double area = 0, sum = 0, angle = 0, least = std::numeric_limits<double>::infinity(), largest = -least;
  bool is_exact = true;
  for (const mesh::FacingPatches* pair : contact.pairs) {
    area += pair->area;
    sum += pair->area * pair->mean;
    angle += pair->area * pair->angle;
    least = std::min(least, pair->least);
    largest = std::max(largest, pair->largest);
    is_exact = is_exact && pair->is_exact;
  }
  const mesh::FacingPatches mean{.first = 0,
                                 .second = 0,
                                 .least = least,
                                 .largest = largest,
                                 .mean = sum / area,
                                 .area = area,
                                 .angle = angle / area,
                                 .is_exact = is_exact};
  const model::Fit fit = model::fit_of(mean, faces.size);
  const std::string distance = fit == model::Fit::touching ? "touching"
                               : fit == model::Fit::gap    ? fmt::format("a gap of {:.4g}", mean.mean)
                                                           : fmt::format("an interference of {:.4g}", -mean.mean);
  const mesh::SurfaceShape& shape = faces.patches[contact.pairs.front()->first].shape;
  return fmt::format(
      "{}: {}, over an area of {:.4g}{}", mesh::name_of(shape.kind), distance, area,
      is_exact ? "" : fmt::format(", {:.2g} degrees from parallel", mean.angle * 180 / std::numbers::pi));
}

/// Sets the gap: exact ones as a number, others as measured in the mesh.
void set_gap(const ProposedContact& contact, const ModelFaces& faces, config::Contact& into) {
  const bool touches = std::ranges::all_of(contact.pairs, [&](const mesh::FacingPatches* pair) {
    return model::fit_of(*pair, faces.size) == model::Fit::touching;
  });
  if (touches) return;
  constexpr double same = 1e-6;
  const mesh::FacingPatches& first = *contact.pairs.front();
  const bool is_constant = std::ranges::all_of(contact.pairs, [&](const mesh::FacingPatches* pair) {
    return pair->is_exact && pair->least == pair->largest && std::abs(pair->mean - first.mean) <= same * faces.size;
  });
  if (is_constant)
    into.gap = std::stod(fmt::format("{:.6g}", first.mean));
  else
    into.geometric_gap = true;
}

config::Reference named(const std::string& name) {
  return {.name = name, .location = {}};
}

}  // namespace

std::string units_with_length(const std::string& unit) {
  if (unit == "mm") return "mm, N, MPa, h, degC";
  return unit == "m" ? "m, N, Pa, h, degC" : unit + ", MPa, h, degC";
}

std::string proposed_configuration(const ModelFaces& faces, const std::filesystem::path& mesh_file,
                                   const std::filesystem::path& file, const config::Vocabulary& vocabulary) {
  const bool is_cad = settings::is_cad_file(mesh_file.extension().string());
  config::Config config;
  config::Comments comments;
  config.file = file;
  config.mesh.file = mesh_file;
  config.units = units_with_length(faces.unit.empty() ? "mm" : faces.unit);
  comments.above[""] =
      "Proposed by `creepcontact faces`: delete what is not wanted; add materials, supports and loads.\n"
      "`creepcontact list keys` has all keys.";
  if (is_cad) {
    config.mesh.size = std::stod(fmt::format("{:.2g}", faces.size / 25));
    comments.above["mesh.size"] = fmt::format(
        "sizes = [{{ on = \"a surface\", size = {:.2g} }}]\n"
        "cut = [{{ axis = \"x\", keep = \"+\" }}] is a plane of symmetry; its faces are the surface cut_x.",
        faces.size / 100);
  }
  for (const std::string& region : faces.regions) {
    config::Body& body = config.bodies.emplace_back();
    body.name = region;
    body.region = {named(region)};
    body.material = named("steel");
  }
  config::Material& steel = config.materials.emplace_back();
  steel.name = "steel";
  steel.young_modulus = faces.unit == "m" ? 2.06e11 : 2.06e5;
  steel.poisson_ratio = 0.3;
  comments.above["materials.steel"] =
      "`creepcontact list materials` shows data of the literature, which use = \"...\" takes.";
  std::string doubtful;
  for (const ProposedContact& contact : contacts_of(faces)) {
    config::Contact made;
    made.name = contact.name();
    std::array<config::Surface, 2> surfaces;
    for (std::size_t side = 0; side < 2; ++side) {
      surfaces[side].name = fmt::format("{}_to_{}{}", contact.bodies[side], contact.bodies[1 - side], contact.suffix);
      surfaces[side].faces = {contact.faces[side].begin(), contact.faces[side].end()};
      made.between[side] = named(surfaces[side].name);
    }
    set_gap(contact, faces, made);
    const std::string words = described(contact, faces);
    if (!contact.doubt.empty()) {
      doubtful += fmt::format(
          "\n{}; {}.\n[surfaces.\"{}\"]\nfaces = [{}]\n[surfaces.\"{}\"]\nfaces = [{}]\n[[contacts]]\nname = \"{}\"\n"
          "between = [\"{}\", \"{}\"]\ngap = {}\n",
          words, contact.doubt, surfaces[0].name, fmt::join(contact.faces[0], ", "), surfaces[1].name,
          fmt::join(contact.faces[1], ", "), contact.name(), surfaces[0].name, surfaces[1].name,
          made.geometric_gap ? "\"geometric\"" : made.gap.text());
      continue;
    }
    for (config::Surface& surface : surfaces) config.surfaces.push_back(surface);
    comments.above[fmt::format("contacts[{}]", config.contacts.size())] = words;
    config.contacts.push_back(made);
  }
  config.time.end = 1e5;
  comments.above["time"] =
      "[[supports]]\non = \"a surface\"\ndisplacement = { normal = 0 }\n\n[[loads]]\non = \"a surface\"\npressure = "
      "10" +
      (doubtful.empty() ? "" : "\n\nPairs of faces that may be no contacts:\n" + doubtful);
  config::complete(config, vocabulary);
  return config::to_toml(config, vocabulary, comments);
}

}  // namespace creepcontact::run
