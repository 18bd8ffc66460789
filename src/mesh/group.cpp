#include <fmt/ranges.h>

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/mesh/group_kind.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mesh {
namespace {

const char* kind(int dimension) {
  return dimension < 0 ? "group" : group_kind(dimension);
}

}  // namespace

const Group& Mesh::group(const std::string& group_name, int dimension) const {
  const auto found = groups.find(group_name);
  if (found != groups.end() && (dimension < 0 || found->second.dimension == dimension)) return found->second;

  std::vector<std::string> names;
  for (const auto& [key, candidate] : groups) {
    if (dimension < 0 || candidate.dimension == dimension) names.push_back(key);
  }
  const std::string problem = found != groups.end() ? fmt::format("'{}' is a physical {}, not a {}", group_name,
                                                                  kind(found->second.dimension), kind(dimension))
                                                    : fmt::format("the mesh has no physical {} '{}'{}", kind(dimension),
                                                                  group_name, did_you_mean(group_name, names));
  throw ModelError(fmt::format("{}; there {}: {}", problem, names.size() == 1 ? "is" : "are",
                               names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

std::vector<std::int64_t> group_nodes(const Mesh& mesh, const std::string& name) {
  std::vector<std::int64_t> nodes;
  for (const CellRef& ref : mesh.group(name).cells) {
    const auto cell = mesh.blocks[ref.block].cell(ref.cell);
    nodes.insert(nodes.end(), cell.begin(), cell.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace creepcontact::mesh
