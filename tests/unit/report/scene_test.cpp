/// Scenes from field files: every cell type has a closed surface and its volume, values arrive as they were, and a
/// limit is kept by leaving out, never by failing.

#include "../../../src/report/scene.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "../../../src/report/surfaces.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/mesh/cell_faces.hpp"

namespace creepcontact::report {
namespace {

class Directory {
 public:
  Directory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "creepcontact_scene_XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~Directory() { std::filesystem::remove_all(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A row of n unit cubes along x, hex8, two bodies: the first and the second half, without common nodes.
io::FieldMesh row_of_cubes(int n, std::vector<std::size_t>& body_of) {
  io::FieldMesh mesh;
  mesh.texts.push_back({"bodies", {"left", "right"}});
  mesh.blocks.push_back({mesh::CellType::hex8, {}});
  const int half = n / 2;
  for (std::size_t body = 0; body < 2; ++body) {
    const std::int64_t first = std::ssize(mesh.points);
    for (int i = 0; i <= n / 2; ++i)
      for (const Vector3& corner : {Vector3(0, 0, 0), Vector3(0, 1, 0), Vector3(0, 1, 1), Vector3(0, 0, 1)}) {
        mesh.points.emplace_back(corner + Vector3(i + half * static_cast<double>(body), 0, 0));
        body_of.push_back(body);
      }
    for (int i = 0; i < n / 2; ++i) {
      const std::int64_t a = first + 4 * i, b = a + 4;
      for (const std::int64_t node : {a, b, b + 1, a + 1, a + 3, b + 3, b + 2, a + 2})
        mesh.blocks[0].connectivity.push_back(node);
    }
  }
  return mesh;
}

double volume_inside(const io::FieldMesh& mesh, const BodyShape& shape) {
  double six = 0;
  for (const auto& t : shape.triangles) {
    const auto at = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(t[i])]; };
    six += at(0).dot(at(1).cross(at(2)));
  }
  return six / 6;
}

double volume_of_tetrahedra(const io::FieldMesh& mesh, const BodyShape& shape) {
  double six = 0;
  for (const auto& t : shape.tetrahedra) {
    const auto at = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(t[i])]; };
    six += std::abs((at(1) - at(0)).dot((at(2) - at(0)).cross(at(3) - at(0))));
  }
  return six / 6;
}

/// Corners of the reference cells, and mid-nodes between them.
io::FieldMesh one_cell(mesh::CellType type) {
  io::FieldMesh mesh;
  const int corners = mesh::n_corners(type);
  if (corners == 8)
    for (const Vector3& x : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(1, 1, 0), Vector3(0, 1, 0), Vector3(0, 0, 1),
                             Vector3(1, 0, 1), Vector3(1, 1, 1), Vector3(0, 1, 1)})
      mesh.points.push_back(x);
  else if (corners == 6)
    for (const Vector3& x :
         {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3(1, 0, 1), Vector3(0, 1, 1)})
      mesh.points.push_back(x);
  else
    for (const Vector3& x : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)})
      mesh.points.push_back(x);
  if (mesh::order(type) == 2)
    for (const std::array<int, 2>& edge : mesh::cell_edges(type))
      mesh.points.emplace_back(
          (mesh.points[static_cast<std::size_t>(edge[0])] + mesh.points[static_cast<std::size_t>(edge[1])]) / 2);
  if (type == mesh::CellType::hex27)
    for (const mesh::LocalFace& face : mesh::cell_faces(type)) {
      Vector3 middle = Vector3::Zero();
      for (int i = 0; i < 4; ++i)
        middle += mesh.points[static_cast<std::size_t>(face.nodes[static_cast<std::size_t>(i)])] / 4;
      mesh.points.push_back(middle);
    }
  while (std::ssize(mesh.points) < mesh::n_nodes(type)) mesh.points.emplace_back(Vector3::Constant(0.5));
  mesh::CellBlock block{type, {}};
  for (int i = 0; i < mesh::n_nodes(type); ++i) block.connectivity.push_back(i);
  mesh.blocks.push_back(block);
  return mesh;
}

TEST(Shapes, EveryVolumeCellHasItsSurfaceAndVolume) {
  for (const mesh::CellType type : mesh::volume_cell_types()) {
    SCOPED_TRACE(mesh::name(type));
    const io::FieldMesh mesh = one_cell(type);
    const BodyShape shape = shapes(mesh, std::vector<std::size_t>(mesh.points.size(), 0), 1)[0];
    const double volume = mesh::n_corners(type) == 8 ? 1.0 : mesh::n_corners(type) == 6 ? 0.5 : 1.0 / 6;
    EXPECT_NEAR(volume_inside(mesh, shape), volume, 1e-12);  // closed, outward
    EXPECT_NEAR(volume_of_tetrahedra(mesh, shape), volume, 1e-12);
    EXPECT_EQ(shape.edges.size(), mesh::cell_edges(type).size() * static_cast<std::size_t>(mesh::order(type)));
  }
}

