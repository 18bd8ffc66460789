#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "creepcontact/base/error.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mesh {
namespace {

constexpr std::array kinds{"point", "curve", "surface", "volume"};

const char* kind(int dimension) {
  return dimension < 0 ? "group" : kinds[dimension];
}

/// Number of letters to insert, delete or replace (Levenshtein distance).
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/// "; did you mean 'bore'?" if one of the names differs by a third of the letters at most, else nothing.
std::string suggestion(const std::string& name, const std::vector<std::string>& names) {
  const auto nearest = std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) {
    return edit_distance(name, a) < edit_distance(name, b);
  });
  if (nearest == names.end() || 3 * edit_distance(name, *nearest) > name.size()) return "";
  return fmt::format("; did you mean '{}'?", *nearest);
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
                                                                  group_name, suggestion(group_name, names));
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
