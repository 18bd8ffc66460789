#include "cad.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

#include "creepcontact/base/error.hpp"

namespace creepcontact::mesher {
namespace {

using Entities = gmsh::vectorpair;

constexpr double default_size = 1.0 / 25;  // of the diagonal of the model
constexpr double beyond = 0.5;             // of the size of the model: how far a box for a cut reaches
constexpr double growth = 3;  // sizes of elements: what lies between grows within that many times the difference
constexpr int samples_of_field = 40;  // along the sides of a face, from which distances count

struct NamedSolid {
  int tag = 0;
  std::string name;
};

struct Box {
  double low[3] = {}, high[3] = {};
  double diagonal() const { return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]); }
};

Box box_of_all() {
  Box box;
  gmsh::model::getBoundingBox(-1, -1, box.low[0], box.low[1], box.low[2], box.high[0], box.high[1], box.high[2]);
  return box;
}

/// Gmsh's label is the path in the assembly: "Shapes/Assembly/Part". The words of OpenCASCADE and of IGES for a part
/// without a name are none.
std::string part_name(int tag) {
  std::string label;
  gmsh::model::getEntityName(3, tag, label);
  std::string name = label.substr(label.rfind('/') + 1);
  std::ranges::replace_if(
      name, [](unsigned char c) { return c == '"' || c < ' '; }, '_');  // no name of a group has these
  return name.starts_with("Open CASCADE") || name == "SOLID" ? "" : name;
}

/// With names that no other solid has.
std::vector<NamedSolid> solids() {
  Entities all;
  gmsh::model::getEntities(all, 3);
  std::vector<NamedSolid> result;
  std::set<std::string> known;
  for (const auto& [dimension, tag] : all) {
    std::string name = part_name(tag);
    if (name.empty()) name = fmt::format("solid_{}", result.size() + 1);
    std::string unique = name;
    for (int i = 2; !known.insert(unique).second; ++i) unique = fmt::format("{}_{}", name, i);
    result.push_back({tag, unique});
  }
  return result;
}

/// Faces of no solid, which would be meshed for nothing. @returns how many there were
int remove_loose(const io::CadFacts& facts) {
  std::set<int> used;
  for (const io::CadFacts::Face& face : facts.faces) used.insert(face.number);
  Entities faces;
  gmsh::model::getEntities(faces, 2);
  std::erase_if(faces, [&](const auto& face) { return used.contains(face.second); });
  if (faces.empty()) return 0;
  gmsh::model::occ::remove(faces, true);
  gmsh::model::occ::synchronize();
  return static_cast<int>(faces.size());
}

/// One solid after the other, so that those that touch stay apart.
std::vector<NamedSolid> cut(const std::vector<NamedSolid>& all, const io::CadCut& by) {
  Box box = box_of_all();
  const double reach = beyond * box.diagonal();
  for (int i = 0; i < 3; ++i) {
    box.low[i] -= reach;
    box.high[i] += reach;
  }
  (by.keeps_larger ? box.low : box.high)[by.axis] = by.at;
  if (!(box.low[by.axis] < box.high[by.axis])) return {};
  std::vector<NamedSolid> result;
  for (const NamedSolid& solid : all) {
    const int tool = gmsh::model::occ::addBox(box.low[0], box.low[1], box.low[2], box.high[0] - box.low[0],
                                              box.high[1] - box.low[1], box.high[2] - box.low[2]);
    Entities left;
    std::vector<Entities> parts;
    gmsh::model::occ::intersect({{3, solid.tag}}, {{3, tool}}, left, parts, -1, true, true);
    for (const auto& [dimension, tag] : left)
      if (dimension == 3) result.push_back({tag, solid.name});
  }
  gmsh::model::occ::synchronize();
  return result;
}

io::CadFacts facts_of(const std::vector<NamedSolid>& all) {
  io::CadFacts facts;
  std::set<int> known;
  for (const NamedSolid& solid : all) {
    io::CadFacts::Solid& told = facts.solids.emplace_back(io::CadFacts::Solid{solid.tag, solid.name, {}});
    Entities faces;
    gmsh::model::getBoundary({{3, solid.tag}}, faces, false, true, false);
    for (const auto& [dimension, tag] : faces) {
      told.faces.push_back(tag);
      if (!known.insert(std::abs(tag)).second) continue;
      io::CadFacts::Face& face = facts.faces.emplace_back();
      face.number = std::abs(tag);
      gmsh::model::occ::getMass(2, face.number, face.area);
    }
  }
  return facts;
}

void name_groups(const std::vector<NamedSolid>& solids, const io::CadRequest& request) {
  std::map<std::string, std::vector<int>> by_name;  // a cut may leave several pieces of one
  for (const NamedSolid& solid : solids) by_name[solid.name].push_back(solid.tag);
  int next = 0;
  for (const auto& [name, tags] : by_name) {
    gmsh::model::addPhysicalGroup(3, tags, ++next);
    gmsh::model::setPhysicalName(3, next, name);
  }
  for (const auto& [name, faces] : request.surfaces) {
    gmsh::model::addPhysicalGroup(2, faces, ++next);
    gmsh::model::setPhysicalName(2, next, name);
  }
}

std::vector<double> as_numbers(const std::vector<int>& values) {
  return {values.begin(), values.end()};
}

