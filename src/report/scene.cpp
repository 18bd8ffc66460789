#include "scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/units.hpp"
#include "surfaces.hpp"

namespace creepcontact::report {
namespace {

constexpr std::int64_t nowhere = -1;

/// What the geometry of a run is before anything is left out.
struct Source {
  io::FieldMesh mesh;
  std::vector<std::string> names;    // of the bodies
  std::vector<std::size_t> body_of;  // every point
  std::vector<BodyShape> shapes;
  std::vector<Field> fields;
  std::vector<io::FieldEntry> entries;
  std::string displacement;      // name of its array; empty: none
  std::vector<bool> on_contact;  // every point; empty: not known
};

std::vector<std::string> body_names(const io::FieldMesh& mesh) {
  for (const io::TextArray& text : mesh.texts)
    if (text.name == "bodies") return text.values;
  return {"body"};
}

/// Which points are those of contact surfaces: the field files have zeros elsewhere. Points of two bodies at one place
/// are told apart by their displacements.
std::vector<bool> points_on_contact(const Source& source, const std::filesystem::path& directory) {
  if (!path_exists(directory / "contact.pvd")) return {};
  const double time = source.entries.back().time;
  for (const io::FieldEntry& entry : io::read_field_list(directory / "contact.pvd")) {
    if (entry.time != time || !path_exists(entry.file)) continue;
    const io::FieldFile surfaces(entry.file), bodies(source.entries.back().file);
    const std::string array = displacement_array(surfaces);
    if (array.empty() || source.displacement.empty()) return {};
    using Place = std::array<double, 6>;  // position, displacement
    const auto places = [](const std::vector<Vector3>& points, const std::vector<double>& moved) {
      std::vector<Place> all;
      all.reserve(points.size());
      for (std::size_t i = 0; i < points.size(); ++i)
        all.push_back({points[i][0], points[i][1], points[i][2], moved[3 * i], moved[3 * i + 1], moved[3 * i + 2]});
      return all;
    };
    const std::vector<Place> all = places(surfaces.mesh().points, surfaces.point_values(array));
    const std::set<Place> known(all.begin(), all.end());
    std::vector<bool> result;
    result.reserve(source.mesh.points.size());
    for (const Place& place : places(source.mesh.points, bodies.point_values(source.displacement)))
      result.push_back(known.contains(place));
    return result;
  }
  return {};
}

Source read_source(std::vector<io::FieldEntry> entries, const io::ModelRecord& record,
                   const std::filesystem::path& directory) {
  Source source;
  source.entries = std::move(entries);
  const io::FieldFile first(source.entries.front().file);
  source.mesh = first.mesh();
  source.names = body_names(source.mesh);
  source.body_of.assign(first.n_points(), 0);
  for (const io::FieldArray& array : first.point_arrays())
    if (array.name == "body") {
      const std::vector<double> numbers = first.point_values("body");
      for (std::size_t i = 0; i < numbers.size(); ++i)
        source.body_of[i] =
            static_cast<std::size_t>(std::clamp(numbers[i], 0.0, static_cast<double>(source.names.size() - 1)));
    }
  source.shapes = shapes(source.mesh, source.body_of, source.names.size());
  source.fields = fields_of(first, record.fields);
  source.displacement = displacement_array(first);
  source.on_contact = points_on_contact(source, directory);
  // Values along the edge of a section colour no area.
  if (is_flat(source.mesh)) std::erase_if(source.fields, [](const Field& field) { return field.is_on_contact; });
  return source;
}

/// `most` of n things, the first and the last among them, evenly spread.
std::vector<std::size_t> spread(std::size_t n, std::size_t most) {
  std::vector<std::size_t> kept;
  const std::size_t m = std::min(n, std::max<std::size_t>(most, 2));
  for (std::size_t i = 0; i < m; ++i) kept.push_back(m == 1 ? 0 : i * (n - 1) / (m - 1));
  return kept;
}

/// Points of a mesh to points of a scene.
class Numbering {
 public:
  explicit Numbering(std::size_t n) : number_(n, nowhere) {}

  std::uint32_t operator()(std::int64_t point) {
    std::int64_t& number = number_[static_cast<std::size_t>(point)];
    if (number == nowhere) {
      number = std::ssize(points_);
      points_.push_back(static_cast<std::size_t>(point));
    }
    return static_cast<std::uint32_t>(number);
  }
  const std::vector<std::size_t>& points() const { return points_; }

