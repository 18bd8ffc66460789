#pragma once
/// The fields of a run as the interactive view of a report takes them: surfaces, and the volume where there is room,
/// with values at chosen times in small whole numbers.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/io/tables/model_record.hpp"
#include "fields.hpp"

namespace creepcontact::report {

/// How much of the fields is kept.
struct Detail {
  bool volume = true;             ///< tetrahedra, for sections
  std::size_t times = 60;         ///< at most
  std::size_t fields = 64;        ///< at most
  std::size_t points = SIZE_MAX;  ///< of the surface, about; more are merged
};

struct SceneBody {
  std::string name;
  std::size_t first_triangle = 0, n_triangles = 0;
  std::size_t first_edge = 0, n_edges = 0;
  std::size_t first_tetrahedron = 0, n_tetrahedra = 0;
};

/// Numbers of points are those of the scene: the surface first, then what is inside.
struct Scene {
  std::string title, time_unit, length_unit;
  bool flat = false;
  bool is_model = false;  ///< before the run: there is no time and no deformation
  std::vector<double> times;
  std::vector<SceneBody> bodies;
  std::size_t n_surface = 0;
  std::vector<float> positions;  ///< 3 per point
  std::vector<std::uint32_t> triangles, edges, tetrahedra;
  std::vector<Field> fields;
  std::vector<std::vector<std::vector<float>>> values;  ///< [field][time][point]
  std::vector<std::vector<float>> displacements;        ///< [time][3 point]; empty: the files have none
  std::string note;                                     ///< what was left out; may be empty

  std::size_t n_points() const { return positions.size() / 3; }
};

/// @param directory  of the run @param limit_mb  of packed(scene) @returns nullopt if the run has no field files
/// @throws ModelError naming the file that is damaged
/// Cost: reading the field files of the times kept, once or twice.
std::optional<Scene> read_scene(const std::filesystem::path& directory, const io::ModelRecord& record,
                                const std::string& units, double limit_mb);

/// A scene as the two texts of docs/report.md#format: the header in JSON, and the numbers, compressed, in base64.
struct PackedScene {
  std::string header, data;
};
/// JSON in which no "<" could end the element of the page that holds it.
std::string without_tags(const std::string& json);
PackedScene packed(const Scene& scene);

/// A deformation factor, 1, 2 or 5 times a power of ten, that makes the largest displacement some hundredths of the
/// model; 0 if nothing moves; 1 if it is visible as it is.
double suggested_warp(const Scene& scene);

}  // namespace creepcontact::report