/// A field with the size near some faces or in some solids, and the general one elsewhere.
int size_field(const io::CadRequest::Size& given, double size) {
  namespace field = gmsh::model::mesh::field;
  if (!given.solids.empty()) {
    const int constant = field::add("MathEval");
    field::setString(constant, "F", fmt::format("{:.17g}", given.size));
    const int inside = field::add("Restrict");
    field::setNumber(inside, "InField", constant);
    field::setNumbers(inside, "VolumesList", as_numbers(given.solids));
    // What bounds the solids is meshed by itself, and first.
    Entities bounded;
    for (const int solid : given.solids) bounded.emplace_back(3, solid);
    for (const char* const list : {"SurfacesList", "CurvesList", "PointsList"}) {
      Entities bounds;
      gmsh::model::getBoundary(bounded, bounds, false, false, false);
      std::set<int> tags;
      for (const auto& [dimension, tag] : bounds) tags.insert(tag);
      field::setNumbers(inside, list, {tags.begin(), tags.end()});
      bounded = std::move(bounds);
    }
    return inside;
  }
  const int distance = field::add("Distance");
  field::setNumbers(distance, "SurfacesList", as_numbers(given.faces));
  field::setNumber(distance, "NumPointsPerCurve", samples_of_field);
  const int threshold = field::add("Threshold");
  field::setNumber(threshold, "InField", distance);
  field::setNumber(threshold, "SizeMin", given.size);
  field::setNumber(threshold, "SizeMax", size);
  field::setNumber(threshold, "DistMin", given.size);
  field::setNumber(threshold, "DistMax", given.size + growth * std::abs(size - given.size));
  return threshold;
}

/// @param n_faces  of the model: surfaces that are only looked at get coarser where there are many of them
void set_sizes(const io::CadRequest& request, std::size_t n_faces) {
  constexpr std::size_t many_faces = 300;
  constexpr int delaunay = 5;  // of Gmsh's algorithms: twice as fast as the usual one
  const double size = request.size > 0 ? request.size : default_size * box_of_all().diagonal();
  const bool is_coarse = request.surfaces_only && n_faces > many_faces;
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", is_coarse ? request.per_circle / 2 : request.per_circle);
  if (request.surfaces_only) {
    gmsh::option::setNumber("Mesh.Algorithm", delaunay);
    gmsh::option::setNumber("Mesh.Smoothing", 0);
  }
  if (request.sizes.empty()) return;
  double largest = size;
  std::vector<double> fields;
  for (const io::CadRequest::Size& given : request.sizes) {
    fields.push_back(size_field(given, size));
    largest = std::max(largest, given.size);
  }
  gmsh::option::setNumber("Mesh.MeshSizeMax", largest);
  const int least = gmsh::model::mesh::field::add("Min");
  gmsh::model::mesh::field::setNumbers(least, "FieldsList", fields);
  gmsh::model::mesh::field::setAsBackgroundMesh(least);
}

bool is_iges(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  return extension.size() > 1 && (extension[1] == 'i' || extension[1] == 'I');
}

/// OpenCASCADE makes millimetres of any IGES file; Gmsh can tell it another unit only for STEP. Most IGES files have
/// faces alone, of which a solid is made where they close.
void import_iges(const std::filesystem::path& file, double metres) {
  constexpr double read_in = 1e-3;      // metres
  constexpr double sewn_within = 1e-2;  // mm: what files of other programs leave open between faces
  gmsh::option::setNumber("Geometry.OCCScaling", read_in / metres);
  Entities all;
  gmsh::model::occ::importShapes(file.string(), all, true);
  if (std::ranges::any_of(all, [](const auto& entity) { return entity.first == 3; })) return;
  Entities sewn;
  gmsh::model::occ::healShapes(sewn, all, sewn_within * read_in / metres, true, false, false, true, true);
  gmsh::model::occ::remove(all, true);
}

}  // namespace

io::CadFacts read_cad(const std::filesystem::path& file, const io::CadRequest& request) {
  gmsh::option::setNumber("Geometry.OCCImportLabels", 1);
  Entities imported;
  if (is_iges(file)) {
    import_iges(file, request.metres);
  } else {
    gmsh::option::setString("Geometry.OCCTargetUnit", request.unit);
    gmsh::model::occ::importShapes(file.string(), imported, false);
  }
  gmsh::model::occ::synchronize();
  std::vector<NamedSolid> all = solids();
  if (all.empty()) {
    Entities faces;
    gmsh::model::getEntities(faces, 2);
    throw ModelError(
        fmt::format("the file has no solid, only {} faces: open shells enclose no material; let the CAD program "
                    "make a solid of them, and write that{}",
                    faces.size(), is_iges(file) ? ", best as STEP, for several parts in IGES are faces alone" : ""));
  }
  io::CadFacts facts = facts_of(all);
  const int n_loose = remove_loose(facts);
  for (const io::CadCut& by : request.cuts) {
    all = cut(all, by);
    if (all.empty())
      throw ModelError(fmt::format("mesh.cut leaves nothing: no solid is where {} {} {:g}", "xyz"[by.axis],
                                   by.keeps_larger ? ">" : "<", by.at));
  }
  if (!request.cuts.empty()) facts = facts_of(all);
  facts.n_loose = n_loose;
  if (!request.surfaces_only) name_groups(all, request);
  set_sizes(request, facts.faces.size());
  return facts;
}

}  // namespace creepcontact::mesher