 private:
  std::vector<std::int64_t> number_;
  std::vector<std::size_t> points_;
};

/// Thins surfaces with too many points: each cell of a grid keeps one of its points, for each body.
class Merging {
 public:
  Merging(const Source& source, std::size_t most) : representative_(source.mesh.points.size()) {
    for (std::size_t i = 0; i < representative_.size(); ++i) representative_[i] = static_cast<std::int64_t>(i);
    std::set<std::int64_t> surface;
    for (const BodyShape& shape : source.shapes)
      for (const auto& triangle : shape.triangles) surface.insert(triangle.begin(), triangle.end());
    if (surface.size() <= most) return;
    Vector3 low = source.mesh.points.front(), high = low;
    for (const Vector3& x : source.mesh.points) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    // The surface of a body meets of the order of the square of the cells along its size.
    double size = (high - low).norm() / std::sqrt(static_cast<double>(most));
    for (bool fits = false; !fits; size *= 1.25) {
      using Cell = std::array<std::int64_t, 4>;
      std::map<Cell, std::int64_t> kept;
      for (const std::int64_t i : surface) {
        const auto point = static_cast<std::size_t>(i);
        const Vector3 at = (source.mesh.points[point] - low) / size;
        const Cell cell{static_cast<std::int64_t>(source.body_of[point]), std::llround(at[0]), std::llround(at[1]),
                        std::llround(at[2])};
        representative_[point] = kept.try_emplace(cell, i).first->second;
      }
      fits = kept.size() <= most;
    }
    merged_ = true;
  }
  bool merged() const { return merged_; }
  std::int64_t operator()(std::int64_t point) const { return representative_[static_cast<std::size_t>(point)]; }

