#include "creepcontact/io/msh/cad_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <utility>

#include "../file_text.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "mesher_process.hpp"
#include "msh_elements.hpp"
#include "msh_reader.hpp"

namespace creepcontact::io {
namespace {

struct CadResult {
  CadFacts facts;
  std::string mesh;  // .msh
};

/// In small letters.
std::string lower_case(std::string word) {
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

/// What the content of a file must have if it is what its name says; nullptr: nothing is known.
const char* mark_of(const std::filesystem::path& file) {
  const std::string extension = lower_case(file.extension().string());
  if (extension == ".step" || extension == ".stp") return "ISO-10303-21";
  return extension == ".brep" ? "DBRep_DrawableShape" : nullptr;
}

void require_mark(const std::filesystem::path& file) {
  constexpr std::size_t beginning = 4096;
  const char* const mark = mark_of(file);
  if (mark == nullptr) return;
  std::string head(beginning, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(beginning));
  if (head.find(mark) == std::string::npos)
    throw ModelError(
        fmt::format("{}: the content is not what the name says: it does not begin with {}", file.string(), mark));
}

CadResult run(const std::filesystem::path& file, const CadRequest& request, int order, const CadLimits& limits) {
  if (const std::string reason = why_unreadable(file); !reason.empty())
    throw ModelError(fmt::format("{}: {}", file.string(), reason));
  require_mark(file);
  const MesherRequest all{.file = file,
                          .dimension = 3,
                          .order = order,
                          .parameters = {},
                          .memory_limit_mb = limits.memory_limit_mb,
                          .trusted = false,
                          .needs_confinement = false,
                          .cad = request};
  const std::string bytes = run_mesher(all, limits.time_limit);
  const std::size_t end = bytes.find('\n');
  if (end == std::string::npos)
    throw ModelError(fmt::format("{}: creepcontact-mesher made no mesh of the CAD model", file.string()));
  return {CadFacts::from(bytes.substr(0, end)), bytes.substr(end + 1)};
}

/// The triangles of each face, as numbers of nodes.
std::map<int, std::vector<mesh::Face>> triangles(const MshContent& content) {
  std::map<std::uint64_t, std::int64_t> number_of;
  for (std::size_t i = 0; i < content.node_tags.size(); ++i)
    number_of[content.node_tags[i]] = static_cast<std::int64_t>(i);
  std::map<int, std::vector<mesh::Face>> result;
  for (const MshContent::Elements& elements : content.elements) {
    const MshElement* const element = msh_element(elements.type);
    if (elements.entity.dimension != 2 || element == nullptr || !element->cell || mesh::dimension(*element->cell) != 2)
      continue;
    const auto n = static_cast<std::size_t>(element->n_nodes);
    for (std::size_t i = 0; i + n <= elements.nodes.size(); i += n) {
      mesh::Face& face = result[elements.entity.tag].emplace_back(mesh::Face{*element->cell, {}});
      for (std::size_t k = 0; k < n; ++k) {
        const auto node = number_of.find(elements.nodes[i + k]);
        if (node == number_of.end())
          throw ModelError("the mesh of a CAD model has a cell with a node that does not exist");
        face.nodes.push_back(node->second);
      }
    }
  }
  return result;
}

}  // namespace

CadSurfaces read_cad_surfaces(const std::filesystem::path& file, CadRequest request, const CadLimits& limits) {
  request.surfaces_only = true;
  request.surfaces.clear();
  request.sizes.clear();
  request.size = 0;
  request.per_circle = 24;  // for the sake of what is measured on it
  const CadResult result = run(file, request, 1, limits);
  const MshContent content = read_msh_content(result.mesh, file.string());
  CadSurfaces surfaces{.nodes = content.nodes,
                       .patches = {},
                       .solids = result.facts.solids,
                       .n_loose = result.facts.n_loose,
                       .unit_of_file = {}};
  const std::string extension = file.extension().string();
  if (extension.size() > 1 && (extension[1] == 's' || extension[1] == 'S'))
    surfaces.unit_of_file = unit_of_step(file_text<ModelError>(file));
  std::map<int, double> areas;
  for (const CadFacts::Face& face : result.facts.faces) areas[face.number] = face.area;
  const std::map<int, std::vector<mesh::Face>> faces = triangles(content);
  for (const CadFacts::Solid& solid : result.facts.solids)
    for (const int oriented : solid.faces) {
      const auto found = faces.find(std::abs(oriented));
      if (found == faces.end() || found->second.empty()) continue;  // Gmsh gives up faces that are a line
      std::vector<mesh::Face> outward = found->second;
      if (oriented < 0)
        for (mesh::Face& face : outward) std::reverse(face.nodes.begin(), face.nodes.end());  // linear: corners alone
      mesh::SurfacePatch patch = mesh::surface_patch(found->first, solid.name, std::move(outward), content.nodes);
      patch.area = areas[found->first];
      surfaces.patches.push_back(std::move(patch));
    }
  std::ranges::stable_sort(surfaces.patches, {}, &mesh::SurfacePatch::number);
  return surfaces;
}

mesh::Mesh mesh_cad(const std::filesystem::path& file, const CadRequest& request, int order, const CadLimits& limits) {
  // Names may have any characters, those of groups in a mesh file may not.
  CadRequest numbered = request;
  numbered.surfaces.clear();
  std::map<std::string, std::string> name_of;
  for (const auto& [name, faces] : request.surfaces) {
    const std::string number = fmt::format("creepcontact surface {}", name_of.size() + 1);
    name_of[number] = name;
    numbered.surfaces[number] = faces;
  }
  mesh::Mesh mesh = read_msh(run(file, numbered, order, limits).mesh, file.string());
  for (const auto& [number, name] : name_of) {
    auto group = mesh.groups.extract(number);
    if (group.empty()) continue;
    if (mesh.groups.contains(name))
      throw ModelError(fmt::format("surface '{}': a solid of {} has that name; choose another", name, file.string()));
    group.key() = name;
    group.mapped().name = name;
    mesh.groups.insert(std::move(group));
  }
  return mesh;
}

std::string unit_of_step(std::string_view text) {
  std::set<std::string> found;
  for (std::size_t at = text.find("LENGTH_UNIT"); at != std::string_view::npos; at = text.find("LENGTH_UNIT", at + 1)) {
    // An entity ends with a semicolon, and one of several types is in brackets.
    const std::size_t begin = text.rfind(';', at), end = text.find(';', at);
    if (begin == std::string_view::npos || end == std::string_view::npos) continue;
    const std::string entity(text.substr(begin + 1, end - begin - 1));
    if (entity.size() > 1000) continue;
    std::smatch match;
    static const std::regex si(R"(SI_UNIT\s*\(\s*(?:\$|\.(\w*)\.)\s*,\s*\.(\w+)\.\s*\))"),
        other(R"(CONVERSION_BASED_UNIT\s*\(\s*'([^']*)')");
    if (std::regex_search(entity, match, other))
      found.insert(lower_case(match[1]));
    else if (std::regex_search(entity, match, si))
      found.insert(lower_case(match[1].str() + match[2].str()));
  }
  // A unit that is converted is defined by one of the SI.
  if (found.size() > 1) std::erase_if(found, [](const std::string& word) { return word.ends_with("metre"); });
  return found.size() == 1 ? *found.begin() : "";
}

}  // namespace creepcontact::io