TEST(Shapes, FacesBetweenCellsAreNoSurface) {
  std::vector<std::size_t> body_of;
  const io::FieldMesh mesh = row_of_cubes(6, body_of);
  const std::vector<BodyShape> two = shapes(mesh, body_of, 2);
  EXPECT_EQ(two[0].triangles.size(), 2U * 14U);  // of three cubes
  EXPECT_NEAR(volume_inside(mesh, two[1]), 3, 1e-12);
}

/// A scalar and displacements that are linear in place and time.
std::filesystem::path write_fields(const Directory& directory, const io::FieldMesh& mesh,
                                   const std::vector<std::size_t>& body_of, const std::vector<double>& times) {
  io::FieldWriter writer(directory.path(), "fields", mesh, "mm, h");
  for (const double t : times) {
    std::vector<double> scalar, displacement, body(body_of.begin(), body_of.end());
    for (const Vector3& x : mesh.points) {
      scalar.push_back(x[0] + 100 * t);
      for (int i = 0; i < 3; ++i) displacement.push_back(1e-3 * t * x[i]);
    }
    scalar[0] = std::numeric_limits<double>::quiet_NaN();
    writer.write(t, {{"displacement [mm]", 3, displacement}, {"von_mises [MPa]", 1, scalar}, {"body", 1, body}}, {});
  }
  return directory.path();
}

std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned buffer = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    buffer = buffer << 6U | static_cast<unsigned>(digits.find(c));
    if ((bits += 6) >= 8) bytes += static_cast<char>(buffer >> (bits -= 8) & 255U);
  }
  return bytes;
}

TEST(Scene, ArrivesAsItWasWritten) {
  const Directory directory;
  std::vector<std::size_t> body_of;
  const io::FieldMesh mesh = row_of_cubes(4, body_of);
  write_fields(directory, mesh, body_of, {0, 1, 5});
  const auto scene = read_scene(directory.path(), {}, "mm, h", 20);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->times, (std::vector<double>{0, 1, 5}));
  EXPECT_EQ(scene->note, "");
  EXPECT_EQ(scene->bodies[1].name, "right");
  EXPECT_EQ(scene->fields[0].name, "von_mises");
  EXPECT_EQ(scene->fields[0].unit, "MPa");
  EXPECT_EQ(suggested_warp(*scene), 5);

  const PackedScene pack = packed(*scene);
  const auto header = nlohmann::json::parse(pack.header);
  const std::size_t n = header["surface_points"].get<std::size_t>() + header["inner_points"].get<std::size_t>();
  EXPECT_EQ(n, mesh.points.size());
  const std::string compressed = decoded(pack.data);
  const std::size_t n_fields = header["fields"].size();
  std::size_t size = 12 * n + 4 * (scene->triangles.size() + scene->edges.size() + scene->tetrahedra.size());
  const std::size_t begin = size;
  size += (3 * 6 * n + 3) / 4 * 4;
  const std::size_t first_value = size;
  size += (3 * n_fields * 2 * n + 3) / 4 * 4;
  std::vector<unsigned char> bytes(size + 100);
  uLongf length = bytes.size();
  ASSERT_EQ(::uncompress(bytes.data(), &length, reinterpret_cast<const Bytef*>(compressed.data()), compressed.size()),
            Z_OK);
  EXPECT_EQ(length, size);
  const double low = header["fields"][0]["min"], high = header["fields"][0]["max"];
  const double largest = header["largest_displacement"];
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t t = 0; t < 3; ++t) {
      std::uint16_t code = 0;
      std::memcpy(&code, &bytes[first_value + 2 * (t * n + i)], 2);
      const float expected = scene->values[0][t][i];
      if (std::isnan(expected))
        EXPECT_EQ(code, 65535);
      else
        EXPECT_NEAR(low + code / 65534.0 * (high - low), expected, (high - low) / 65534);
      std::int16_t moved = 0;
      std::memcpy(&moved, &bytes[begin + 2 * (3 * (t * n + i))], 2);
      EXPECT_NEAR(moved / 32767.0 * largest, scene->displacements[t][3 * i], largest / 32767);
    }
}

TEST(Scene, ContactHasValuesOnItsSurfacesOnly) {
  const Directory directory;
  std::vector<std::size_t> body_of;
  const io::FieldMesh mesh = row_of_cubes(4, body_of);  // the bodies meet at x = 2, with nodes at the same places
  io::FieldMesh surface;
  surface.blocks.push_back({mesh::CellType::quad4, {0, 1, 2, 3}});
  std::vector<double> displacement, pressure(mesh.points.size(), 0.0), moved;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const double u = body_of[i] == 0 ? 0.01 : -0.01;
    displacement.insert(displacement.end(), {u, 0, 0});
    if (body_of[i] != 0 || mesh.points[i][0] != 2) continue;
    surface.points.push_back(mesh.points[i]);
    moved.insert(moved.end(), {u, 0, 0});
    pressure[i] = 5;
  }
  const std::vector<double> body(body_of.begin(), body_of.end());
  io::FieldWriter(directory.path(), "fields", mesh, "")
      .write(0, {{"displacement", 3, displacement}, {"contact_pressure", 1, pressure}, {"body", 1, body}}, {});
  io::FieldWriter(directory.path(), "contact", surface, "").write(0, {{"displacement", 3, moved}}, {});
  io::ModelRecord record;
  record.fields.push_back({"contact_pressure", "contact pressure", "", "contact_pressure", 0, true});
  const auto scene = read_scene(directory.path(), record, "", 20);
  ASSERT_EQ(scene->fields[0].name, "contact_pressure");
  std::size_t n = 0;
  for (const float value : scene->values[0][0]) {
    if (std::isnan(value)) continue;
    ++n;
    EXPECT_EQ(value, 5);
  }
  EXPECT_EQ(n, 4U);
}