 private:
  std::vector<std::int64_t> representative_;
  bool merged_ = false;
};

/// @returns the points of the mesh that the scene has
std::vector<std::size_t> add_geometry(const Source& source, const Detail& detail, Scene& scene) {
  const Merging merged(source, detail.points);
  Numbering number(source.mesh.points.size());
  for (std::size_t b = 0; b < source.shapes.size(); ++b) {
    SceneBody body{.name = source.names[b], .first_triangle = scene.triangles.size() / 3};
    for (const auto& triangle : source.shapes[b].triangles) {
      const std::array<std::int64_t, 3> at{merged(triangle[0]), merged(triangle[1]), merged(triangle[2])};
      if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
      for (const std::int64_t point : at) scene.triangles.push_back(number(point));
    }
    body.n_triangles = scene.triangles.size() / 3 - body.first_triangle;
    body.first_edge = scene.edges.size() / 2;
    if (!merged.merged())  // edges of elements would be edges no more
      for (const auto& edge : source.shapes[b].edges)
        for (const std::int64_t point : edge) scene.edges.push_back(number(point));
    body.n_edges = scene.edges.size() / 2 - body.first_edge;
    scene.bodies.push_back(body);
  }
  scene.n_surface = number.points().size();
  for (std::size_t b = 0; detail.volume && b < source.shapes.size(); ++b) {
    scene.bodies[b].first_tetrahedron = scene.tetrahedra.size() / 4;
    for (const auto& tetrahedron : source.shapes[b].tetrahedra)
      for (const std::int64_t point : tetrahedron) scene.tetrahedra.push_back(number(point));
    scene.bodies[b].n_tetrahedra = scene.tetrahedra.size() / 4 - scene.bodies[b].first_tetrahedron;
  }
  for (const std::size_t point : number.points())
    for (int i = 0; i < 3; ++i) scene.positions.push_back(static_cast<float>(source.mesh.points[point][i]));
  return number.points();
}

std::vector<float> picked(const std::vector<double>& values, const std::vector<std::size_t>& points,
                          std::size_t width) {
  std::vector<float> result;
  result.reserve(width * points.size());
  for (const std::size_t point : points)
    for (std::size_t c = 0; c < width; ++c) result.push_back(static_cast<float>(values[width * point + c]));
  return result;
}

std::vector<double> shown_values(const Source& source, const Field& field, const io::FieldFile& file) {
  std::vector<double> values = values_of(field, file);
  if (field.is_on_contact)
    for (std::size_t i = 0; i < source.on_contact.size(); ++i)
      if (!source.on_contact[i]) values[i] = std::numeric_limits<double>::quiet_NaN();
  return values;
}

void add_values(const Source& source, const std::vector<std::size_t>& entries, const std::vector<std::size_t>& points,
                Scene& scene) {
  scene.values.resize(scene.fields.size());
  for (const std::size_t entry : entries) {
    const io::FieldFile file(source.entries[entry].file);
    if (file.n_points() != source.mesh.points.size())
      throw ModelError(fmt::format("'{}' has another mesh than the other field files: they are of different runs",
                                   source.entries[entry].file.string()));
    scene.times.push_back(source.entries[entry].time);
    for (std::size_t f = 0; f < scene.fields.size(); ++f)
      scene.values[f].push_back(picked(shown_values(source, scene.fields[f], file), points, 1));
    if (!source.displacement.empty())
      scene.displacements.push_back(picked(file.point_values(source.displacement), points, 3));
  }
}

/// The size of packed() in bytes, as if nothing could be compressed.
double bytes(std::size_t n_points, const Scene& scene, std::size_t n_times, std::size_t n_fields) {
  const double per_time = static_cast<double>(n_points) * (6.0 + 2.0 * static_cast<double>(n_fields));
  const double raw = 12.0 * static_cast<double>(n_points) + static_cast<double>(n_times) * per_time +
                     4.0 * static_cast<double>(scene.triangles.size() + scene.edges.size() + scene.tetrahedra.size());
  return raw * 4 / 3;  // base64
}

/// Attempts from everything to little; the last ones always fit.
std::vector<Detail> details(double limit_bytes) {
  const auto points = [&](std::size_t times, std::size_t fields) {
    const double per_point = 12 + 24 + static_cast<double>(times) * (6 + 2 * static_cast<double>(fields));
    return static_cast<std::size_t>(std::max(2000.0, 0.5 * limit_bytes / per_point));
  };
  return {{true, 60, 64}, {true, 30, 64},  {true, 30, 12},
          {true, 15, 12}, {false, 60, 64}, {false, 30, 12},
          {false, 15, 8}, {false, 10, 4},  {false, 6, 4, points(6, 4)}};
}

std::string note(const Source& source, const Detail& detail, const Scene& scene) {
  std::vector<std::string> left_out;
  const bool has_volume =
      std::ranges::any_of(source.shapes, [](const BodyShape& shape) { return !shape.tetrahedra.empty(); });
  if (has_volume && !detail.volume) left_out.emplace_back("the inside of the bodies (sections show the surfaces only)");
  if (scene.times.size() < source.entries.size())
    left_out.push_back(
        fmt::format("{} of {} output times", source.entries.size() - scene.times.size(), source.entries.size()));
  if (scene.fields.size() < source.fields.size())
    left_out.push_back(
        fmt::format("{} of {} quantities", source.fields.size() - scene.fields.size(), source.fields.size()));
  if (detail.points < source.mesh.points.size())
    left_out.emplace_back("small elements of the surface, which are merged");
  if (left_out.empty()) return "";
  std::string text = "To keep this page small, it leaves out ";
  for (std::size_t i = 0; i < left_out.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == left_out.size() ? " and " : ", ", left_out[i]);
  return text + ". The field files of the run have everything (fields.pvd, for ParaView).";
}

}  // namespace

std::optional<Scene> read_scene(const std::filesystem::path& directory, const io::ModelRecord& record,
                                const std::string& units, double limit_mb) {
  if (!path_exists(directory / "fields.pvd")) return std::nullopt;
  std::vector<io::FieldEntry> entries = io::read_field_list(directory / "fields.pvd");
  std::erase_if(entries, [](const io::FieldEntry& entry) { return !path_exists(entry.file); });
  if (entries.empty()) return std::nullopt;
  const Source source = read_source(std::move(entries), record, directory);
  const double limit = 1e6 * limit_mb;
  for (const Detail& detail : details(limit)) {
    Scene scene;
    scene.flat = is_flat(source.mesh);
    scene.time_unit = unit_of(Dimension::time, units);
    scene.length_unit = unit_of(Dimension::length, units);
    const std::vector<std::size_t> kept = spread(source.entries.size(), detail.times);
    const std::vector<std::size_t> points = add_geometry(source, detail, scene);
    scene.fields.assign(source.fields.begin(), source.fields.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                           detail.fields, source.fields.size())));
    const bool is_last = detail.points != SIZE_MAX;
    if (!is_last && bytes(points.size(), scene, kept.size(), scene.fields.size()) > limit) continue;
    add_values(source, kept, points, scene);
    scene.note = note(source, detail, scene);
    return scene;
  }
  return std::nullopt;  // not reached: the last one is taken
}

double suggested_warp(const Scene& scene) {
  double largest = 0;
  for (const std::vector<float>& displacement : scene.displacements)
    for (const float component : displacement) largest = std::max(largest, std::abs(static_cast<double>(component)));
  if (!(largest > 0)) return 0;
  double size = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    float low = INFINITY, high = -INFINITY;
    for (std::size_t i = c; i < scene.positions.size(); i += 3) {
      low = std::min(low, scene.positions[i]);
      high = std::max(high, scene.positions[i]);
    }
    size = std::max(size, static_cast<double>(high - low));
  }
  const double wanted = 0.03 * size / largest;
  if (wanted <= 1) return 1;
  const double decade = std::pow(10, std::floor(std::log10(wanted)));
  return wanted >= 5 * decade ? 5 * decade : wanted >= 2 * decade ? 2 * decade : decade;
}

}  // namespace creepcontact::report
