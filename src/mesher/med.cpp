#include "med.hpp"

#include "creepcontact/base/error.hpp"

#ifdef CREEPCONTACT_HAS_MED
#include <fmt/format.h>

// Debian's libmedc declares a function of several processes, which is not used, with types of MPI.
using MPI_Comm = void*;
using MPI_Info = void*;
#include <med.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <string_view>

#include "creepcontact/mesh/cell_faces.hpp"
#include "gmsh_content.hpp"
#include "numbered_groups.hpp"

namespace creepcontact::mesher {
namespace {

using mesh::CellType;
using Pairs = std::vector<std::array<int, 2>>;

/// A kind of cells. Corners are those of Gmsh, perhaps the other way round; the nodes between them are in the order of
/// `edges`.
struct Kind {
  med_geometry_type med;
  const char* name;
  int gmsh, dimension;
  std::optional<CellType> cell;  ///< nullopt: the program has none
};

constexpr std::array kinds{
    Kind{MED_POINT1, "POINT1", 15, 0, CellType::point1},   Kind{MED_SEG2, "SEG2", 1, 1, CellType::line2},
    Kind{MED_SEG3, "SEG3", 8, 1, CellType::line3},         Kind{MED_TRIA3, "TRIA3", 2, 2, CellType::tri3},
    Kind{MED_TRIA6, "TRIA6", 9, 2, CellType::tri6},        Kind{MED_QUAD4, "QUAD4", 3, 2, CellType::quad4},
    Kind{MED_QUAD8, "QUAD8", 16, 2, CellType::quad8},      Kind{MED_QUAD9, "QUAD9", 10, 2, CellType::quad9},
    Kind{MED_TETRA4, "TETRA4", 4, 3, CellType::tet4},      Kind{MED_TETRA10, "TETRA10", 11, 3, CellType::tet10},
    Kind{MED_HEXA8, "HEXA8", 5, 3, CellType::hex8},        Kind{MED_HEXA20, "HEXA20", 17, 3, CellType::hex20},
    Kind{MED_PENTA6, "PENTA6", 6, 3, CellType::wedge6},    Kind{MED_PENTA15, "PENTA15", 18, 3, CellType::wedge15},
    Kind{MED_TRIA7, "TRIA7", 0, 2, std::nullopt},          Kind{MED_PYRA5, "PYRA5", 7, 3, std::nullopt},
    Kind{MED_PYRA13, "PYRA13", 19, 3, std::nullopt},       Kind{MED_HEXA27, "HEXA27", 0, 3, std::nullopt},
    Kind{MED_PENTA18, "PENTA18", 0, 3, std::nullopt},      Kind{MED_POLYGON, "POLYGON", 0, 2, std::nullopt},
    Kind{MED_POLYHEDRON, "POLYHEDRON", 0, 3, std::nullopt}};

/// The edges of a cell in the order of their nodes in the file: around the first face, the other one, then between
/// them.
Pairs edges_of(CellType cell) {
  switch (mesh::n_corners(cell)) {
    case 2:
      return {{0, 1}};
    case 3:
      return {{0, 1}, {1, 2}, {2, 0}};
    case 4:
      if (mesh::dimension(cell) == 2) return {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
      return {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
    case 6:
      return {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
    case 8:
      return {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
    default:
      return {};
  }
}

/// The corners of a cell that is numbered the other way round.
std::vector<int> turned(CellType cell) {
  switch (mesh::n_corners(cell)) {
    case 3:
      return {0, 2, 1};
    case 4:
      return mesh::dimension(cell) == 2 ? std::vector{0, 3, 2, 1} : std::vector{0, 2, 1, 3};
    case 6:
      return {0, 2, 1, 3, 5, 4};
    case 8:
      return {0, 3, 2, 1, 4, 7, 6, 5};
    default:
      return {0, 1};
  }
}

/// Which node of the file is at each place of Gmsh's order. @param corners  of the file, in the order wanted
std::vector<int> places(CellType cell, const std::vector<int>& corners) {
  std::vector<int> result = corners;
  if (mesh::order(cell) == 1) return result;
  const Pairs own = edges_of(cell);
  for (const auto& [a, b] : mesh::cell_edges(cell)) {
    const auto wanted = std::minmax(corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)]);
    const auto found =
        std::ranges::find_if(own, [&](const auto& edge) { return std::minmax(edge[0], edge[1]) == wanted; });
    result.push_back(mesh::n_corners(cell) + static_cast<int>(found - own.begin()));
  }
  if (cell == CellType::quad9) result.push_back(8);
  return result;
}

std::string trimmed(const char* text, std::size_t most) {
  std::string_view view(text, std::find(text, text + most, '\0'));
  const std::size_t end = view.find_last_not_of(' ');
  return std::string(view.substr(0, end == std::string_view::npos ? 0 : end + 1));
}

class MedFile {
 public:
  explicit MedFile(const std::filesystem::path& path) : path_(path) {
    med_bool is_hdf5 = MED_FALSE, is_known = MED_FALSE;
    if (MEDfileCompatibility(path.c_str(), &is_hdf5, &is_known) < 0 || is_hdf5 == MED_FALSE)
      fail("it is damaged, or no .med file");
    if (is_known == MED_FALSE) fail("it is of a version of .med that libmedc does not know");
    id_ = MEDfileOpen(path.c_str(), MED_ACC_RDONLY);
    if (id_ < 0) fail("it is damaged, or no .med file");
  }
  ~MedFile() {
    if (id_ >= 0) MEDfileClose(id_);
  }
  MedFile(const MedFile&) = delete;
  MedFile& operator=(const MedFile&) = delete;

  io::MshContent read() {
    find_mesh();
    io::MshContent content;
    read_nodes(content);
    read_cells(content);
    if (content.elements.empty()) fail("its mesh has no cells");
    read_groups();
    if (groups_.empty())
      name_entities(content);
    else
      set_groups(groups_, content);
    return content;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const { throw ModelError(fmt::format("{}: {}", path_.string(), why)); }

  void find_mesh() {
    const med_int n = MEDnMesh(id_);
    if (n <= 0) fail("it has no mesh; fields alone make no model");
    for (int i = 1; i <= n; ++i) {
      const med_int n_axes = MEDmeshnAxis(id_, i);
      if (n_axes < 0 || n_axes > 3) fail("it is damaged: a mesh with an impossible number of axes");
      std::array<char, MED_NAME_SIZE + 1> name{};
      std::array<char, MED_COMMENT_SIZE + 1> description{};
      std::array<char, MED_SNAME_SIZE + 1> time_unit{};
      std::array<char, 3 * MED_SNAME_SIZE + 1> axes{}, units{};
      med_int space = 0, dimension = 0, n_steps = 0;
      med_mesh_type type{};
      med_sorting_type sorting{};
      med_axis_type axis_type{};
      if (MEDmeshInfo(id_, i, name.data(), &space, &dimension, &type, description.data(), time_unit.data(), &sorting,
                      &n_steps, &axis_type, axes.data(), units.data()) < 0)
        fail("it is damaged: a mesh without its description");
      if (i == 1) {
        name_ = trimmed(name.data(), name.size());
        space_ = static_cast<int>(space);
        if (type != MED_UNSTRUCTURED_MESH) fail(fmt::format("the mesh '{}' is a grid, not one of elements", name_));
        if (axis_type != MED_CARTESIAN) fail(fmt::format("the mesh '{}' has no Cartesian coordinates", name_));
        if (space_ < 2) fail(fmt::format("the mesh '{}' has {} coordinates; 2 or 3 are needed", name_, space_));
      } else {
        warn(fmt::format("{}: the first of {} meshes, '{}', is taken; '{}' is left out", path_.string(), n, name_,
                         trimmed(name.data(), name.size())));
      }
    }
  }

  med_int count(med_entity_type entity, med_geometry_type geometry, med_data_type data, med_connectivity_mode mode) {
    med_bool changes{}, transforms{};
    return MEDmeshnEntity(id_, name_.c_str(), MED_NO_DT, MED_NO_IT, entity, geometry, data, mode, &changes,
                          &transforms);
  }

  /// Numbers of families; without any all are in family 0, which has no groups.
  std::vector<med_int> families(med_entity_type entity, med_geometry_type geometry, std::size_t n) {
    std::vector<med_int> result(n, 0);
    if (count(entity, geometry, MED_FAMILY_NUMBER, MED_NODAL) != static_cast<med_int>(n)) return result;
    if (MEDmeshEntityFamilyNumberRd(id_, name_.c_str(), MED_NO_DT, MED_NO_IT, entity, geometry, result.data()) < 0)
      std::ranges::fill(result, 0);
    return result;
  }

  void read_nodes(io::MshContent& content) {
    const med_int n = count(MED_NODE, MED_NONE, MED_COORDINATE, MED_NO_CMODE);
    if (n <= 0) fail(fmt::format("the mesh '{}' has no nodes", name_));
    std::vector<med_float> coordinates(static_cast<std::size_t>(n * space_));
    if (MEDmeshNodeCoordinateRd(id_, name_.c_str(), MED_NO_DT, MED_NO_IT, MED_FULL_INTERLACE, coordinates.data()) < 0)
      fail("it is damaged: the coordinates of the nodes cannot be read");
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
      const double* const x = &coordinates[i * static_cast<std::size_t>(space_)];
      content.nodes.emplace_back(x[0], x[1], space_ > 2 ? x[2] : 0);
      content.node_tags.push_back(i + 1);
    }
    nodes_of_family_ = by_family(families(MED_NODE, MED_NONE, content.nodes.size()), 1);
  }

  static std::map<med_int, std::vector<std::uint64_t>> by_family(const std::vector<med_int>& numbers,
                                                                 std::uint64_t first) {
    std::map<med_int, std::vector<std::uint64_t>> result;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (numbers[i] != 0) result[numbers[i]].push_back(first + i);
    return result;
  }

  void read_cells(io::MshContent& content) {
    std::uint64_t next = 1;
    std::string left_out;
    for (const Kind& kind : kinds) {
      const med_int n = count(MED_CELL, kind.med, MED_CONNECTIVITY, MED_NODAL);
      if (n <= 0) continue;
      if (!kind.cell) {
        left_out += (left_out.empty() ? "" : ", ") + std::string(kind.name);
        continue;
      }
      const auto n_nodes = static_cast<std::size_t>(mesh::n_nodes(*kind.cell));
      const auto n_cells = static_cast<std::size_t>(n);
      std::vector<med_int> nodes(n_cells * n_nodes);
      if (MEDmeshElementConnectivityRd(id_, name_.c_str(), MED_NO_DT, MED_NO_IT, MED_CELL, kind.med, MED_NODAL,
                                       MED_FULL_INTERLACE, nodes.data()) < 0)
        fail(fmt::format("it is damaged: the nodes of the cells {} cannot be read", kind.name));
      for (const med_int node : nodes)
        if (node < 1 || node > static_cast<med_int>(content.nodes.size()))
          fail(fmt::format("a cell {} has the node {} of {}", kind.name, node, content.nodes.size()));
      io::MshContent::Elements& made = content.elements.emplace_back();
      made.entity = {kind.dimension, 1};
      made.type = kind.gmsh;
      std::vector<int> as_is(static_cast<std::size_t>(mesh::n_corners(*kind.cell)));
      std::iota(as_is.begin(), as_is.end(), 0);
      const std::vector<int> straight = places(*kind.cell, as_is), other = places(*kind.cell, turned(*kind.cell));
      for (std::size_t c = 0; c < n_cells; ++c) {
        const med_int* const own = &nodes[c * n_nodes];
        for (const int place : is_turned(*kind.cell, own, content.nodes) ? other : straight)
          made.nodes.push_back(static_cast<std::uint64_t>(own[place]));
        made.tags.push_back(next + c);
      }
      for (auto& [family, cells] : by_family(families(MED_CELL, kind.med, n_cells), next)) {
        std::vector<std::uint64_t>& all = cells_of_family_[family];
        all.insert(all.end(), cells.begin(), cells.end());
      }
      next += n_cells;
    }
    if (!left_out.empty()) warn(fmt::format("{}: cells that are not known are left out: {}", path_.string(), left_out));
  }

  /// Whether the volume (the area in the plane) is negative in the order of Gmsh.
  bool is_turned(CellType cell, const med_int* own, const std::vector<Vector3>& nodes) const {
    const auto at = [&](int corner) -> const Vector3& { return nodes[static_cast<std::size_t>(own[corner] - 1)]; };
    const int n = mesh::n_corners(cell);
    if (mesh::dimension(cell) == 2 && space_ == 2)
      return (at(1) - at(0)).cross(at(2) - at(0)).z() + (n == 4 ? (at(2) - at(0)).cross(at(3) - at(0)).z() : 0) < 0;
    if (mesh::dimension(cell) < 3) return false;
    const int opposite = n == 4 ? 3 : n / 2, last = n == 8 ? 3 : 2;
    return (at(1) - at(0)).cross(at(last) - at(0)).dot(at(opposite) - at(0)) < 0;
  }

  void read_groups() {
    std::map<std::string, NumberedGroup> groups;
    const med_int n = MEDnFamily(id_, name_.c_str());
    for (int i = 1; i <= n; ++i) {
      const med_int n_groups = MEDnFamilyGroup(id_, name_.c_str(), i);
      if (n_groups <= 0) continue;
      std::vector<char> names(static_cast<std::size_t>(n_groups) * MED_LNAME_SIZE + 1);
      std::array<char, MED_NAME_SIZE + 1> family_name{};
      med_int family = 0;
      if (MEDfamilyInfo(id_, name_.c_str(), i, family_name.data(), &family, names.data()) < 0)
        fail("it is damaged: a family of its groups cannot be read");
      for (std::size_t g = 0; g < static_cast<std::size_t>(n_groups); ++g) {
        const std::string name = trimmed(&names[g * MED_LNAME_SIZE], MED_LNAME_SIZE);
        NumberedGroup& group = groups[name];
        group.name = name;
        append(cells_of_family_, family, group.elements);
        append(nodes_of_family_, family, group.nodes);
      }
    }
    for (auto& [name, group] : groups)
      if (!group.nodes.empty() || !group.elements.empty()) groups_.push_back(std::move(group));
  }

  static void append(const std::map<med_int, std::vector<std::uint64_t>>& from, med_int family,
                     std::vector<std::uint64_t>& to) {
    if (const auto found = from.find(family); found != from.end())
      to.insert(to.end(), found->second.begin(), found->second.end());
  }

  std::filesystem::path path_;
  med_idt id_ = -1;
  std::string name_;
  int space_ = 3;
  std::map<med_int, std::vector<std::uint64_t>> nodes_of_family_, cells_of_family_;
  std::vector<NumberedGroup> groups_;
};

}  // namespace

io::MshContent read_med(const std::filesystem::path& file) {
  return MedFile(file).read();
}

}  // namespace creepcontact::mesher

#else

namespace creepcontact::mesher {

io::MshContent read_med(const std::filesystem::path& file) {
  throw ModelError(file.string() +
                   ": creepcontact was built without libmedc, which reads .med files; build it where libmedc-dev is "
                   "installed, or let Salome write .unv");
}

}  // namespace creepcontact::mesher

#endif