TEST(Scene, ALimitIsKept) {
  const Directory directory;
  std::vector<std::size_t> body_of;
  const io::FieldMesh mesh = row_of_cubes(2000, body_of);
  std::vector<double> times;
  for (int i = 0; i < 100; ++i) times.push_back(i);
  write_fields(directory, mesh, body_of, times);
  const auto whole = read_scene(directory.path(), {}, "", 20), thin = read_scene(directory.path(), {}, "", 0.4);
  EXPECT_EQ(whole->times.size(), 60U);
  EXPECT_EQ(whole->times.front(), 0);
  EXPECT_EQ(whole->times.back(), 99);
  EXPECT_NE(whole->note.find("40 of 100 output times"), std::string::npos);
  EXPECT_FALSE(whole->tetrahedra.empty());
  EXPECT_LT(packed(*thin).data.size(), 0.4e6);
  EXPECT_TRUE(thin->tetrahedra.empty());
}

TEST(Scene, SmallElementsAreMergedAtLast) {
  const Directory directory;
  constexpr int n = 60;
  io::FieldMesh mesh;  // a plate of n x n cubes
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) mesh.points.emplace_back(i, j, 4 * k);
  mesh.blocks.push_back({mesh::CellType::hex8, {}});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const std::int64_t a = j * (n + 1) + i, c = a + n + 1, up = (n + 1) * (n + 1);
      for (const std::int64_t node : {a, a + 1, c + 1, c, a + up, a + 1 + up, c + 1 + up, c + up})
        mesh.blocks[0].connectivity.push_back(node);
    }
  write_fields(directory, mesh, std::vector<std::size_t>(mesh.points.size(), 0), {0, 1});
  const auto scene = read_scene(directory.path(), {}, "", 0.1);
  EXPECT_LE(scene->n_surface, 2000U);
  EXPECT_GT(scene->n_surface, 1000U);
  EXPECT_NE(scene->note.find("merged"), std::string::npos);
  double area = 0;
  for (std::size_t t = 0; t < scene->triangles.size(); t += 3) {
    const auto at = [&](std::size_t i) {
      const float* const x = &scene->positions[3 * scene->triangles[t + i]];
      return Vector3(x[0], x[1], x[2]);
    };
    area += (at(1) - at(0)).cross(at(2) - at(0)).norm() / 2;
  }
  const double exact = 2 * n * n + 4 * n * 4;
  EXPECT_NEAR(area / exact, 1, 0.1);
}

TEST(Scene, TagsInNamesStayText) {
  Scene scene;
  scene.title = "</script><b>";
  EXPECT_EQ(packed(scene).header.find('<'), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(packed(scene).header)["title"], "</script><b>");
}

TEST(Scene, DirectoriesWithoutFieldsHaveNone) {
  const Directory directory;
  EXPECT_FALSE(read_scene(directory.path(), {}, "", 20));
}

TEST(Scene, FilesOfAnotherMeshAreRefused) {
  const Directory directory, other;
  std::vector<std::size_t> body_of, more;
  write_fields(directory, row_of_cubes(4, body_of), body_of, {0, 1});
  const io::FieldMesh larger = row_of_cubes(6, more);
  write_fields(other, larger, more, {0, 1});
  std::filesystem::copy_file(other.path() / "fields" / "fields_0001.vtu",
                             directory.path() / "fields" / "fields_0001.vtu",
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_THROW(read_scene(directory.path(), {}, "", 20), ModelError);
}

TEST(Fields, KnownOnesComeFirstOthersAsInTheFile) {
  const Directory directory;
  std::vector<std::size_t> body_of;
  write_fields(directory, row_of_cubes(4, body_of), body_of, {0});
  const io::FieldFile file(directory.path() / "fields" / "fields_0000.vtu");
  const std::vector<Field> fields =
      fields_of(file, {{"displacement_magnitude", "displacement", "mm", "displacement", -1, false}});
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_EQ(fields[0].name, "von_mises");
  EXPECT_EQ(fields[1].name, "displacement_magnitude");
  EXPECT_EQ(displacement_array(file), "displacement [mm]");
  EXPECT_THROW(field_named("von_mise", fields), ConfigError);
}

}  // namespace
}  // namespace creepcontact::report
